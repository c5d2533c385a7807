/**
 * Demos on a page: one in every element with a `data-demo`. What a reader has touched stands in the
 * address, `#tilt?roll=20&pitch=5;gimbal-lock-2?yaw=30`, whole, the last one first, so that it can be
 * sent, and outlives a reload. A second demo of a kind is called by its number.
 *
 * Each entry of the history keeps the states that it was left with: Back and Forward bring them
 * again. A new address, such as that of a link on the page, moves the demos that it names.
 */
import { node } from "./parts.js";

const WAIT = 250; // milliseconds without a change before the address follows

const mounted = {}; // { element, demo } by the name in the address, of those that are there
let touched = {}; // states by that name, the last one first
let timer = 0;

const written = (value) =>
  typeof value === "number" ? Number(value.toPrecision(6)) : encodeURIComponent(value).replaceAll("%2C", ",");

const queryOf = (state) => Object.entries(state).filter(([, value]) => value !== "").map(([key, value]) => `${key}=${written(value)}`).join("&");

const hashOf = (states) => `#${Object.entries(states).map(([name, state]) => `${name}?${queryOf(state)}`).join(";")}`;

const parts = () => location.hash.slice(1).split(";").map((part) => part.split("?"));

/** The states that the address itself says, by the names of the demos. */
const addressed = () =>
  Object.fromEntries(parts().filter(([, query]) => query !== undefined).map(([name, query]) => [name, Object.fromEntries(new URLSearchParams(query))]));

/** What the present entry of the history was left with; nothing for a new one. */
const kept = () => history.state?.demos;

const keep = (address) => history.replaceState({ ...history.state, demos: touched }, "", address);

/** Another entry of the history, or a new address. */
function follow() {
  clearTimeout(timer);
  const [before, known] = [touched, kept()];
  const now = known ?? addressed();
  touched = known ?? { ...now, ...before, ...now };
  for (const name of Object.keys(mounted))
    if (name in now || (known && name in before)) mounted[name].demo.open(now[name] ?? {});
  keep();
  if (!known) mounted[parts()[0][0]]?.element.scrollIntoView();
}

function mountOne(demos, name, element) {
  const kind = element.dataset.demo;
  if (!(kind in demos)) throw new Error(`no demo is called ${kind}`);
  const demo = demos[kind](element, JSON.parse(element.dataset.state), {
    now: touched[name] ?? {},
    linkTo: (state) => location.href.split("#")[0] + hashOf({ [name]: state }),
    onChange(state, moving) {
      clearTimeout(timer);
      if (moving) return;
      const { [name]: _, ...others } = touched;
      touched = { [name]: state, ...others };
      timer = setTimeout(() => keep(hashOf(touched)), WAIT);
    },
  });
  mounted[name] = { element, demo };
}

/** The elements by the names that an address has for them. */
function named() {
  const counts = {};
  return [...document.querySelectorAll("[data-demo]")].map((element) => {
    const kind = element.dataset.demo;
    counts[kind] = (counts[kind] ?? 0) + 1;
    return [counts[kind] > 1 ? `${kind}-${counts[kind]}` : kind, element];
  });
}

/**
 * Beside the page's link that skips what stands before its text, one to each demo, in their order:
 * so many presses of Tab lead there, however much there is before it.
 */
function linkTo(name, demo) {
  const skips = document.querySelector(".skip-link");
  if (!skips || !demo) return;
  const again = name.match(/-\d+$/) ? `, number ${name.split("-").at(-1)} on this page` : "";
  const link = node("a", { href: `#${name}` }, `Skip to the demo “${demo.ariaLabel}”${again}`);
  link.addEventListener("click", (event) => {
    event.preventDefault(); // the address stays, with the states in it
    demo.tabIndex = -1;
    demo.focus();
    demo.scrollIntoView();
  });
  skips.append(" ", link);
}

/** Mount them in their order, each in a task of its own: between two of them the page answers. */
function mountInTurn(demos, [first, ...others]) {
  if (!first) return;
  const [name, element] = first;
  try {
    mountOne(demos, name, element);
    if (name === parts()[0][0]) element.scrollIntoView();
    linkTo(name, element.querySelector(":scope > .chr-demo"));
  } catch (error) {
    // What stood there for readers without scripts stays, and the other demos start.
    element.dataset.failed = String(error);
  }
  setTimeout(() => mountInTurn(demos, others));
}

/** Mount them, by { name: mount }, once the page is there. */
export function mountOn(demos) {
  const mount = () => {
    touched = kept() ?? addressed();
    keep();
    addEventListener("hashchange", follow);
    setTimeout(() => mountInTurn(demos, named()));
  };
  if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", mount);
  else mount();
}
