/** Buttons that copy a state: as an address, and as a call of the class in Python. */
import { node } from "./parts.js";

const THANKS = 1500; // milliseconds for which a button says what it did

/** The buttons of a demo; `linkTo(state)` gives the address of a state, where pages have one. */
export function copying({ python, start }, linkTo, current, live) {
  const written = (value) => (typeof value === "string" ? JSON.stringify(value) : Number(value.toPrecision(15)));
  const said = (state) => Object.keys(start).filter((name) => state[name] !== "");
  const call = (state) => `${python}(${said(state).map((name) => `${name}=${written(state[name])}`).join(", ")})`;
  const ways = [
    ...(linkTo ? [["link", "Copy link", linkTo]] : []),
    ["python", "Copy as Python", call],
  ];
  return ways.map(([name, words, text]) => {
    const button = node("button", { type: "button", name }, words);
    button.addEventListener("click", async () => {
      const done = await copied(text(current()));
      button.textContent = done ? "Copied" : "Not copied";
      live.textContent = button.textContent;
      setTimeout(() => (button.textContent = words), THANKS);
    });
    return button;
  });
}

/** Put a text on the clipboard, also where only the old way is allowed. */
export async function copied(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const before = document.activeElement;
    const area = node("textarea", { class: "chr-live", "aria-hidden": "true" }, text);
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    before?.focus();
    return done;
  }
}
