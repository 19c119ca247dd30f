// What every test of `mjcourse preview` shares: a copy of a course, a preview of it, and a browser.
//
// Enter at preview(). As in tests/site/browser.mjs, whatever the browser complains of is a problem.

import { spawn } from "node:child_process";
import { once } from "node:events";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { launch } from "../site/chromium.mjs";

export class Previewed {
  problems = [];
  #context;

  constructor(course, process, browser, root) {
    Object.assign(this, { course, process, browser, root });
  }

  complain(what) {
    this.problems.push(what);
  }

  expect(good, what) {
    if (!good) this.complain(what);
    return good;
  }

  path(file) {
    return join(this.course, file);
  }
  read(file) {
    return readFileSync(this.path(file), "utf8");
  }
  write(file, text) {
    writeFileSync(this.path(file), text);
  }
  edit(file, from, to) {
    const text = this.read(file);
    if (!text.includes(from)) throw new Error(`${file} has no ${from}`);
    this.write(
      file,
      text.replace(from, () => to),
    );
  }

  async state(page) {
    const answer = await fetch(`${this.root}.preview/state?page=${page}&known=`);
    return answer.json();
  }

  // When nothing runs any more.
  async settled(page = "index.html") {
    for (;;) {
      const state = await this.state(page);
      if (!state.running && state.version > 0) return state;
      await new Promise((waited) => setTimeout(waited, 50));
    }
  }

  // A tab of the one browser context, as a reader's.
  async open(path, options = {}) {
    this.#context ??= await this.browser.newContext({
      viewport: { width: 1280, height: 900 },
      ...options,
    });
    const page = await this.#context.newPage();
    page.setDefaultTimeout(30_000);
    page.on("console", (message) => this.complain(`${path}: console: ${message.text()}`));
    page.on("pageerror", (error) => this.complain(`${path}: script: ${error.stack}`));
    page.on("response", (answer) => {
      if (answer.status() >= 400) this.complain(`${path}: ${answer.status()} for ${answer.url()}`);
    });
    await page.goto(this.root + path);
    await page.locator("html[data-preview-version]").waitFor({ state: "attached" });
    return page;
  }
}

// Copies the course in `folder`, previews it, and hands it to `test`. `setup` may change the copy.
export async function preview(mjcourse, folder, test, { setup, options = [] } = {}) {
  const course = mkdtempSync(join(tmpdir(), "preview-"));
  for (const part of ["content", "models", "examples"]) {
    cpSync(join(folder, part), join(course, part), { recursive: true, force: true });
  }
  await setup?.(course);
  const process_ = spawn(mjcourse, ["preview", "--course", course, ...options]);
  let said = "";
  const root = await new Promise((found, failed) => {
    process_.stdout.on("data", (text) => {
      const address = /preview: (\S+)/.exec((said += text));
      if (address) found(address[1]);
    });
    process_.on("exit", (code) => failed(new Error(`preview ended with ${code}: ${said}`)));
    process_.stderr.on("data", (text) => (said += text));
  });
  process_.removeAllListeners("exit");
  const browser = await launch();
  const previewed = new Previewed(course, process_, browser, root);
  try {
    await test(previewed);
  } catch (error) {
    previewed.complain(`the test was broken off: ${error.stack}`);
  } finally {
    await browser.close();
    previewed.expect(
      process_.exitCode === null && process_.signalCode === null,
      `it died: ${said}`,
    );
    const ended = once(process_, "exit");
    if (process_.kill("SIGINT")) {
      const [code, signal] = await ended;
      previewed.expect(code === 0, `Ctrl-C ends it with ${code ?? signal}: ${said}`);
    }
    rmSync(course, { recursive: true });
  }
  for (const problem of previewed.problems) console.error(problem);
  console.log(`${previewed.problems.length} problems`);
  process.exitCode = previewed.problems.length > 0 ? 1 : 0;
}
