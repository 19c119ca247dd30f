// What a browser keeps of a site that lies below a path of its host, with the host gone: pages that were
// opened can be read, with search and labs; one that was not says so and lists what is kept. A second
// deployment is announced, shown when the reader says so, and never mixed with the first. The whole
// course can be kept.
//
//   node tests/site/offline.mjs SITE MJCOURSE COURSE
//
// SITE tells whether labs are live; what is looked at is built here, of COURSE and of a changed copy.

import { spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import {
  appendFileSync,
  cpSync,
  mkdtempSync,
  readFileSync,
  renameSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { launch } from "./chromium.mjs";
import { Lab } from "./lab/lab.mjs";
import { serve } from "./server.mjs";
import { until } from "./until.mjs";

const [mjcourse, course] = process.argv.slice(3);
const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const [read, docked, unread] = ["1.1-four-labs", "1.2-docked", "1.3-trouble"].map(
  (name) => `1-labs/${name}.html`,
);
// A file of the second edition that a page of the first asks for.
const newPicture = "1-labs/1.2-docked/lab-1.webp";
const problems = [];

function expect(good, what) {
  if (!good) problems.push(what);
}

function build(from, to) {
  const { status, stderr } = spawnSync(mjcourse, ["build", "--course", from, "--out", to]);
  if (status !== 0) throw new Error(`${stderr}`);
}

// Every page has other words, and every picture of the model another colour.
function buildBoth() {
  const changed = join(home, "course");
  cpSync(course, changed, { recursive: true });
  for (const name of ["1.1-four-labs", "1.2-docked", "1.3-trouble"]) {
    appendFileSync(join(changed, "content/1-labs", `${name}.md`), "\nThe second edition.\n");
  }
  const model = join(changed, "models/cart.xml");
  writeFileSync(model, readFileSync(model, "utf8").replace("0 0.45 0.7 1", "0.9 0.2 0.1 1"));
  build(course, join(home, "first"));
  build(changed, join(home, "second"));
}

// What the site at the one address is made of.
function deploy(name) {
  rmSync(join(home, "site"), { recursive: true, force: true });
  cpSync(join(home, name), join(home, "site.new"), { recursive: true });
  renameSync(join(home, "site.new"), join(home, "site"));
}

class Reader {
  constructor(context, page, root) {
    Object.assign(this, { context, page, root });
  }

  // A new one; what the browser complains of while there is a network is a problem.
  static async come(browser, root) {
    const context = await browser.newContext({ viewport: { width: 1280, height: 900 } });
    const page = await context.newPage();
    page.setDefaultTimeout(30_000);
    const reader = new Reader(context, page, root);
    const complain = (what) => expect(reader.isForgiving, what);
    page.on("pageerror", (error) => expect(false, `script: ${error.message} ${error.stack}`));
    page.on("console", (message) => {
      const { url } = message.location();
      if (!url.endsWith(newPicture)) complain(`console: ${message.text()} ${url}`);
    });
    page.on("response", (answer) => {
      if (answer.status() >= 400) complain(`${answer.status()} for ${answer.url()}`);
    });
    return reader;
  }

  // Until all of it has come: what a later deployment breaks off is no mistake of the page's.
  async go(path) {
    await this.page.goto(this.root + path);
    for (const place of [4, 5]) await this.page.mouse.move(place, place); // labs that are near go live
    await this.page.waitForLoadState("networkidle");
  }

  // Until the worker has the page, and all that it has loaded before there was a worker.
  isKept() {
    return until(this.page, async () => {
      const loaded = performance.getEntriesByType("resource").map(({ name }) => name);
      const shown = [location.href, ...loaded].filter((name) => !/\/(sw\.js|edition-)/.test(name));
      const kept = await Promise.all(shown.map((address) => caches.match(address)));
      return kept.every((response) => response !== undefined);
    });
  }

  text() {
    return this.page.locator("main").innerText();
  }

  // In the search, which must have something for these words.
  async find(words) {
    await this.page.keyboard.press("Control+k");
    await this.page.locator("dialog[open] input").fill(words);
    await this.page.locator("dialog [role=option]").first().waitFor();
  }

  async picturesAreThere() {
    await this.page.waitForFunction(() =>
      [...document.images].every((one) => one.loading === "lazy" || one.naturalWidth > 0),
    );
  }
}

async function readWithoutNetwork(reader) {
  const { page } = reader;
  await reader.go(read);
  await reader.picturesAreThere();
  expect((await reader.text()).includes("A prediction and a goal"), "a lesson has lost its text");
  const fonts = await page.evaluate(() => document.fonts.ready.then((all) => [...all].length));
  expect(fonts > 0, "the fonts are gone");
  const lab = await Lab.live(page, "lab-1");
  await lab.button("Play").first().click();
  await lab.runs();

  await reader.find("cart");
  await page.keyboard.press("Escape");

  await reader.go("search.html?q=cart");
  await page.locator(".search-result").first().waitFor();

  await reader.go(unread);
  const said = await reader.text();
  expect(said.includes(`${unread} is not kept here`), `of an unread page it says: ${said}`);
  await page.locator(".kept-pages a").first().waitFor();
  const kept = await page.locator(".kept-pages a").allInnerTexts();
  expect(kept.join() === "1.1 Four labs on one page", `it lists ${kept}`);
  expect((await page.title()).startsWith("On this device"), `its title is ${await page.title()}`);
}

async function keepWhole(reader) {
  const { page } = reader;
  await reader.go("offline.html");
  const button = page.getByRole("button", { name: /^Keep the whole course .*\(\d+\.\d MB\)$/ });
  await button.click();
  await page.getByText("The whole course is kept on this device.").waitFor();
  expect(await button.isHidden(), "what is kept is offered again");
}

// The second edition has come, and this page is of the first.
async function seeNewer(reader) {
  const { page } = reader;
  await reader.go(read);
  const bar = page.locator(".newer");
  await bar.getByText("A newer version of this course is there.").waitFor();
  expect((await bar.getAttribute("role")) === "status", "nobody is told of a newer version");
  expect(!(await reader.text()).includes("The second edition"), "a kept page has changed");
  const strange = await page.evaluate(
    (address) =>
      fetch(address).then(
        ({ status }) => `${status}`,
        () => "refused",
      ),
    reader.root + newPicture,
  );
  expect(strange === "refused", `for a picture of the second edition, the first gets ${strange}`);
  const { height } = await bar.getByRole("button").boundingBox();
  expect(height >= 24, `its button is ${height} px high`);
  await bar.getByRole("button").focus();
  await Promise.all([page.waitForEvent("load"), page.keyboard.press("Enter")]);
  await page.getByText("The second edition.").waitFor();
  expect((await bar.innerText()) === "", "it is announced when it is there");
  const names = await page.evaluate(() => caches.keys());
  expect(names.length === 1, `it keeps ${names}`);
}

// Whatever is kept has the bytes of the site as it is now.
async function isPure(reader, where) {
  const kept = await reader.page.evaluate(async (root) => {
    const found = [];
    for (const name of await caches.keys()) {
      const cache = await caches.open(name);
      for (const request of await cache.keys()) {
        const bytes = await (await cache.match(request)).arrayBuffer();
        const hash = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
        found.push([request.url.slice(root.length), [...hash].join()]);
      }
    }
    return found;
  }, reader.root);
  const hashOf = (path) => [...createHash("sha256").update(readFileSync(path)).digest()].join();
  const files = kept.filter(([path]) => path !== ".all");
  expect(files.length > 10, `${where}: only ${files.length} files are kept`);
  const strange = files.filter(([path, hash]) => hashOf(join(home, "site", path)) !== hash);
  expect(strange.length === 0, `${where}: of another edition are ${strange.map(([path]) => path)}`);
}

async function test(browser) {
  buildBoth();
  deploy("first");
  const site = join(home, "site");
  let server = await serve(site);
  const { port } = new URL(server.root);
  const reader = await Reader.come(browser, server.root);
  const goOffline = () => {
    reader.isForgiving = true;
    server.close();
  };
  const goOnline = async () => {
    server = await serve(site, { port: Number(port) });
    reader.isForgiving = false;
  };

  await reader.go(read);
  await Lab.live(reader.page, "lab-1");
  await reader.isKept();
  goOffline();
  await readWithoutNetwork(reader);

  await goOnline();
  await reader.page.getByRole("link", { name: "Try again" }).click();
  await reader.page.waitForURL(`**/${unread}`, { waitUntil: "networkidle" });

  // A page that was not kept is the new one, and so is all that it shows.
  deploy("second");
  await reader.go(docked);
  expect((await reader.text()).includes("The second edition"), "a new page is the old one");
  await reader.picturesAreThere();
  await reader.find("edition"); // the first one's search knows no such word
  await seeNewer(reader);
  await reader.page.waitForLoadState("networkidle");

  await keepWhole(reader);
  await isPure(reader, "the whole course");
  goOffline();
  for (const path of [unread, docked, "models/cart.html", "verification.html", "index.html"]) {
    await reader.go(path);
    await reader.picturesAreThere();
    expect(
      !reader.page.url().includes("offline.html"),
      `${path} is not kept with the whole course`,
    );
  }
  await goOnline();
  // Who has all of it, has all of the next one.
  deploy("first");
  await reader.go("index.html");
  const button = reader.page.locator(".newer button");
  await Promise.all([reader.page.waitForEvent("load"), button.click()]);
  await isPure(reader, "the next edition");
  goOffline();
  await reader.go(unread);
  expect(!(await reader.text()).includes("The second edition"), "the next edition is the old one");
}

const browser = await launch();
try {
  await test(browser);
} catch (error) {
  problems.push(`the test was broken off: ${error.stack}`);
} finally {
  await browser.close();
  rmSync(home, { recursive: true });
}
for (const problem of problems) console.error(problem);
console.log(`${problems.length} problems`);
process.exit(problems.length > 0 ? 1 : 0);
