// What all tests in a browser share: a headless Chromium, pages of the book from file://, what went wrong on
// them, and the lines of a report.
import { execFileSync } from "node:child_process";
import { existsSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const root = resolve(here, "../..");

/// Where the system's Chromium is, or nothing.
export const chromiumPath = () => {
  for (const name of ["chromium", "chromium-browser", "google-chrome"]) {
    try {
      return execFileSync("sh", ["-c", `command -v ${name}`], { encoding: "utf8" }).trim();
    } catch {
      // The next name.
    }
  }
  return undefined;
};

/// Starts Chromium with a profile of its own and without the net.
export const startBrowser = async () => {
  const { chromium } = createRequire(join(root, "build/browser/"))("playwright-core");
  const executablePath = chromiumPath();
  if (!executablePath) throw new Error("there is no chromium");
  return chromium.launch({
    executablePath,
    headless: true,
    args: ["--no-sandbox", "--disable-gpu", "--host-resolver-rules=MAP * ~NOTFOUND", "--hide-scrollbars"],
  });
};

/// The folder of the book's pages, from the command line or as the strict preset makes it.
export const bookFolder = (given) => {
  const folder = resolve(given ?? join(root, "build/strict/book/html"));
  if (!existsSync(join(folder, "index.html"))) throw new Error(`there is no book in ${folder}`);
  return folder;
};

/// The address of a page of the book: pageAddress(folder, "ch4.html#ch4_need").
export const pageAddress = (folder, name) => {
  const [file, place] = name.split("#");
  return pathToFileURL(join(folder, file)).href + (place ? "#" + place : "");
};

/// Opens an empty page: newPage(browser, { width, height, dark, touch }). What goes wrong on it is put into
/// `page.faults`, texts that are emptied by whoever reports them.
export const newPage = async (browser, { width = 1280, height = 900, dark = false, touch = false } = {}) => {
  const context = await browser.newContext({
    viewport: { width, height },
    colorScheme: dark ? "dark" : "light",
    hasTouch: touch,
    reducedMotion: "reduce",
  });
  await context.addInitScript({ path: join(here, "in_page.js") });
  const page = await context.newPage();
  page.faults = [];
  page.on("console", (message) => {
    if (message.type() === "error") page.faults.push(`console error: ${message.text()}`);
  });
  page.on("pageerror", (error) => page.faults.push(`script error: ${error.message}`));
  page.on("crash", () => page.faults.push("the page crashed"));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) page.faults.push(`outside request: ${request.url()}`);
  });
  page.on("requestfailed", (request) => {
    // What is still on its way when the next page is opened is no fault.
    if (request.failure()?.errorText !== "net::ERR_ABORTED") page.faults.push(`not loaded: ${request.url()}`);
  });
  return page;
};

/// Goes to a page of the book, and waits until its scripts have run and its formulas are set.
export const visit = async (page, folder, name) => {
  await page.goto(pageAddress(folder, name), { waitUntil: "load" });
  await page.evaluate(() => bookChecks.settled());
};

/// Collects failures, a line each: report.fail("ch4.html", "what is wrong"); report.end() is the exit code.
export class Report {
  constructor(what) {
    this.what = what;
    this.failures = 0;
    this.checks = 0;
    this.began = Date.now();
    this.told = Date.now();
  }

  /// `place` names page and state, `complaints` what is wrong there: of one kind, the first five are shown.
  fail(place, complaints) {
    const all = [complaints].flat();
    this.failures += all.length;
    const told = new Map();
    for (const one of all) {
      const kind = one.split(/[:<\d]/)[0];
      told.set(kind, (told.get(kind) ?? 0) + 1);
      if (told.get(kind) <= 5) console.log(`${place}: ${one}`);
    }
    for (const [kind, times] of told) {
      if (times > 5) console.log(`${place}: … ${kind}, ${times - 5} more`);
    }
  }

  /// Counts something that was looked at, and fails where it does not hold.
  expect(holds, place, complaint) {
    this.checks += 1;
    if (!holds) this.fail(place, complaint);
  }

  /// Says every ten seconds how far it is.
  progress(done, all) {
    if (Date.now() - this.told < 10000) return;
    this.told = Date.now();
    console.error(`  ${done} of ${all} ${this.what}, ${this.failures} failures`);
  }

  end() {
    const seconds = Math.round((Date.now() - this.began) / 1000);
    console.log(`${this.what}: ${this.checks} checks, ${this.failures} failures, ${seconds} s`);
    return this.failures === 0 && this.checks > 0 ? 0 : 1;
  }
}
