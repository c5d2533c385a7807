/* What is wider than the page scrolls by itself: with the keyboard, too, where there is more to see. */

(() => {
  const WIDE = ".bd-article :is(div.math, pre, table, div.output, .pst-scrollable-table-container)";
  const scrolls = (each) => each.scrollWidth > each.clientWidth && /auto|scroll/.test(getComputedStyle(each).overflowX);
  const look = () => {
    const parts = [...document.querySelectorAll(WIDE)];
    const wide = parts.filter(scrolls); // all are measured before one is changed
    for (const each of parts) {
      if (wide.includes(each)) each.tabIndex = 0;
      else each.removeAttribute("tabindex");
    }
  };
  addEventListener("load", look);
  addEventListener("resize", look);
  document.addEventListener("toggle", look, true);
})();
