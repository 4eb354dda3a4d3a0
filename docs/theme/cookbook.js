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
window.addEventListener("load", markBoxes);

// Formulas are set by MathJax, which only pages load that have one. A screen reader says their TeX; and they
// are as wide as they are only once they are set.
const bookRoot = document.currentScript.src.replace(/cookbook\.js.*$/, "");
const nameFormulas = () => {
  for (const formula of document.querySelectorAll("script[type^='math/tex']")) {
    const picture = document.querySelector(`#${formula.id}-Frame svg`);
    picture?.setAttribute("role", "img");
    picture?.setAttribute("aria-label", formula.textContent.replace(/\\tag\{(.*?)\}/, "($1)"));
  }
};
window.addEventListener("DOMContentLoaded", () => {
  if (!/\\[([]/.test(document.body.textContent)) {
    return;
  }
  const script = document.head.appendChild(document.createElement("script"));
  script.src = bookRoot + "mathjax/MathJax.js";
  script.onload = () => {
    window.MathJax.Hub.Queue(nameFormulas);
    window.MathJax.Hub.Register.MessageHook("End Rerender", nameFormulas);
    window.MathJax.Hub.Queue(() => document.querySelectorAll("p.formulaDsp").forEach(markBox));
  };
});

// What screen readers and keyboards need and Doxygen leaves out: the title is a heading, other headings stand
// below it; the search box has a name; the switch of light and dark and those that copy code are buttons.
const nameSearch = () => document.getElementById("MSearchField")?.setAttribute("aria-label", "Search the book");
const buttons = {
  "doxygen-awesome-dark-mode-toggle": "Light or dark",
  "doxygen-awesome-fragment-copy-button": "Copy this code",
};
const nameButtons = () => {
  for (const button of document.querySelectorAll(Object.keys(buttons).join())) {
    if (button.getAttribute("role") === "button") {
      continue;
    }
    button.setAttribute("role", "button");
    button.setAttribute("aria-label", buttons[button.localName]);
    button.tabIndex = 0;
    button.addEventListener("keydown", (event) => {
      if (event.key === "Enter" || event.key === " ") {
        event.preventDefault();
        button.click();
      }
    });
  }
};
const nameHeadings = () => {
  const title = document.querySelector("div.header .title");
  title?.setAttribute("role", "heading");
  title?.setAttribute("aria-level", "1");
  document.querySelector(".toc h3")?.setAttribute("aria-level", "2");
  const all = [...document.querySelectorAll(".contents :is(h1, h2, h3, h4, h5, h6)")].filter((one) => !one.closest(".toc"));
  const level = (heading) => Number(heading.tagName[1]);
  const down = (title ? 2 : 1) - Math.min(...all.map(level));
  all.forEach((heading) => heading.setAttribute("aria-level", level(heading) + down));
};
window.addEventListener("DOMContentLoaded", () => {
  nameHeadings();
  // Doxygen makes both anew where the page's width changes.
  const names = () => (nameSearch(), nameButtons());
  window.addEventListener("load", names);
  const menu = document.getElementById("top");
  if (menu) {
    new MutationObserver(names).observe(menu, { childList: true, subtree: true });
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
