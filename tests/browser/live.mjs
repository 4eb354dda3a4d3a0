// Tries every live figure of the book in headless Chromium: live.mjs [HTML] [NAME…]. Each shows the numbers of
// the native program in ten poses, answers mouse, finger and keys, comes back from a link, and does not keep
// the text waiting.
import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { Report, bookFolder, newPage, pageAddress, startBrowser } from "./browser.mjs";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "../..");
const [given, ...only] = process.argv.slice(2);
const folder = bookFolder(given);
const report = new Report("live figures");
const heaviest = 3e6; // bytes of a page with its live figures

// Which page shows which live figures.
const pagesWithFigures = () => {
  const pages = [];
  for (const name of readdirSync(folder).filter((one) => one.endsWith(".html"))) {
    const html = readFileSync(join(folder, name), "utf8");
    const figures = [...html.matchAll(/class="live[^"]*" data-live="([a-z0-9_]+)"/g)].map(([, figure]) => figure);
    const wanted = figures.filter((figure) => only.length === 0 || only.includes(figure));
    if (wanted.length > 0) pages.push({ name, html, figures, wanted });
  }
  return pages;
};

// What the native program shows: a list of { events, numbers }.
const nativePoses = (figure) => {
  for (const chapter of readdirSync(join(root, "recipes"))) {
    const path = join(root, "recipes", chapter, figure, "live.expected");
    if (existsSync(path)) {
      return readFileSync(path, "utf8").trimEnd().split("\n\n").map((block) => {
        const lines = block.split("\n");
        const events = lines.filter((line) => line.startsWith("> ")).map((line) => line.slice(2));
        return { events: events.join("\n") || "start", numbers: lines.slice(events.length || 1).join("\n") };
      });
    }
  }
  return undefined;
};

const live = (figure) => `document.querySelector(".live[data-live='${figure}']")`;
const numbers = (figure) => `[...${live(figure)}.querySelectorAll(".live-numbers > div")]
  .map((row) => [...row.children].map((cell) => cell.textContent).join(" ")).join("\\n")`;

// The numbers, the drawing and the picture, in short: what changes where a figure answers.
const look = (figure) => `(() => {
  const place = ${live(figure)}, canvas = place.querySelector("canvas");
  const text = place.querySelector(".live-numbers").textContent + (place.querySelector(".live-sheet")?.innerHTML ?? "");
  const pixels = canvas.hidden ? [] : canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  let sum = 7;
  for (const byte of pixels) sum = (sum * 31 + byte) | 0;
  for (const letter of text) sum = (sum * 31 + letter.codePointAt(0)) | 0;
  return sum;
})()`;

const awake = async (page, figure) => {
  await page.evaluate(`${live(figure)}.scrollIntoView({ block: "center" })`);
  await page.waitForFunction(`${live(figure)}.classList.contains("is-live")`, null, { timeout: 20000 });
  await page.evaluate(`${live(figure)}.live.play(false)`);
};
const frames = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

const checkPoses = async (page, figure, place) => {
  const poses = nativePoses(figure);
  report.expect(poses?.length > 10, place, "its live.expected has fewer than ten poses");
  for (const { events, numbers: expected } of poses ?? []) {
    await page.evaluate(`${live(figure)}.live.send(${JSON.stringify(events)})`);
    const shown = await page.evaluate(numbers(figure));
    report.expect(shown === expected, place, `after "${events.replaceAll("\n", "; ")}" it shows\n${shown}\nwhere the native program shows\n${expected}`);
  }
  const message = await page.evaluate(`${live(figure)}.querySelector(".live-message").hidden`);
  report.expect(message, place, "it shows an error");
};

// Where an element is taken hold of: in its middle, or where the figure says.
const middle = async (element) => {
  const box = await element.boundingBox();
  const grip = await element.evaluate((one) => {
    const place = one.closest(".live").live.shown.grip;
    return one.tagName === "CANVAS" && place ? [place[0] / one.width, place[1] / one.height] : [0.5, 0.5];
  });
  return [box.x + box.width * grip[0], box.y + box.height * grip[1]];
};

// Does something, and tells whether the figure looks otherwise after it.
const answers = async (page, figure, act, from = "start") => {
  await page.evaluate(`${live(figure)}.live.send(${JSON.stringify(from)})`);
  const before = await page.evaluate(look(figure));
  await act();
  await frames(page);
  return (await page.evaluate(look(figure))) !== before;
};

const dragged = async (page, element, by) => {
  const [x, y] = await middle(element);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 4; ++i) {
    await page.mouse.move(x + by * i / 4, y + by * i / 8);
    await frames(page);
  }
  await page.mouse.up();
};

const touched = async (page, element, by) => {
  const [x, y] = await middle(element);
  const session = await page.context().newCDPSession(page);
  const touch = (type, dx) => session.send("Input.dispatchTouchEvent", {
    type, touchPoints: type === "touchEnd" ? [] : [{ x: x + dx, y: y + dx / 2 }],
  });
  await touch("touchStart", 0);
  for (let i = 1; i <= 4; ++i) {
    await touch("touchMove", by * i / 4);
    await frames(page);
  }
  await touch("touchEnd", by);
  await session.detach();
};

const checkInputs = async (page, figure, place) => {
  const place_ = page.locator(`.live[data-live='${figure}']`);
  const scroll = () => page.evaluate("document.scrollingElement.scrollTop");
  const at = await scroll();
  await page.evaluate(`${live(figure)}.live.send("start")`);
  const names = await place_.locator(".live-handle:visible").evaluateAll((all) => all.map(({ title }) => title));
  for (const name of names) {
    const handle = place_.locator(`.live-handle[title='${name}']`);
    report.expect(await answers(page, figure, () => dragged(page, handle, -24)), place, `${name}: the mouse moves nothing`);
    report.expect(await answers(page, figure, () => touched(page, handle, -24)), place, `${name}: a finger moves nothing`);
    report.expect(await answers(page, figure, () => handle.press("Shift+ArrowLeft")), place, `${name}: arrow keys move nothing`);
  }
  const moving = await page.evaluate(`${live(figure)}.live.shown.moving`);
  const steps = () => moving ? page.evaluate(`${live(figure)}.live.send("step 3")`) : undefined;
  for (const slider of await place_.locator("input[type=range]:visible").all()) {
    const name = await slider.getAttribute("aria-label");
    const before = await slider.inputValue();
    await slider.press("ArrowLeft");
    if ((await slider.inputValue()) === before) await slider.press("ArrowRight");
    report.expect((await slider.inputValue()) !== before, place, `${name}: arrow keys change nothing`);
  }
  const canvas = place_.locator("canvas:visible");
  if (await canvas.count()) {
    report.expect(await answers(page, figure, () => dragged(page, canvas, 60).then(steps)), place, "its picture does not answer the mouse");
    report.expect(await answers(page, figure, () => touched(page, canvas, 60).then(steps)), place, "its picture does not answer a finger");
  }
  for (const select of await place_.locator("select:visible").all()) {
    const name = await select.getAttribute("aria-label");
    const others = await select.locator("option").count() - 1;
    const choose = async (way) => { await select.press(way); await steps(); };
    let changes = false;
    // A choice may matter in some poses only, or where two handles have changed places.
    await page.evaluate(`${live(figure)}.live.send("start")`);
    const [one, other] = await page.evaluate(`${live(figure)}.live.shown.inputs.filter(({ kind }) => kind === "handle")`);
    const swapped = other ? [`start\ndrag ${one.event} ${other.px} ${other.py}\ndrag ${other.event} ${one.px} ${one.py}`] : [];
    for (const from of ["start", ...swapped, ...(nativePoses(figure) ?? []).map(({ events }) => `start\n${events}`)]) {
      for (let i = 0; i <= others && !changes; ++i) {
        changes = await answers(page, figure, () => choose(i === 0 ? "Home" : "ArrowDown"), i === 0 ? from : "width 640");
      }
      if (changes) break;
    }
    report.expect(changes, place, `${name}: no choice changes anything`);
  }
  if (moving) {
    const step = async () => {
      for (const button of await place_.locator(".live-do:visible").all()) await button.click();
      await page.evaluate(`${live(figure)}.live.play(false)`);
      await place_.locator(".live-bar").getByRole("button", { name: "step" }).click();
    };
    report.expect(await answers(page, figure, step), place, "a single step moves nothing");
    await page.evaluate(`${live(figure)}.live.send("start")`);
  }
  report.expect(Math.abs((await scroll()) - at) < 2, place, "the page was scrolled by what is done in the figure");
};

// A link made after a pose leads back to it.
const checkLink = async (page, figure, name, place) => {
  const { events } = nativePoses(figure)?.[3] ?? { events: "start" };
  await page.evaluate(`${live(figure)}.live.send(${JSON.stringify(`start\n${events}`)})`);
  const [state, shown] = await page.evaluate(`[${live(figure)}.live.shown.state, ${numbers(figure)}]`);
  await page.goto("about:blank");
  await page.goto(`${pageAddress(folder, name)}#live:${figure}:${encodeURIComponent(state)}`);
  await awake(page, figure);
  const again = await page.evaluate(numbers(figure));
  await page.evaluate((hash) => { location.hash = hash; }, `#live:${figure}:`);
  await frames(page);
  await page.evaluate((hash) => { location.hash = hash; }, `#live:${figure}:${encodeURIComponent(state)}`);
  await frames(page);
  report.expect((await page.evaluate(numbers(figure))) === shown, place, `the link to "${state}" on the page itself leads elsewhere`);
  report.expect(again === shown, place, `the link to "${state}" shows\n${again}\ninstead of\n${shown}`);
};

const checkWeight = ({ name, html, figures }) => {
  const loaded = [...html.matchAll(/(?:src|href)="([^":#]+\.(?:js|css|svg|png))"/g)].map(([, file]) => join(folder, file));
  const modules = [...new Set(figures)].map((figure) => join(folder, "live", `${figure}.wasm.js`));
  const bytes = [join(folder, name), ...new Set(loaded), ...modules]
    .reduce((sum, file) => sum + (existsSync(file) ? statSync(file).size : 0), 0);
  report.expect(bytes < heaviest, name, `it weighs ${(bytes / 1e6).toFixed(2)} MB with its live figures`);
  return bytes;
};

// Text is painted before the first module is asked for.
const checkPaint = async (page, name) => {
  const [painted, asked] = await page.evaluate(() => [
    performance.getEntriesByName("first-contentful-paint")[0]?.startTime,
    performance.getEntriesByType("resource").find(({ name: file }) => file.endsWith(".wasm.js"))?.startTime,
  ]);
  report.expect(painted !== undefined && !(asked < painted), name, `a module is asked for at ${asked} ms, text painted at ${painted} ms`);
};

// How long an answer takes; told, and not judged.
const answerTime = (page, figure) => page.evaluate(`(() => {
  const { live } = ${live(figure)};
  live.send("start");
  const handle = live.shown.inputs.find(({ kind }) => kind === "handle");
  const slider = live.shown.inputs.find(({ kind }) => kind === "slider");
  const event = (i) => handle ? \`drag \${handle.event} \${handle.px + i % 20} \${handle.py}\`
    : live.shown.moving ? "step 1" : slider ? \`set \${slider.event} \${slider.x + i * 1e-3}\` : "theme light";
  const times = Array.from({ length: 60 }, (_, i) => live.send(event(i))).sort((a, b) => a - b);
  live.send("start");
  return times[30];
})()`);

const browser = await startBrowser();
const pages = pagesWithFigures();
const told = [];
for (const one of pages) {
  const bytes = checkWeight(one);
  const page = await newPage(browser, { touch: true });
  await page.goto(pageAddress(folder, one.name));
  for (const figure of one.wanted) {
    const place = `${one.name}, ${figure}`;
    try {
      await awake(page, figure);
      await checkPaint(page, one.name);
      const time = await answerTime(page, figure);
      await checkPoses(page, figure, place);
      await checkInputs(page, figure, place);
      await checkLink(page, figure, one.name, place);
      told.push(`${figure.padEnd(22)} ${one.name.padEnd(34)} ${(bytes / 1e6).toFixed(2)} MB ${time.toFixed(1)} ms`);
    } catch (error) {
      report.fail(place, `${error.message.split("\n")[0]}`);
    }
    report.progress(told.length, pages.length);
  }
  for (const fault of page.faults) report.fail(one.name, fault);
  await page.context().close();
}
await browser.close();
console.log(["figure, page, weight of the page, an answer", ...told].join("\n"));
process.exit(report.end());
