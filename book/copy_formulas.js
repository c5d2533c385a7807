/* A formula that is copied gives its LaTeX: alone as it is, within text between dollars. */

document.addEventListener("copy", (event) => {
  const selection = getSelection();
  if (selection.isCollapsed) return;
  const range = selection.getRangeAt(0).cloneRange();
  const formulaOf = (node) => (node instanceof Element ? node : node.parentElement)?.closest("math");
  const [first, last] = [formulaOf(range.startContainer), formulaOf(range.endContainer)];
  if (first) range.setStartBefore(first);
  if (last) range.setEndAfter(last);

  const copied = document.createElement("div");
  copied.append(range.cloneContents());
  const formulas = copied.querySelectorAll("math");
  if (formulas.length === 0) return;
  const html = copied.innerHTML;
  const latex = (formula) => formula.querySelector("annotation").textContent;
  const alone = formulas.length === 1 && copied.textContent.trim() === formulas[0].textContent.trim();
  for (const formula of formulas) {
    const display = formula.getAttribute("display") === "block";
    const [before, after] = alone ? ["", ""] : display ? ["$$\n", "\n$$"] : ["$", "$"];
    formula.replaceWith(before + latex(formula) + after);
  }
  // In the page for a moment, since only there do paragraphs and table cells become lines and tabs.
  copied.style.cssText = "position: fixed; left: -100vw; white-space: pre-wrap";
  document.body.append(copied);
  event.clipboardData.setData("text/plain", copied.innerText.trim());
  event.clipboardData.setData("text/html", html);
  copied.remove();
  event.preventDefault();
});
