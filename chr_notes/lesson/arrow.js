/* An arrow to drag, to move by keys, or to give as a number: what it writes goes into the answer box. */

const arrowIn = (box, number) => {
  const { names, start, sense, outline } = JSON.parse(box.dataset.plane);
  const input = box.querySelector("input");
  const part = (name, attributes, ...children) => {
    const each = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) each.setAttribute(key, value);
    each.append(...children);
    return each;
  };
  const on = (angle, radius) => {
    const turned = ((start + sense * angle) * Math.PI) / 180;
    return [radius * Math.sin(turned), -radius * Math.cos(turned)].map((value) => value.toFixed(1));
  };
  const wrapped = (angle) => ((((angle + 180) % 360) + 360) % 360) - 180 || 0;
  const label = (name, i) => {
    const [x, y] = on(sense * (90 * i - start), i % 2 ? 122 : 112);
    return part("text", { x, y, "text-anchor": "middle", "dominant-baseline": "central" }, name);
  };
  const ticks = Array.from({ length: 36 }, (_, i) => `M${on(10 * i, i % 9 ? 92 : 84)}L${on(10 * i, 96)}`);
  const shaft = part("path", { class: "chr-shaft" });
  const grip = part("circle", { class: "chr-grip", r: 30 });
  const svg = part("svg", {
    class: "chr-arrow", viewBox: "-152 -125 304 250", role: "slider", tabindex: 0,
    "aria-label": input.getAttribute("aria-label"), "aria-valuemin": -180, "aria-valuemax": 180,
    "data-lm-suppress-shortcuts": "true",
  }, part("path", { class: "chr-outline", d: outline, transform: "translate(-100 -100)" }),
  part("circle", { r: 96 }), part("path", { d: ticks.join("") }), ...names.map(label), shaft, grip);

  let angle = 0;
  const show = (to) => {
    angle = wrapped(to);
    const tip = on(angle, 66);
    shaft.setAttribute("d", `M0 0L${tip}M${on(angle - 14, 50)}L${tip}L${on(angle + 14, 50)}`);
    grip.setAttribute("cx", tip[0]);
    grip.setAttribute("cy", tip[1]);
    const near = names.map((name, i) => [Math.abs(wrapped(sense * (90 * i - start) - angle)), name]).sort((a, b) => a[0] - b[0]);
    const words = near[0][0] < 1 ? near[0][1] : `between ${near[0][1]} and ${near[1][1]}`;
    svg.setAttribute("aria-valuenow", Math.round(angle));
    svg.setAttribute("aria-valuetext", `${Math.round(angle)}°, ${words}`);
  };
  const put = (to) => {
    show(Math.round(to));
    input.value = `${angle}°`;
  };
  const point = (event) => {
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    if (Math.hypot(x, y) > 8) put(sense * ((Math.atan2(x, -y) * 180) / Math.PI - start));
  };

  // A finger that only passes scrolls the page: it drags by the tip, and elsewhere a tap counts.
  grip.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
  grip.addEventListener("pointerdown", (event) => grip.setPointerCapture(event.pointerId));
  grip.addEventListener("pointermove", (event) => { if (grip.hasPointerCapture(event.pointerId)) point(event); });
  svg.addEventListener("click", (event) => { if (event.target !== grip) point(event); });
  svg.addEventListener("keydown", (event) => {
    const steps = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 15, PageDown: -15 };
    if (Object.hasOwn(steps, event.key)) put(angle + steps[event.key]);
    else if (event.key === "Home") put(0);
    else return;
    event.preventDefault();
  });
  input.addEventListener("input", () => {
    const found = number(input.value);
    if (Number.isFinite(found)) show(found);
  });
  show(0);
  box.prepend(svg);
};
