// A test of the tests: a page on which everything is wrong, and what pages.mjs has to say of it. broken.mjs HTML
import { spawnSync } from "node:child_process";
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { bookFolder, Report } from "./browser.mjs";

const folder = bookFolder(process.argv[2]);
const report = new Report("kinds of faults");
const name = "ch0_broken.html";
const picture = '<svg class="cookbook-figure" width="200" height="100" role="img"';

// What is put on the page, and what is said of it.
const faults = [
  ['<script>console.error("told")</script>', "(1280 px, light): console error: told"],
  ['<script>throw new Error("thrown")</script>', "(1280 px, light): script error: thrown"],
  ['<img src="https://example.org/x.png" alt="x">', "(1280 px, light): outside request: https://example.org/x.png"],
  ["", "loads something from the net"],
  ["<p>\\(\\nosuch x\\)</p>", "(1280 px, light): TeX error: Undefined control sequence \\nosuch"],
  ["<p>\\f$ x \\f$</p>", '(1280 px, light): TeX as text: "\\f$ x \\f$"'],
  ['<img src="nothing.png" alt="n">', "(1280 px, light): empty picture <img> nothing.png"],
  [picture + ' aria-label="a"></svg>', "(1280 px, light): empty picture <svg.cookbook-figure>"],
  ['<p><a href="nothing.html">a</a></p>', "dead link to nothing.html"],
  ['<p><a href="ch1.html#nothing">a</a></p>', "dead link to ch1.html#nothing"],
  ['<div style="width: 700px">wide</div>', '(420 px, dark): <div> "wide" from 16 to 716 px in a page of 420'],
  ['<p style="color: #aaaaaa">pale</p>', '(1280 px, light): contrast 2.32, not 4.5: #aaaaaa on #ffffff, <p> "pale"'],
  ['<p style="color: #222222">night</p>', '(420 px, dark): contrast'],
  [picture + ' aria-label="b"><rect width="200" height="100" fill="#1c5fa8"/><text x="20" y="50" fill="#000000">deep</text></svg>',
    '(1280 px, light): contrast 3.25, not 4.5: #000000 on #1c5fa8, <text> "deep"'],
  ['<p><a href="ch1.html" class="mute"></a></p>', '(1280 px, light): link without a name: <a href="ch1.html" class="mute">'],
  ["<p><button></button><input></p>", "(1280 px, light): button without a name: <button>"],
  ["", "(1280 px, light): textbox without a name: <input>"],
  [picture + '><circle r="9"/></svg>', "(1280 px, light): image without a name: <svg class=\"cookbook-figure\">"],
  ["<h6>deep</h6>", "(1280 px, light): heading of level"],
  ['<p id="same">a</p><p id="same">b</p>', '(1280 px, light): id "same" stands twice'],
];

const page = readFileSync(join(folder, "ch3_batch.html"), "utf8");
const begin = '<div class="textblock">';
writeFileSync(join(folder, name), page.replace(begin, () => begin + faults.map(([fault]) => fault).join("\n")));
try {
  const pages = join(dirname(fileURLToPath(import.meta.url)), "pages.mjs");
  const run = spawnSync(process.execPath, [pages, folder, name], { encoding: "utf8" });
  report.expect(run.status === 1, name, `pages.mjs ends with ${run.status} where all is wrong`);
  for (const [, told] of faults) {
    const said = run.stdout.split("\n").some((line) => line.startsWith(name) && line.includes(told));
    report.expect(said, name, `pages.mjs does not say: ${told}`);
  }
} finally {
  rmSync(join(folder, name));
}
process.exitCode = report.end();
