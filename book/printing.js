/* On paper a page is light. It is made so before the demos draw, which a listener that captures is called for. */

(() => {
  const root = document.documentElement;
  let theme;
  addEventListener("beforeprint", () => {
    theme = root.dataset.theme;
    root.dataset.theme = "light";
  }, true);
  addEventListener("afterprint", () => {
    root.dataset.theme = theme;
  });
})();
