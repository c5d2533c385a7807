/** All that the pages of the book, and a notebook, have of the demos of the chapters. */
import { DEMOS } from "./demos.js";
import { mountOn } from "./pages.js";
import { widget } from "./widget.js";

export const mountAll = () => mountOn(DEMOS);
export const widgetOf = (name) => widget(DEMOS[name]);
