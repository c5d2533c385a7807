/** The same of the converter and the detective, which have a page for themselves. */
import { mount as converter } from "./converter.js";
import { mount as detective } from "./detective.js";
import { mountOn } from "./pages.js";
import { widget } from "./widget.js";

const DEMOS = { converter, detective };

export const mountAll = () => mountOn(DEMOS);
export const widgetOf = (name) => widget(DEMOS[name]);
