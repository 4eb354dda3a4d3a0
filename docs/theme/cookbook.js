// Small helps that a style sheet cannot give.

// Boxes that scroll can be reached and scrolled by keyboard, and fade out where there is more.
const markBox = (box) => {
  const hidden = box.scrollWidth - box.clientWidth;
  if (hidden > 1) {
    box.tabIndex = 0;
  }
  box.classList.toggle("more-right", hidden - box.scrollLeft > 2);
};
const boxes = new ResizeObserver((entries) => entries.forEach((entry) => markBox(entry.target)));
const markBoxes = () => {
  for (const box of document.querySelectorAll(
    "div.fragment, pre.fragment, div.figure, p.formulaDsp, .contents table, .contents tbody")) {
    boxes.observe(box);
    box.addEventListener("scroll", () => markBox(box), { passive: true });
    markBox(box);
  }
};
window.addEventListener("load", () => {
  markBoxes();
  // Formulas are as wide as they are only once they are set.
  if (window.MathJax && window.MathJax.Hub) {
    window.MathJax.Hub.Queue(() => document.querySelectorAll("p.formulaDsp").forEach(markBox));
  }
});

// A long name at the head of a column may be broken after its underscores.
window.addEventListener("DOMContentLoaded", () => {
  for (const head of document.querySelectorAll("table.verdicts thead th")) {
    head.innerHTML = head.innerHTML.replaceAll("_", "_<wbr>");
  }
});

// A difference: its lines by their first sign, as they stand in the text without this.
window.addEventListener("DOMContentLoaded", () => {
  const kinds = { "+": "added", "-": "removed", "@": "place" };
  for (const block of document.querySelectorAll("pre.fragment")) {
    if (!block.textContent.startsWith("@@ ")) {
      continue;
    }
    const lines = block.textContent.replace(/\n$/, "").split("\n");
    block.classList.add("difference");
    block.replaceChildren(...lines.map((text) => {
      const line = document.createElement("span");
      line.className = kinds[text[0]] || "";
      line.textContent = text + "\n";
      return line;
    }));
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
