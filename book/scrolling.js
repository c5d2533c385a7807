/*
 * What is wider than the page scrolls by itself: with the keyboard, too, where there is more to see,
 * and marked at the sides at which there is.
 */

(() => {
  const WIDE = ".bd-article :is(div.math, pre, table, div.output, .pst-scrollable-table-container)";
  const scrolls = (each) => each.scrollWidth > each.clientWidth && /auto|scroll/.test(getComputedStyle(each).overflowX);
  const mark = (each) => {
    const left = each.scrollLeft >= 1;
    const right = each.scrollLeft + each.clientWidth <= each.scrollWidth - 1;
    each.dataset.more = `${left ? "left" : ""} ${right ? "right" : ""}`.trim();
  };
  const look = (within = document) => {
    // What a closed line hides is laid out by itself for each measure, so it waits until it is opened.
    const parts = [...within.querySelectorAll(WIDE)].filter((each) => each.checkVisibility());
    const wide = new Set(parts.filter(scrolls)); // all are measured before one is changed
    for (const each of parts) {
      if (wide.has(each)) {
        each.tabIndex = 0;
        mark(each);
      } else {
        each.removeAttribute("tabindex");
        delete each.dataset.more;
      }
    }
  };
  const later = window.requestIdleCallback ?? setTimeout; // not in the task that shows the page
  addEventListener("load", () => {
    later(() => look());
    let width; // of the page beside its bar; another one is seen once all is laid out for it
    new ResizeObserver(([main]) => {
      if (width !== undefined && width !== main.contentRect.width) look();
      width = main.contentRect.width;
    }).observe(document.querySelector("main"));
  });
  document.addEventListener("scroll", ({ target }) => target.dataset?.more !== undefined && mark(target), true);
  document.addEventListener("toggle", (event) => look(event.target), true);
})();
