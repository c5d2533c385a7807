/** The script of the book's pages: a demo in every element with a `data-demo`. */
import { mount as drift } from "./drift.js";
import { mount as gimbalLock } from "./gimbal_lock.js";
import { mount as tilt } from "./tilt.js";

const DEMOS = { drift, "gimbal-lock": gimbalLock, tilt };

function mountAll() {
  for (const element of document.querySelectorAll("[data-demo]"))
    DEMOS[element.dataset.demo](element, JSON.parse(element.dataset.state));
}

if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", mountAll);
else mountAll();
