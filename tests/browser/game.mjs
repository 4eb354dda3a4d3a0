// Plays the game of chapter 9 in headless Chromium: game.mjs [HTML]. The native program's shots leave the same
// ruin to the bit, and a bird that is dragged with the mouse and let go wins the first level.
import { readFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { Report, bookFolder, newPage, pageAddress, startBrowser } from "./browser.mjs";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "../..");
const folder = bookFolder(process.argv[2]);
const report = new Report("shots");

// The native program's shots: level, pull, points, phase and ruin, by its table.
const shots = readFileSync(join(root, "recipes/09_game/game/game.expected"), "utf8").trimEnd().split("\n").slice(1)
  .map((line) => {
    const [, level, x, y, , points, , phase, ruin] =
      line.match(/^(.*?) +(-?[\d.]+) +(-?[\d.]+) +(\d+) +(\d+) +(\d+) +(\w+) +([0-9a-f]{16})$/);
    return { level, x, y, points, phase, ruin };
  });

const browser = await startBrowser();
const page = await newPage(browser);
await page.goto(pageAddress(folder, "ch9.html"));
await page.evaluate(() => document.querySelector(".live[data-live='game']").scrollIntoView({ block: "center" }));
await page.waitForFunction(() => document.querySelector(".live[data-live='game']").classList.contains("is-live"));

// The figure answers events; its readings by name.
const after = (events) => page.evaluate((text) => {
  const place = document.querySelector(".live[data-live='game']");
  place.live.play(false);
  place.live.send(text);
  const rows = [...place.querySelectorAll(".live-numbers > div")].map((row) => [...row.children].map((cell) => cell.textContent));
  return Object.fromEntries(rows);
}, events);
const levels = [...new Set(shots.map(({ level }) => level))];

let level;
for (const shot of shots) {
  if (shot.level !== level) await after(`start\nset level ${levels.indexOf(shot.level)}`);
  level = shot.level;
  const shown = await after(`set pull_x ${shot.x}\nset pull_y ${shot.y}\npress shoot\nstep 600`);
  for (const [name, value] of [["the game is", shot.phase], ["points", shot.points], ["ruin", shot.ruin]]) {
    report.expect(shown[name] === value, `${level}, ${shot.x}, ${shot.y}`, `${name}: ${shown[name]}, natively ${value}`);
  }
}

// A hand: the bird is dragged some pixels further back, and let go.
await after("start");
const box = await page.locator(".live[data-live='game'] canvas").boundingBox();
const scale = box.width / 640;
const [x, y] = [box.x + 90 * scale, box.y + 245 * scale];
await page.mouse.move(x, y);
await page.mouse.down();
await page.mouse.move(x - 4 * scale, y + 2 * scale);
await page.mouse.move(x - 8 * scale, y + 3 * scale);
await page.mouse.up();
await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
const won = await after("step 600");
report.expect(won["the game is"] === "won", "a bird let go by the mouse", `the game is ${won["the game is"]}`);
for (const fault of page.faults) report.fail("ch9.html", fault);
await browser.close();
process.exit(report.end());
