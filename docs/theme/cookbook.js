// Small helps that a style sheet cannot give.

// Boxes that scroll can be reached and scrolled by keyboard.
window.addEventListener("load", () => {
  for (const box of document.querySelectorAll(
    "div.fragment, div.figure, p.formulaDsp, table.verdicts, table.index")) {
    if (box.scrollWidth > box.clientWidth) {
      box.tabIndex = 0;
    }
  }
});

// A long name at the head of a column may be broken after its underscores.
window.addEventListener("DOMContentLoaded", () => {
  for (const head of document.querySelectorAll("table.verdicts thead th")) {
    head.innerHTML = head.innerHTML.replaceAll("_", "_<wbr>");
  }
});

// A tagged formula is as wide as its column was: set it anew where the column's width changes.
let columnWidth = window.innerWidth;
let pending = 0;
window.addEventListener("resize", () => {
  if (window.innerWidth === columnWidth || !window.MathJax || !window.MathJax.Hub) {
    return;
  }
  columnWidth = window.innerWidth;
  clearTimeout(pending);
  pending = setTimeout(() => window.MathJax.Hub.Queue(["Rerender", window.MathJax.Hub]), 200);
});
