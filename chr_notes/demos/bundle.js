/** All that the pages of the book, and a notebook, have of the demos. */
export { mountAll } from "./pages.js";
export { widgetOf } from "./widget.js";
