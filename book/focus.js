/* A button that is pressed by keyboard keeps the focus, which the theme and the buttons for code take from it. */

(() => {
  let pressed = null;
  const back = () => setTimeout(() => {
    const here = document.activeElement; // what has just been closed may still have it
    if (here === document.body || !here.checkVisibility()) pressed?.focus();
  });
  document.addEventListener("click", (event) => {
    pressed = event.detail === 0 ? event.target.closest("button") : null; // 0 clicks of a mouse
    back();
  }, true);
  document.addEventListener("close", back, true); // of what a button opened, such as the search
})();
