/**
 * Demos on a page: one in every element with a `data-demo`. The state of one stands in the address,
 * `#tilt?roll=20&pitch=5`, so that it can be sent, and outlives a reload.
 */
import { node } from "./parts.js";

const WAIT = 250; // milliseconds without a change before the address follows

const written = (value) =>
  typeof value === "number" ? Number(value.toPrecision(6)) : encodeURIComponent(value).replaceAll("%2C", ",");

const hashOf = (name, state) =>
  `#${name}?${Object.entries(state).filter(([, value]) => value !== "").map(([key, value]) => `${key}=${written(value)}`).join("&")}`;

/** Which demo the address names, and with which state. */
function addressed() {
  const [name, query = ""] = location.hash.slice(1).split("?");
  return { name, state: Object.fromEntries(new URLSearchParams(query)) };
}

function mountOne(demos, element, address) {
  const name = element.dataset.demo;
  if (!(name in demos)) throw new Error(`no demo is called ${name}`);
  const meant = address.name === name;
  let timer = 0;
  demos[name](element, JSON.parse(element.dataset.state), {
    now: meant ? address.state : {},
    linkTo: (state) => location.href.split("#")[0] + hashOf(name, state),
    onChange(state) {
      clearTimeout(timer);
      timer = setTimeout(() => history.replaceState(history.state, "", hashOf(name, state)), WAIT);
    },
  });
  return meant;
}

/**
 * Beside the page's link that skips what stands before its text, one to each demo, in their order:
 * so many presses of Tab lead there, however much there is before it.
 */
function linkTo(demo) {
  const skips = document.querySelector(".skip-link");
  if (!skips || !demo) return;
  const link = node("a", { href: `#${demo.parentElement.dataset.demo}` }, `Skip to the demo “${demo.ariaLabel}”`);
  link.addEventListener("click", (event) => {
    event.preventDefault(); // the second demo of a name is not the one that an address means
    demo.tabIndex = -1;
    demo.focus();
    demo.scrollIntoView();
  });
  skips.append(" ", link);
}

/** Mount them in their order, each in a task of its own: between two of them the page answers. */
function mountInTurn(demos, [element, ...others], address) {
  if (!element) return;
  try {
    if (mountOne(demos, element, address)) {
      element.scrollIntoView();
      address.name = ""; // the first one of the name is meant
    }
    linkTo(element.querySelector(":scope > .chr-demo"));
  } catch (error) {
    // What stood there for readers without scripts stays, and the other demos start.
    element.dataset.failed = String(error);
  }
  setTimeout(() => mountInTurn(demos, others, address));
}

/** Mount them, by { name: mount }, once the page is there. */
export function mountOn(demos) {
  const mount = () => setTimeout(() => mountInTurn(demos, document.querySelectorAll("[data-demo]"), addressed()));
  if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", mount);
  else mount();
}
