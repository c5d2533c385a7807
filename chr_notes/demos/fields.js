/** Fields that numbers are typed or pasted into, and buttons. */
import { node } from "./parts.js";

/**
 * A field of some rows for what is called `kind`. `typed(kind, text, pasted)` follows what is written
 * in it; `pasted` says that the whole of it was pasted, and may be taken for another kind.
 */
export function field(kind, typed, rows) {
  const name = node("span", { class: "chr-name" });
  const input = node("textarea", { name: kind, rows, spellcheck: "false", autocomplete: "off", autocapitalize: "off" });
  let whole = false;
  input.addEventListener("beforeinput", () => (whole = input.selectionStart === 0 && input.selectionEnd === input.value.length));
  input.addEventListener("input", ({ inputType }) => typed(kind, input.value, whole && inputType === "insertFromPaste"));
  return { name, input, element: node("label", { class: "chr-field", "data-kind": kind }, name, input) };
}

export function button(name, text, pressed) {
  const element = node("button", { type: "button", name }, text);
  element.addEventListener("click", pressed);
  return element;
}
