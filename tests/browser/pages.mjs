// Looks at the pages of the book in headless Chromium, from file://: node pages.mjs HTML [--all | PAGE…]
// Written pages are opened twice, wide in light and narrow in dark. Those made from the sources, thousands of a few
// kinds, are all read for what they load and where they link to; the longest of each kind and every tenth of the
// others are opened, with --all every one.
import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { cpus } from "node:os";
import { join } from "node:path";
import vm from "node:vm";
import { bookFolder, newPage, pageAddress, Report, startBrowser, visit } from "./browser.mjs";

const folder = bookFolder(process.argv[2]);
const all = process.argv.includes("--all");
const asked = process.argv.slice(3).filter((name) => name !== "--all");
const book = readdirSync(folder).filter((name) => name.endsWith(".html"));
const pages = asked.length ? asked : book;
const written = /^(index|ch\d.*|notation|formulas|failing_cases|recipes|bibliography|search|making|other_files)\.html$/;

// The pages to open: those that take longest come first, so that no worker is left with one of them at the end.
const toOpen = () => {
  if (asked.length) return [...asked];
  const size = (name) => statSync(join(folder, name)).size;
  const kinds = new Map();
  for (const name of pages.filter((one) => !written.test(one))) {
    const kind = /_8[a-z]+\.html$/.test(name) ? "file" : name.match(/^(struct|class|namespace|dir|files|concept)?/)[0] + /-members/.test(name);
    kinds.set(kind, [...(kinds.get(kind) ?? []), name]);
  }
  const made = [...kinds.values()].flatMap((one) =>
    one.sort((a, b) => size(b) - size(a)).filter((_, i) => all || i < 10 || i % 10 === 0));
  return pages.filter((name) => written.test(name)).sort((a, b) => size(b) - size(a)).concat(made);
};
const wide = { width: 1280, height: 900 };
const narrow = { width: 420, height: 800, dark: true };

const report = new Report("pages");
const places = new Map(); // of each page: the ids that a link may lead to
const links = new Map(); // of each page: where its links lead

// What a screen reader says of each link, button, field and picture must not be nothing.
const spoken = new Set(["link", "button", "textbox", "searchbox", "combobox", "checkbox", "radio", "slider", "spinbutton",
  "switch", "image", "img", "graphics-document", "heading"]);
const unnamed = async (session) => {
  const { nodes } = await session.send("Accessibility.getFullAXTree");
  const roles = new Map(nodes.map(({ nodeId, role }) => [nodeId, role?.value]));
  const without = nodes.filter(({ ignored, role, name, parentId }) =>
    !ignored && spoken.has(role?.value) && !name?.value?.trim() && roles.get(parentId) !== "button");
  const complaints = [];
  for (const { role, backendDOMNodeId } of without) {
    const { node } = await session.send("DOM.describeNode", { backendNodeId: backendDOMNodeId });
    const marks = [];
    for (let i = 0; i < (node.attributes ?? []).length; i += 2) {
      if (["id", "class", "href", "src"].includes(node.attributes[i])) marks.push(`${node.attributes[i]}="${node.attributes[i + 1]}"`);
    }
    complaints.push(`${role.value} without a name: <${[node.localName, ...marks].join(" ")}>`);
  }
  return complaints;
};

const checkPage = async ({ page, session, state }, name, { thorough, first }) => {
  await visit(page, folder, name);
  const place = `${name} (${state})`;
  const kinds = ["tex", "pictures", "sideways"];
  if (first) kinds.push("structure", "nameless");
  if (thorough) kinds.push("contrast", "repeated");
  const found = await page.evaluate((all) => all.map((kind) => bookChecks[kind]()), kinds);
  if (thorough && first) found.push(await unnamed(session));
  for (const complaints of [page.faults.splice(0), ...found]) report.expect(complaints.length === 0, place, complaints);
  if (!first) return;
  const own = await page.evaluate(() => bookChecks.links());
  places.set(name, new Set(own.places));
  links.set(name, own.links);
};

// What can be told of a page without opening it; what opening it finds takes its place.
const readPage = (name) => {
  const html = readFileSync(join(folder, name), "utf8");
  const meant = (text) => text.replaceAll("&quot;", '"').replaceAll("&lt;", "<").replaceAll("&gt;", ">").replaceAll("&amp;", "&");
  const values = (pattern) => [...html.matchAll(pattern)].map(([, value]) => meant(value));
  places.set(name, new Set(values(/ (?:id|name)="([^"]+)"/g)));
  if (!pages.includes(name)) return;
  report.expect(/<html[^>]* lang="/.test(html), name, "<html> has no lang");
  const loaded = values(/<(?:script|img|iframe|embed|link|object|source)\b[^>]*? (?:src|href|data)="([^"]*)"/g);
  report.expect(!loaded.some((one) => /^(https?:)?\/\//.test(one)), name, "loads something from the net");
  links.set(name, values(/<a\b[^>]*? href="([^"]*)"/g).map((link) => new URL(link, pageAddress(folder, name)).href));
};

const openView = async (browser, size) => {
  const page = await newPage(browser, size);
  const session = await page.context().newCDPSession(page);
  return { page, session, state: `${size.width} px, ${size.dark ? "dark" : "light"}` };
};

// Each worker takes the next page from the list until there is none.
const work = async (browser, list) => {
  const views = [await openView(browser, wide), await openView(browser, narrow)];
  for (let name = list.shift(); name; name = list.shift()) {
    const thorough = written.test(name);
    try {
      await checkPage(views[0], name, { thorough, first: true });
      if (thorough) await checkPage(views[1], name, { thorough, first: false });
    } catch (error) {
      if (!browser.isConnected()) throw new Error("the browser ended");
      report.fail(name, `could not be looked at: ${error.message.split("\n")[0]}`);
    }
    report.progress(opened - list.length, opened);
  }
};

// Where the tree beside the pages and the search lead, from the scripts that hold them.
const scriptLinks = () => {
  const found = [];
  for (const file of readdirSync(folder).filter((name) => /^(navtreedata|search_index)\.js$/.test(name))) {
    const held = vm.createContext({});
    vm.runInContext(readFileSync(join(folder, file), "utf8").replace(/^(const|let) /gm, "var "), held);
    const add = (place) => typeof place === "string" && /\.html/.test(place) && found.push([file, pageAddress(folder, place)]);
    const walk = (tree) => tree.forEach(([, link, below]) => (add(link), Array.isArray(below) && walk(below)));
    if (held.NAVTREE) walk(held.NAVTREE);
    held.bookSections?.forEach(([place]) => add(place));
    held.bookNames?.forEach(([, , place]) => add(place));
  }
  return found;
};

const checkLinks = () => {
  const beginning = pageAddress(folder, "index.html").replace(/index\.html$/, "");
  const leading = [...links].flatMap(([name, own]) => own.map((link) => [name, link])).concat(asked.length ? [] : scriptLinks());
  for (const [name, link] of leading) {
    if (!link.startsWith(beginning)) {
      report.expect(/^(https?:|mailto:|javascript:)/.test(link), name, `link to ${link}, which is not of the book`);
      continue;
    }
    const [file, anchor] = link.slice(beginning.length).split("#").map(decodeURIComponent);
    const target = file.replace(/\?.*$/, "");
    // Doxygen links to a summary of nested types even where all are private.
    const alive = places.has(target) ? !anchor || anchor === "nested-classes" || places.get(target).has(anchor) : existsSync(join(folder, target));
    report.expect(alive, name, `dead link to ${target}${anchor ? "#" + anchor : ""}`);
  }
};

const list = toOpen();
const opened = list.length;
book.forEach(readPage);
const browsers = await Promise.all(cpus().slice(0, 4).map(startBrowser));
try {
  await Promise.all(browsers.map((browser) => work(browser, list)));
} finally {
  await Promise.all(browsers.map((browser) => browser.close()));
}
checkLinks();
process.exitCode = report.end();
