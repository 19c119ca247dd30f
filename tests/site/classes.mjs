// A lesson's HTML may have any `class`. Whatever it calls itself, and wherever it stands, no button of its page
// is missing, and each does as it does without it.
//
//   node tests/site/classes.mjs SITE
//
// The site is that of tests/site/appearance-course. What an author could write is put into its pages on their way to
// the browser. No styles come with them: how things look is for an author to change.

import { globSync, readFileSync } from "node:fs";
import path from "node:path";

import { folder, testSite } from "./browser.mjs";
import { press } from "./buttons.mjs";

const sources = path.resolve(import.meta.dirname, "../../site");
const lesson = "1-motion/1.1-a-pendulum.html";

// All that the site's own templates and scripts call anything.
function classes() {
  const files = globSync(["press/templates/*.hbs", "browser/**/*.ts"], { cwd: sources });
  const names = files.flatMap((file) => {
    const text = readFileSync(path.join(sources, file), "utf8");
    const written = [...text.matchAll(/class(?:Name)?(?:=|: | = )"([^"{]*)/g)];
    const sought = [...text.matchAll(/["'`(, ]\w*\.([a-z][a-z-]+)(?=["'`)\[: >,])/g)];
    return [...written.flatMap(([, list]) => list.split(" ")), ...sought.map(([, name]) => name)];
  });
  return [...new Set(names)].filter((name) => /^[a-z][a-z-]+$/.test(name)).sort();
}

const all = classes();
const named = (make) => all.map(make).join("");
const within = named((name) => `<span class="${name}"></span>`);
const blocks = named(
  (name) =>
    `<div class="${name}"></div><details class="${name}"></details>` +
    `<ul class="${name}"><li></li></ul><figure class="${name}"></figure>`,
);
const wrapper = `<div class="${all.join(" ")}">`;

// Where a course's own HTML stands in a page: what comes before it, and what may be written there.
const places = [
  [/<div class="prose">/g, within + blocks],
  [/<p class="summary">/g, within],
  [/<legend><span class="number">\d+<\/span> /g, within + blocks],
  [/<details class="hint">\s*<summary>Hint<\/summary>\s*<div>/g, within + blocks],
  [/<div class="explain">/g, within + blocks],
  [/<label for="[^"]*"><span class="letter">\w<\/span> <span>/g, within],
  [/<div class="lab-asked[^"]*"><p class="lab-label">[^<]*<\/p>/g, within + blocks],
  [/<figcaption>(?=[^<]*<span class="plot-source">)/g, within],
  [/<span class="callout-title">/g, within],
];

function addTo(html) {
  return places.reduce(
    (text, [place, added]) => text.replace(place, (found) => found + added),
    html,
  );
}

function wrap(html) {
  const [begin, end] = ['<div class="prose">', '</div>\n<footer class="lesson-foot">'];
  return html.replace(begin, begin + wrapper).replace(end, `</div>${end}`);
}

// Serves each text as `change` has it, and no styles and fonts.
const serving = (change) => (page) =>
  page.route("**/*", async (route) => {
    const { pathname } = new URL(route.request().url());
    if (pathname.endsWith(".css")) return route.fulfill({ contentType: "text/css", body: "" });
    if (!/\.html$|\/review\/[^/]*\.js$/.test(pathname)) return route.continue();
    const response = await route.fetch();
    const text = (await response.text()).replace(/ data-fonts="[^"]*"/g, "");
    return route.fulfill({ response, body: change(text) });
  });

// Also of the review's questions, which a script brings.
const inQuestions = (change) => (text) =>
  text.replace(/"html":("(?:[^"\\]|\\.)*")/g, (_, html) => {
    return `"html":${JSON.stringify(change(JSON.parse(html)))}`;
  });

async function buttonsOf(visitor, change) {
  let told;
  const both = (text) => (text.startsWith("globalThis") ? inQuestions(change)(text) : change(text));
  const options = { savesData: true, before: serving(both) };
  await visitor.visit(lesson, options, async (page) => {
    await page.waitForLoadState("networkidle");
    told = await page.evaluate(press);
    await page.goto(visitor.address("review.html"));
    await page.waitForLoadState("networkidle");
    await page.evaluate(() => document.querySelector("form > .answer > summary").click());
    const next = await page.locator("button.next-card").count();
    told += `\nin the review, ${next} button for the next`;
  });
  return told;
}

await testSite(async (visitor) => {
  const plain = await buttonsOf(visitor, (text) => text);
  visitor.expect(plain.split("\n").length > 20, lesson, `it has no buttons but ${plain}`);
  visitor.expect(plain.endsWith("in the review, 1 button for the next"), lesson, plain);
  const html = readFileSync(path.join(folder, lesson), "utf8");
  for (const [place] of places) {
    visitor.expect(html.search(place) >= 0, lesson, `nothing of it is at ${place}`);
  }
  visitor.expect(wrap(html) !== html, lesson, "its text is not found");
  const changes = { "with HTML of all classes": addTo, "in an element of all classes": wrap };
  for (const [how, change] of Object.entries(changes)) {
    const told = await buttonsOf(visitor, change);
    visitor.expect(told === plain, lesson, `${how}:\n${told}\ninstead of\n${plain}`);
  }
});
