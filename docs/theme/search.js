// The search of the book: headings and bold terms first, then names of the code, then prose. The box is
// Doxygen's; what it looks through, search_index.js, is written by docs/index/book_search.cpp and loaded
// when the box is first used.

// Words that no page can carry, and what they are called there.
const otherWords = {
};

// Text as words in one spelling: small letters, no accents, dashes or underscores, singular, and
// "culling" as "cull".
const irregular = { axes: "axis", matrices: "matrix", vertices: "vertex", indices: "index" };
const singular = (word) =>
  irregular[word] ||
  (/(x|ch|sh|ss)es$/.test(word) ? word.slice(0, -2)
    : word.length > 3 && /[^s]s$/.test(word) ? word.slice(0, -1) : word);
const stem = (word) =>
  word.length > 6 && word.endsWith("ing") ? word.slice(0, -3).replace(/([bdglmnprt])\1$/, "$1") : word.replace(/ll$/, "l");
const spelt = (text) =>
  text.toLowerCase().normalize("NFKD").replace(/[\u0300-\u036f]/g, "")
    .replace(/[^a-z0-9\u0370-\u03ff]+/g, " ").trim().split(" ")
    .map((word) => stem(singular(irregular[word] || word))).join(" ");

// How well a heading or a term answers, from 0 to 1: the same; a phrase of it; the beginning of a
// word; the same letters, written apart or together.
const agreement = (term, asked) => {
  const share = asked.length / (term.length || 1);
  if (term === asked) return 1;
  if ((" " + term + " ").includes(" " + asked + " ")) return 0.6 + 0.2 * share;
  if ((" " + term).includes(" " + asked)) return 0.4 + 0.1 * share;
  const joined = asked.replaceAll(" ", "");
  return joined.length > 4 && term.replaceAll(" ", "").includes(joined) ? 0.3 + 0.1 * share : 0;
};
const times = (text, word) => (" " + text + " ").split(word).length - 1;

let prepared = null;
const prepare = () => {
  prepared ||= {
    sections: bookSections.map(([place, page, above, heading, terms, shown, text]) => ({
      place, page, above, heading, text, many: terms.split("|").length > 10, title: spelt(heading.replace(/^Chapter \d+: /, "")),
      terms: terms.split("|").flatMap((term) => [term, ...term.split(/[()]/)]).map(spelt).filter(Boolean),
      shown: shown.split("|").filter(Boolean).map(spelt), prose: spelt(text),
    })),
    names: bookNames.map(([name, kind, place]) => ({ name, kind, place, term: spelt(name) })),
  };
  return prepared;
};

/// All that answers `query`, best first: {place, heading, page, excerpt}.
const searchBook = (query) => {
  const asked = spelt(otherWords[spelt(query)] || query);
  if (!asked) return [];
  const words = asked.split(" ");
  const found = [];
  prepare().sections.forEach((section, order) => {
    const { title, terms, many, shown, prose } = section;
    const weight = many ? 0.85 : 0.95; // a list of many terms introduces none
    const named = Math.max(agreement(title, asked), ...terms.map((term) => weight * agreement(term, asked)),
      ...shown.map((mark) => 0.6 * agreement(mark, asked)));
    const told = times(prose, " " + asked + " ");
    const scattered = words.every((word) => (" " + title + " " + prose).includes(" " + word));
    const inTitle = words.every((word) => (" " + title + " " + terms.join(" ")).includes(" " + word));
    const aside = /^(exercise|source|what you need)/.test(title) || !section.page.startsWith("Chapter");
    const inProse = (told ? 100 + 20 * Math.log2(told) : 0) / (aside ? 4 : 1) +
      (scattered && !aside ? 20 + Math.min(20, ...words.map((word) => times(prose, " " + word))) : 0);
    const score = Math.max(1000 * named, inTitle ? 350 : 0) + inProse / 100;
    if (score > 0) found.push({ ...section, score: score - 0.01 * order });
  });
  for (const { name, kind, place, term } of prepare().names) {
    const named = agreement(term, asked);
    if (named > 0.3) found.push({ place, heading: name, page: kind, score: named === 1 ? 440 : 200 * named });
  }
  found.sort((a, b) => b.score - a.score);
  return found;
};

// A piece of the prose around the first of the words.
const excerpt = (text, query) => {
  const words = query.toLowerCase().split(/[^\p{L}\p{N}]+/u).filter(Boolean);
  const low = text.toLowerCase();
  const at = Math.max(0, Math.min(...words.map((word) => low.indexOf(word)).filter((i) => i >= 0), low.length) - 50);
  const start = at === 0 || at >= low.length - 50 ? 0 : low.indexOf(" ", at) + 1;
  return (start ? "… " : "") + text.slice(start, start + 150) + (text.length > start + 150 ? " …" : "");
};

const answerRow = (answer, query, root) => {
  const row = document.createElement("a");
  row.href = root + answer.place;
  const line = (kind, text) => {
    const part = row.appendChild(document.createElement("span"));
    part.className = kind;
    part.textContent = text;
  };
  line("found", answer.above ? answer.above + ": " + answer.heading : answer.heading);
  if (answer.page !== answer.heading) line("where", answer.page);
  if (answer.text) line("excerpt", excerpt(answer.text, query));
  return row;
};
const showAnswers = (panel, query, root, most) => {
  const answers = searchBook(query);
  panel.replaceChildren(...answers.slice(0, most).map((answer) => answerRow(answer, query, root)));
  if (answers.length === 0) {
    panel.textContent = "Nothing on “" + query + "”. The index of formulas, the finder and the bibliography may help.";
  } else if (answers.length > most) {
    const all = panel.appendChild(document.createElement("a"));
    all.href = root + "search.html?q=" + encodeURIComponent(query);
    all.className = "all";
    all.textContent = "All " + answers.length;
  }
};

// The folder of the book's pages, from this script's own address; and the index, when first wanted.
const searchRoot = document.currentScript.src.replace(/search\.js.*$/, "");
let indexWanted = null;
const withIndex = () =>
  (indexWanted ||= new Promise((resolve) => {
    const script = document.createElement("script");
    script.src = searchRoot + "search_index.js";
    script.onload = resolve;
    document.head.appendChild(script);
  }));

const panelFor = (box) => {
  let panel = document.getElementById("book-answers");
  if (!panel) {
    panel = document.body.appendChild(document.createElement("div"));
    panel.id = "book-answers";
  }
  const { left, bottom } = box.getBoundingClientRect();
  panel.style.left = Math.max(8, Math.min(left, window.innerWidth - panel.offsetWidth - 8)) + "px";
  panel.style.top = bottom + 6 + "px";
  return panel;
};
const closePanel = () => document.getElementById("book-answers")?.remove();

// Doxygen makes its box anew where the page's width changes, so all is heard on the document.
const isField = (target) => target.id === "MSearchField";
document.addEventListener("focusin", (event) => isField(event.target) && withIndex());
document.addEventListener("input", async (event) => {
  if (!isField(event.target)) return;
  await withIndex();
  const query = event.target.value.trim();
  if (query.length < 2) return closePanel();
  showAnswers(panelFor(event.target), query, searchRoot, 8);
  panelFor(event.target);
});
document.addEventListener("keydown", (event) => {
  const panel = document.getElementById("book-answers");
  if (event.key === "Escape") closePanel();
  if (!panel) return;
  const rows = [...panel.querySelectorAll("a")];
  const at = rows.indexOf(document.activeElement);
  const steps = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  if (steps && (at >= 0 || isField(event.target))) {
    event.preventDefault();
    (rows[at + steps] || document.getElementById("MSearchField")).focus();
  } else if (event.key === "Enter" && isField(event.target) && rows.length > 0) {
    event.preventDefault();
    location.href = rows[0].href;
  }
});
document.addEventListener("click", (event) => !event.target.closest("#book-answers, #MSearchBox") && closePanel());

// The page search.html?q=… shows all answers; Doxygen's own search of names is switched off.
window.addEventListener("DOMContentLoaded", async () => {
  if (window.searchBox) {
    for (const name of ["OnSearchFieldChange", "OnSearchSelectShow", "OnSearchSelectHide"]) {
      window.searchBox[name] = () => {};
    }
  }
  const all = document.getElementById("all-answers");
  const query = new URLSearchParams(location.search).get("q");
  if (all && query) {
    await withIndex();
    showAnswers(all, query, searchRoot, 60);
  }
});
