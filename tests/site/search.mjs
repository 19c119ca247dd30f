// The search finds a section by its words, also misspelt, MuJoCo's names by their parts, and models,
// and opens there; with the keyboard alone, on a phone, and on a page that was opened from the disk.
// A page of its own shows all that is found, at an address that holds the words.
// Single keys turn pages, never while somebody types, and can be switched off.

import { join } from "node:path";
import { pathToFileURL } from "node:url";

import { violations } from "./axe.mjs";
import { folder, testSite } from "./browser.mjs";
import { mostShifted, shiftOf } from "./shift.mjs";

const lesson = "1-state/1.2-generalized-coordinates.html";

// What is typed, and how the address ends that must be found first.
const wanted = [
  ["adding a small vector leaves the sphere", "#integrating-positions"],
  ["quaternoin", "#quaternion"],
  ["joint_zoo", "models/joint_zoo.html"],
  ["integratepos", "api.html#mj_integratePos"],
  ["mj_differentiatePos", "api.html#mj_differentiatePos"],
];

const field = (page) => page.getByRole("combobox", { name: "Search this course" });
const options = (page) => page.getByRole("option");

async function look(page, words) {
  await field(page).fill(words);
  await page.waitForFunction(() =>
    /result|Nothing/.test(document.querySelector(".search-status").textContent),
  );
  const chosen = await field(page).getAttribute("aria-activedescendant");
  return chosen === null ? null : page.locator(`#${chosen}`);
}

async function findsAll(visitor, page, where) {
  for (const [words, end] of wanted) {
    const first = await look(page, words);
    const href = (await first?.getAttribute("href")) ?? "nothing";
    visitor.expect(href.includes(end), where, `“${words}” finds ${href}`);
    const marks = await first?.locator("mark").count();
    visitor.expect(marks > 0, where, `what “${words}” finds is not marked`);
  }
  const nothing = await look(page, "xyzzyplugh");
  visitor.expect(nothing === null, where, "something is found for a word that is not there");
}

async function isAccessible(visitor, page, where) {
  for (const violation of await violations(page)) visitor.complain(where, violation);
}

async function opensAtSection(visitor, page, where) {
  await look(page, "quaternion");
  const before = await field(page).getAttribute("aria-activedescendant");
  await page.keyboard.press("ArrowDown");
  const after = await field(page).getAttribute("aria-activedescendant");
  visitor.expect(before !== after, where, "the arrow chooses nothing");
  const href = await page.locator(`#${after}`).getAttribute("href");
  await page.keyboard.press("Enter");
  await page.waitForURL(href);
  const there = await page.evaluate(() => document.querySelector(":target") !== null);
  visitor.expect(there === href.includes("#"), where, `${href} is not where its link leads`);
}

// A reader who knows the key does not wait for what it opens.
async function takesWhatIsTyped(visitor, page, where) {
  await page.route("**/search-*.js", async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 300));
    await route.continue();
  });
  const here = page.url();
  for (const key of ["/", "q", "u", "x", "Backspace", "a", "]", "Backspace"]) {
    await page.keyboard.press(key);
  }
  visitor.expect((await field(page).count()) === 0, where, "the search came too soon for this");
  await field(page).waitFor();
  await page.keyboard.type("ternion");
  const words = await field(page).inputValue();
  visitor.expect(words === "quaternion", where, `of “quaternion” the field has “${words}”`);
  visitor.expect(page.url() === here, where, "what is typed turns the page");
  await page.unrouteAll({ behavior: "wait" });
}

async function turnsPages(visitor, page, where) {
  const next = await page.locator("a[rel=next]").first().getAttribute("href");
  await page.keyboard.press("?");
  const single = page.getByRole("checkbox", { name: "Single keys act" });
  await single.waitFor(); // what opens it comes at its first use
  await isAccessible(visitor, page, `${where}, the keys`);
  await page.keyboard.press("]");
  visitor.expect(await single.isVisible(), where, "a key acts behind the open dialog");
  await single.uncheck();
  await page.keyboard.press("Escape");
  const here = page.url();
  for (const key of ["]", "/", "?"]) await page.keyboard.press(key);
  visitor.expect((await page.locator("dialog[open]").count()) === 0, where, "a key is not off");
  await page.keyboard.press("Control+k");
  await field(page).press("End");
  await field(page).press("]");
  visitor.expect((await field(page).inputValue()).endsWith("]"), where, "] cannot be typed");
  await page.getByRole("button", { name: "Keys of this site" }).click();
  await single.check();
  await page.keyboard.press("Escape");
  visitor.expect(page.url() === here, where, "a key that is off turns the page");
  await page.keyboard.press("Control+]");
  await page.keyboard.press("]");
  await page.waitForURL((url) => url.href.endsWith(next.replace("../", "")));
  await page.waitForLoadState("networkidle");
  await page.keyboard.press("[");
  await page.waitForURL(here);
  await page.waitForLoadState("networkidle");
}

const found = (page) => page.locator(".search-place li a");
const hasFound = (page, end) =>
  page.locator(`.search-place li a[href$="${end}"]`).first().waitFor();

// From the dialog to the page, which a link leads to and a browser comes back to.
async function findsOnPage(visitor, page, where) {
  await page.keyboard.press("/");
  await look(page, "the");
  await page.getByRole("link", { name: "As a page" }).click();
  await page.waitForURL(/search\.html\?q=the$/);
  await found(page).first().waitFor();
  const count = await found(page).count();
  await page.getByRole("button", { name: "More results" }).click();
  visitor.expect((await found(page).count()) > count, where, "there are no more results");
  const box = page.getByRole("searchbox", { name: "Search this course" });
  await page.locator("h1").click();
  await page.keyboard.press("/");
  await page.keyboard.type("mj_integratePos");
  await hasFound(page, "api.html#mj_integratePos");
  await isAccessible(visitor, page, where);
  await box.press("Enter");
  visitor.expect(page.url().endsWith("?q=mj_integratePos"), where, `it is ${page.url()}`);
  await page.reload();
  await hasFound(page, "api.html#mj_integratePos");
  const shift = await shiftOf(page);
  visitor.expect(shift <= mostShifted, where, `what is on the page moves by ${shift}`);
  await box.fill("xyzzyplugh");
  await page.getByText("Nothing is found for “xyzzyplugh”.").waitFor();
}

await testSite(async (visitor) => {
  for (const [scheme, width] of [
    ["light", 1440],
    ["dark", 360],
  ]) {
    const where = `${lesson} (${scheme}, ${width} px)`;
    await visitor.visit(lesson, { scheme, width }, async (page) => {
      const early = await page.locator("script[src*='search-']").count();
      visitor.expect(early === 0, where, "the search is loaded before it is wanted");
      await page.getByRole("button", { name: "Search" }).click();
      await findsAll(visitor, page, where);
      await look(page, "quaternion velocity");
      visitor.expect((await options(page).count()) > 3, where, "one word is found in few places");
      await isAccessible(visitor, page, `${where}, the search`);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth);
      visitor.expect(!wide, where, "the page scrolls sideways");
      await page.keyboard.press("Escape");
      await page.keyboard.press("/");
      await opensAtSection(visitor, page, where);
    });
  }
  await visitor.visit(lesson, {}, (page) => takesWhatIsTyped(visitor, page, "typed at once"));
  await visitor.visit("guide/A.2-text.html", {}, (page) => turnsPages(visitor, page, "the keys"));
  await visitor.visit(lesson, {}, async (page) => {
    page.removeAllListeners("request"); // it leaves the server on purpose
    await page.goto(pathToFileURL(join(folder, lesson)).href);
    await page.keyboard.press("/");
    await findsAll(visitor, page, "from the disk");
    await opensAtSection(visitor, page, "from the disk");
  });
  for (const [scheme, width] of [
    ["light", 360],
    ["dark", 1440],
  ]) {
    const where = `search.html (${scheme}, ${width} px)`;
    await visitor.visit(lesson, { scheme, width }, (page) => findsOnPage(visitor, page, where));
  }
  await visitor.visit("search.html", { javaScript: false }, async (page) => {
    const way = page.locator("main").getByRole("link", { name: "Glossary" });
    visitor.expect(await way.isVisible(), "search.html", "without JavaScript it leads nowhere");
  });
  await visitor.visit(lesson, { javaScript: false }, async (page) => {
    const buttons = await page.getByRole("button", { name: "Search" }).count();
    visitor.expect(buttons === 0, lesson, "without JavaScript there is a search that does nothing");
  });
});
