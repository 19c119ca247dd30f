// What comes to a page from outside, its address and what the browser remembers, costs it nothing: each
// button does as it does at the page's own address, and the browser complains of nothing. A part that
// fails all the same costs the page that part alone.
//
//   node tests/site/outside.mjs SITE
//
// The site is that of tests/site/appearance-course.

import { testSite } from "./browser.mjs";
import { press } from "./buttons.mjs";

const lesson = "1-motion/1.1-a-pendulum.html";
const others = ["index.html", "progress.html", "review.html", "search.html", "offline.html"];
const addresses = ["#%", "#%ff", "#run:%:%", "#run:examples/period.cpp:1%", "?lab=%&page=%#%"];

// What the browser gives for each key of the site, as a function's text; and one that gives nothing.
const reading = {
  ...{ name: "a", section: "\ud800", heading: "b", place: 1, ended: false, done: false },
  ...{ given: ["\ud800", "z"], missed: true, shown: true, review: { box: 1, due: "9999-99-99" } },
};
const storages = {
  broken: `() => "{"`,
  empty: `() => "null"`,
  strange: `(key) => key.startsWith("mjcourse.last") ? "/some/course/${lesson}" : ${JSON.stringify(JSON.stringify(reading))}`,
};

const gives = (storage) => (page) =>
  page.addInitScript(`Storage.prototype.getItem = ${storages[storage]}`);
const refuses = (page) =>
  page.addInitScript(() => {
    const get = () => {
      throw new DOMException("denied", "SecurityError");
    };
    for (const name of ["localStorage", "caches"]) Object.defineProperty(window, name, { get });
  });

async function buttonsOf(visitor, path, before) {
  let told;
  await visitor.visit(path, { savesData: true, before }, async (page) => {
    await page.waitForLoadState("networkidle");
    told = await page.evaluate(press);
  });
  return told;
}

async function compare(visitor, path, own, how, before) {
  const told = await buttonsOf(visitor, path, before);
  visitor.expect(told === own, path, `${how}:\n${told}\ninstead of\n${own}`);
}

async function tryEach(visitor) {
  for (const path of [lesson, ...others]) {
    const own = await buttonsOf(visitor, path);
    visitor.expect(own.includes(" acts"), path, `no button acts: ${own}`);
    const few = path === lesson ? 0 : -1;
    for (const address of addresses.slice(few)) {
      await compare(visitor, path + address, own, "at this address");
    }
    for (const storage of few ? [] : ["broken", "empty"]) {
      await compare(visitor, path, own, `with ${storage} storage`, gives(storage));
    }
    await compare(visitor, path, own, "without storage", refuses);
    await strangely(visitor, path);
  }
}

// What was answered has its solution unfolded, and so on.
async function strangely(visitor, path) {
  await visitor.visit(path, { savesData: true, before: gives("strange") }, async (page) => {
    await page.waitForLoadState("networkidle");
    const text = await page.locator("main").innerText();
    visitor.expect(!text.includes("Invalid"), path, `with strange storage: ${text}`);
    const told = await page.evaluate(press);
    visitor.expect(told.includes(" acts"), path, `with strange storage: ${told}`);
    if (path !== "index.html") return;
    const ways = await page.locator(".continue a").count();
    visitor.expect(ways === 1, path, "with strange storage there is no way back to the lesson");
  });
}

// Each of these breaks one part of the page's script, which the browser is told; the parts behind it are
// there.
async function tryParts(visitor) {
  const breakers = [
    () => (globalThis.ResizeObserver = undefined),
    () => (String.prototype.trimEnd = undefined),
  ];
  for (const breaker of breakers) {
    const errors = [];
    const before = async (page) => {
      page.removeAllListeners("pageerror");
      page.on("pageerror", ({ message }) => errors.push(message));
      await page.addInitScript(breaker);
    };
    await visitor.visit(lesson, { savesData: true, before }, async (page) => {
      await page.waitForLoadState("networkidle");
      for (const name of [/^Use the dark theme/, "Mark as done", "Check", /^Edit and run/]) {
        const count = await page.getByRole("button", { name }).count();
        visitor.expect(count > 0, lesson, `when ${breaker} broke a part, there is no ${name}`);
      }
    });
    visitor.expect(errors.length === 1, lesson, `${breaker} gives ${errors.length} errors`);
  }
}

async function tryFiles(visitor) {
  const path = "progress.html";
  await visitor.visit(path, {}, async (page) => {
    const imported = async (text) => {
      const file = { name: "a.json", mimeType: "application/json", buffer: Buffer.from(text) };
      await page.locator(".told").evaluate((told) => (told.textContent = ""));
      await page.locator("input[type=file]").setInputFiles(file);
      const told = page.locator(".told").filter({ hasText: /./ });
      return told.innerText();
    };
    const about = { format: "mjcourse progress", version: 1, last: lesson };
    const of = (kept) =>
      JSON.stringify({ ...about, lessons: { [lesson]: { reading: kept, answers: {} } } });
    const good = {
      name: "a",
      section: "\ud800",
      heading: "b",
      place: 1,
      ended: false,
      done: false,
    };
    const answers = [
      [
        of({ ...good, place: 0.5 }).replace("0.5", "1e999"),
        `what it says of ${lesson} cannot be read`,
      ],
      [" ".repeat(17 << 20), "it is larger than 16 MiB"],
    ];
    for (const [text, why] of answers) {
      const said = await imported(text);
      visitor.expect(said === `Nothing was imported from a.json: ${why}.`, path, said);
    }
    const said = await imported(of(good));
    visitor.expect(said === "Imported: lessons 1.", path, said);
    await page.goto(visitor.address("index.html"));
    await page.locator(".continue a").waitFor();
  });
}

// The first 300 characters are looked for; a page is asked for again only where it is the site's.
async function tryQueries(visitor) {
  const many = "zzzzzz ".repeat(50);
  const search = `search.html?q=${encodeURIComponent(`${many}pendulum`)}`;
  await visitor.visit(search, {}, async (page) => {
    const said = await page.locator(".search-status").filter({ hasText: /./ }).innerText();
    visitor.expect(said.startsWith("Nothing is found for"), search, said);
  });
  const asked = { "../../other": false, "//example.org/": false, "https://example.org": false };
  for (const [page, shown] of Object.entries({ ...asked, [lesson]: true })) {
    const path = `offline.html?page=${encodeURIComponent(page)}`;
    await visitor.visit(path, {}, async (opened) => {
      await opened.waitForLoadState("networkidle");
      const isShown = await opened.locator(".not-kept").isVisible();
      visitor.expect(isShown === shown, path, `it offers ${page}: ${isShown}`);
    });
  }
}

await testSite(async (visitor) => {
  await tryEach(visitor);
  await tryParts(visitor);
  await tryFiles(visitor);
  await tryQueries(visitor);
});
