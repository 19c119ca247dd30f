// What every test in a browser shares. Enter at testSite: it serves the site that the command line
// names, opens a browser, runs the test, and fails when the test complained, or the browser did.
//
// A browser's complaint is any message on the console, any error of a script, any request that
// fails or leaves the site. So each test sees to that as well, whatever else it looks at.

import { globSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";

import { launch } from "./chromium.mjs";
import { serve } from "./server.mjs";

export const folder = resolve(process.argv[2] ?? "build/release/test-site");
// 404.html is no page, but what is shown instead of one.
const files = globSync("**/*.html", { cwd: folder })
  .filter((path) => path !== "404.html")
  .sort();
const leadsOn = (path) => readFileSync(join(folder, path), "utf8").includes('http-equiv="refresh"');
// The course as one document, to be printed, if the site has it. It is all lessons once more, and
// as large, so only those look at it who ask for it.
export const documents = files.filter((path) => path === "print.html");
// The paths of all other pages, below the site's root; and of those that lead on to one of them,
// where nobody can stay.
export const pages = files.filter((path) => !leadsOn(path) && !documents.includes(path));
export const movedPages = files.filter(leadsOn);

// The pages that hold `text` in their HTML, so that a test need not open all others.
export const pagesWith = (text) =>
  pages.filter((path) => readFileSync(join(folder, path), "utf8").includes(text));

function saveData() {
  Object.defineProperty(Navigator.prototype, "connection", {
    value: { saveData: true },
  });
}

export class Visitor {
  #browser;
  #root;
  #problems = new Set();

  constructor(browser, root) {
    this.#browser = browser;
    this.#root = root;
  }

  get problems() {
    return [...this.#problems];
  }

  complain(where, what) {
    this.#problems.add(`${where}: ${what}`);
  }

  // Complains unless `good`, and says whether it was.
  expect(good, where, what) {
    if (!good) this.complain(where, what);
    return good;
  }

  // Of a file of the site, or of what stands behind the root in an address already.
  address(path) {
    const isFile = files.includes(path);
    return this.#root + (isFile ? path.split("/").map(encodeURIComponent).join("/") : path);
  }

  // Opens the page at `path` for a new reader, without a service worker, hands it to `look`, and shuts
  // it. For one who saves data, no lab goes live by itself. `before` is given the page while it is empty; all
  // other options are those of a context.
  async visit(path, options, look) {
    const { width = 1440, scheme = "light", javaScript = true, ...rest } = options;
    const { savesData = false, before, ...others } = rest;
    const context = await this.#browser.newContext({
      viewport: { width, height: 900 },
      colorScheme: scheme,
      javaScriptEnabled: javaScript,
      ...others,
    });
    const page = await context.newPage();
    page.setDefaultTimeout(60_000);
    this.#watch(page, path);
    // Nor is it there in every browser. What it does, tests/site/offline.mjs sees.
    await page.addInitScript(() => delete Navigator.prototype.serviceWorker);
    if (savesData) await page.addInitScript(saveData);
    await before?.(page);
    await page.goto(this.address(path));
    await look(page);
    page.removeAllListeners(); // what is still being loaded is broken off now
    await context.close();
  }

  #watch(page, path) {
    page.on("console", (message) => this.complain(path, `console: ${message.text()}`));
    page.on("pageerror", (error) => this.complain(path, `script: ${error.stack}`));
    page.on("dialog", (dialog) => this.complain(path, `dialog: ${dialog.message()}`));
    page.on("request", (request) => {
      const inside = request.url().startsWith(this.#root) || request.url().startsWith("data:");
      this.expect(inside, path, `asks for ${request.url()}, which is outside of the site`);
    });
    page.on("requestfailed", (request) => {
      const reason = request.failure()?.errorText;
      if (reason === "net::ERR_ABORTED") return; // a reload breaks off what is on its way
      this.complain(path, `no answer for ${request.url()}: ${reason}`);
    });
    page.on("response", (response) => {
      this.expect(response.status() < 400, path, `${response.status()} for ${response.url()}`);
    });
  }
}

// Runs `test` with a Visitor, tells what it found, and sets the exit code. `options` are launch()'s.
export async function testSite(test, options) {
  const server = await serve(folder);
  const browser = await launch(options);
  const visitor = new Visitor(browser, server.root);
  try {
    visitor.expect(pages.length > 1, folder, "there are no pages of lessons");
    await test(visitor);
  } catch (error) {
    visitor.complain("the test was broken off", error.message);
  } finally {
    await browser.close();
    server.close();
  }
  for (const problem of visitor.problems) console.error(problem);
  console.log(`${pages.length} pages, ${visitor.problems.length} problems`);
  process.exitCode = visitor.problems.length > 0 ? 1 : 0;
}
