// What a reader's browser remembers: how far a lesson was read, that it is done, the way back from the
// home page; exported, forgotten, imported, it is the same; what is no such file changes nothing; where
// nothing can be remembered, all pages work.
//
//   node tests/site/progress.mjs SITE

import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

import { folder, pages, testSite } from "./browser.mjs";
import { violations } from "./axe.mjs";
import { answerRightly } from "./learner.mjs";
import { mostShifted, shiftOf } from "./shift.mjs";

const lesson = pages.find((path) => /^\d/.test(path));
const kept = (page) => page.evaluate(() => JSON.stringify(Object.entries(localStorage).sort()));
const signs = (page, selector) => page.locator(`${selector} .reading-sign`);

await testSite(async (visitor) => {
  const say = (where) => (good, what) => visitor.expect(good, where, what);
  await visitor.visit(lesson, {}, async (page) => {
    page.removeAllListeners("requestfailed"); // a lab that came near may be on its way
    const go = async (path) => {
      await page.waitForLoadState("networkidle"); // what is broken off counts as failed
      await page.goto(visitor.address(path));
    };
    const section = await readOn(page, say(lesson));
    await go("index.html");
    await tryContinue(visitor, page, section);
    await go(lesson);
    await tryDone(page, say(lesson));
    await go("progress.html");
    await tryFiles(page, say("progress.html"));
  });
  await tryGarbage(visitor);
  for (const path of [lesson, "index.html", "progress.html"]) await tryForbidden(visitor, path);
  await tryDisk(visitor);
});

// Scrolls to the third section; gives its heading.
async function readOn(page, expect) {
  const sign = page.locator(".lessons [aria-current] .reading-sign");
  await sign.waitFor();
  expect((await sign.getAttribute("class")).includes("started"), "a lesson is not begun");
  expect((await sign.innerText()).includes("started"), "the sign has no words");
  const heading = page.locator(".prose h2").nth(2);
  await heading.evaluate((h) => h.scrollIntoView({ behavior: "instant" }));
  await page.waitForFunction(() =>
    Object.keys(localStorage).some(
      (key) => key.startsWith("mjcourse.reading") && JSON.parse(localStorage[key]).place > 2,
    ),
  );
  await page.evaluate(() => scrollTo({ top: 0, behavior: "instant" }));
  const [reading] = await page.evaluate(() =>
    Object.keys(localStorage)
      .filter((key) => key.startsWith("mjcourse.reading"))
      .map((key) => JSON.parse(localStorage[key])),
  );
  expect(!reading.ended, "the end of a lesson is reached at its beginning");
  return reading;
}

async function tryContinue(visitor, page, { name, section, heading }) {
  const expect = (good, what) => visitor.expect(good, "index.html", what);
  const link = page.locator(".continue a");
  const text = await page.locator(".continue").innerText();
  expect(text === `Continue: ${name}, ${heading}`, `it offers "${text}"`);
  const shift = await shiftOf(page);
  expect(shift <= mostShifted, `what is on the page moves by ${shift}`);
  expect((await signs(page, ".card h3").count()) === 1, "not one card has a sign");
  await page.waitForLoadState("networkidle");
  await link.click();
  await page.waitForURL(`**/${lesson}#*`);
  const { hash } = new URL(page.url());
  expect(decodeURIComponent(hash.slice(1)) === section, `it leads to ${hash}`);
}

// Done by reading to the end and answering; undone and done again by the button.
async function tryDone(page, expect) {
  const foot = page.locator(".done-mark");
  const button = foot.getByRole("button");
  const state = () => page.locator(".lessons [aria-current] .reading-sign").innerText();
  await page.locator(".turn").evaluate((t) => t.scrollIntoView({ behavior: "instant" }));
  await page.locator(".lessons [aria-current] .ended").waitFor();
  expect((await state()).includes("read to the end"), "the end is not reached");
  for (const question of await page.locator("form.question").all()) {
    expect((await button.innerText()) === "Mark as done", "done before all is answered");
    await answerRightly(question);
  }
  expect((await state()).includes("done"), "right answers do not finish a lesson");
  await button.click();
  expect((await state()).includes("read to the end"), "the reader is not believed");
  await button.press("Enter");
  expect((await foot.innerText()).includes("This lesson is done."), "the button does nothing");
  const { height } = await button.boundingBox();
  expect(height >= 24, `the button is ${height} px high`);
}

async function tryFiles(page, expect) {
  const row = page.locator(`tr[data-lesson="${lesson}"]`);
  const told = page.getByRole("status");
  const right = await row.locator(".right-answers").innerText();
  expect(
    (await row.locator(".lesson-state").innerText()) === "done",
    "the table does not say done",
  );
  const exercises = await row.locator('[data-kind="exercise"]').count(); // none is solved
  const [answered, all] = right.split(" of ").map(Number);
  expect(answered + exercises === all, `it counts ${right} right answers`);
  for (const violation of await violations(page)) expect(false, violation);

  const before = await kept(page);
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Export" }).click(),
  ]);
  const file = await download.path();
  const reset = page.getByRole("button", { name: "Reset" });
  await reset.click();
  await page.getByRole("button", { name: "Keep it" }).click();
  expect((await kept(page)) === before, "it forgets what is to be kept");
  await reset.click();
  for (const violation of await violations(page)) expect(false, violation);
  await page.getByRole("button", { name: "Forget it" }).click();
  await told.filter({ hasText: "Forgotten" }).waitFor();
  expect((await kept(page)) === "[]", `it keeps ${await kept(page)}`);
  expect((await row.locator(".lesson-state").innerText()) === "not opened", "the table is old");

  const importFile = async (name, buffer) => {
    await page.getByLabel("Import").setInputFiles({ name, mimeType: "application/json", buffer });
    await told.filter({ hasText: "mported" }).waitFor();
    return told.innerText();
  };
  await importFile("p.json", readFileSync(file));
  expect((await kept(page)) === before, "what was exported and imported differs");
  await tryMerge(page, expect, importFile, readFileSync(file, "utf8"));
}

// Of what is here and in the file, the better stays.
async function tryMerge(page, expect, importFile, text) {
  const before = await kept(page);
  const worse = JSON.parse(text);
  const { reading, answers } = worse.lessons[lesson];
  Object.assign(reading, { place: 1, done: false, ended: false });
  for (const id of Object.keys(answers)) {
    answers[id] = { given: ["7777777"], missed: true, shown: false };
  }
  worse.lessons["9-none/9.9-none.html"] = { answers: {} };
  const told = await importFile("worse.json", Buffer.from(JSON.stringify(worse)));
  expect((await kept(page)) === before, "a worse file takes something away");
  expect(told.includes("1 that this course has not"), `of a strange lesson it says "${told}"`);
}

async function tryGarbage(visitor) {
  const head = { format: "mjcourse progress", version: 1, last: "" };
  const broken = { reading: { name: 1 }, answers: {} };
  const files = [
    ["not JSON", "is not JSON", "{"],
    ["a list", "not exported", "[]"],
    ["newer", "another version", JSON.stringify({ ...head, version: 2, lessons: {} })],
    ["without lessons", "missing", JSON.stringify(head)],
    ["of another course", "no lesson", JSON.stringify({ ...head, lessons: {} })],
    ["broken", lesson, JSON.stringify({ ...head, lessons: { [lesson]: broken } })],
  ];
  const before = (page) =>
    page.addInitScript((path) => {
      localStorage.setItem(`mjcourse.reading.v1:/some/course/${path}`, "{garbage");
    }, lesson);
  await visitor.visit("progress.html", { before }, async (page) => {
    const stored = await kept(page);
    for (const [name, reason, text] of files) {
      const file = { name, mimeType: "application/json", buffer: Buffer.from(text) };
      await page.getByLabel("Import").setInputFiles(file);
      const told = page.getByRole("status").filter({ hasText: `from ${name}: ` });
      const said = await told.innerText();
      visitor.expect(said.includes(reason), "progress.html", `of a file ${name} it says "${said}"`);
      visitor.expect((await kept(page)) === stored, "progress.html", `takes of a file ${name}`);
    }
  });
}

async function tryForbidden(visitor, path) {
  const before = (page) =>
    page.addInitScript(() => {
      Object.defineProperty(window, "localStorage", {
        get: () => {
          throw new DOMException("no", "SecurityError");
        },
      });
    });
  await visitor.visit(path, { before }, async (page) => {
    if (path !== "progress.html") return;
    const told = await page.getByRole("status").innerText();
    visitor.expect(told.includes("remember nothing"), path, `without storage it says "${told}"`);
  });
}

async function tryDisk(visitor) {
  await visitor.visit("index.html", {}, async (page) => {
    await page.waitForLoadState("networkidle");
    page.removeAllListeners("request"); // the disk is outside of the site
    await page.goto(`${pathToFileURL(folder)}/${lesson}`);
    await page.locator(".lessons [aria-current] .reading-sign").waitFor();
    page.removeAllListeners("requestfailed"); // pictures that are still on their way
    await page.goto(`${pathToFileURL(folder)}/progress.html`);
    const state = await page.locator(`tr[data-lesson="${lesson}"] .lesson-state`).innerText();
    visitor.expect(state.startsWith("started"), "from the disk", `the lesson is ${state}`);
  });
}
