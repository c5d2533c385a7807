/** Values that are not slid: typed as a number, or chosen by name. */
import { node } from "./parts.js";

/**
 * A number to type for a slider's control, in the unit of its value. What is beyond the range is
 * taken to its end, and `tell(words)` says so; what is no number changes nothing.
 */
export function typed({ name, label, unit, min, max, step, toPosition, toValue = Number }, touched, tell) {
  const [low, high] = [toValue(min), toValue(max)];
  const input = node("input", {
    type: "number", min: low, max: high, step: toPosition ? low : step, "aria-label": `${label}, ${unit?.long ?? "as a number"}`,
  });
  const written = (value) => String(Number(toPosition ? value.toPrecision(4) : value.toFixed(3)));
  const inRange = (value) => value >= low && value <= high;
  let now = "";
  input.addEventListener("input", () => {
    if (inRange(input.valueAsNumber)) touched({ [name]: input.valueAsNumber + 0 });
  });
  input.addEventListener("change", () => {
    const value = input.valueAsNumber;
    if (!inRange(value)) {
      if (!Number.isNaN(value)) touched({ [name]: value < low ? low : high });
      tell(Number.isNaN(value) ? `a number from ${written(low)} to ${written(high)}` : value < low ? `at least ${written(low)}` : `at most ${written(high)}`);
    }
    input.value = now;
  });
  input.addEventListener("beforeinput", (event) => {
    if (!event.data?.includes(",")) return;
    event.preventDefault(); // else some browsers drop the comma, and 0,5 is 5
    document.execCommand("insertText", false, event.data.replace(",", "."));
  });
  input.addEventListener("wheel", () => input.blur(), { passive: true }); // the wheel scrolls the page
  return {
    text: () => now.replace("-", "−") + (unit?.short ?? ""),
    element: node("span", { class: "chr-typed" }, input, node("span", { "aria-hidden": "true" }, unit?.short.trim() ?? "")),
    show(state) {
      now = written(state[name]);
      if (!input.matches(":focus")) input.value = now; // else what is being typed would jump
    },
  };
}

/** A choice between the `choices` of a control, whose value is the number of the one that is chosen. */
export function choice({ name, label, choices }, touched) {
  const select = node("select", { name }, ...choices.map((words, i) => node("option", { value: i }, words)));
  select.addEventListener("input", () => touched({ [name]: Number(select.value) }));
  return {
    element: node("label", { class: "chr-choice" }, node("span", { class: "chr-caption" }, label), select),
    atStep: () => ({ [name]: Number(select.value) }),
    show: (state) => (select.value = state[name]),
  };
}

/** Buttons to the values of a slider that matter; a key has the slider itself. */
export function stops({ name, stops: places }, go) {
  const buttons = places.map(([value, text]) => {
    const button = node("button", { type: "button", tabindex: -1 }, text);
    button.addEventListener("click", () => go({ [name]: value }));
    return button;
  });
  return {
    element: node("span", { class: "chr-stops" }, ...buttons),
    show: (state) => buttons.forEach((button, i) => button.setAttribute("aria-pressed", state[name] === places[i][0])),
  };
}
