// A developer of the site itself sees its styles and templates as they are saved, without a reload.
//
//   node tests/preview/styles.mjs MJCOURSE COURSE SITE ASSETS

import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { checkOut } from "./checkout.mjs";
import { preview } from "./previewed.mjs";

const [mjcourse, folder, site, assets] = process.argv.slice(2);

const address = "1-first/1.1-everything.html";
const checkout = checkOut(site, assets);
const style = join(checkout.site, "browser/styles/prose.css");
const template = join(checkout.site, "press/templates/lesson.hbs");
const edit = (file, change) => writeFileSync(file, change(readFileSync(file, "utf8")));
const panel = (page) => page.locator(".preview-panel");
const isClean = (page) => panel(page).getByText("up to date", { exact: true }).waitFor();

async function stylesSwap(previewed, page) {
  const value = () =>
    page.evaluate(() => getComputedStyle(document.body).getPropertyValue("--tried").trim());
  const becomes = async (wanted) => {
    for (let i = 0; i < 100 && (await value()) !== wanted; i++) await page.waitForTimeout(100);
    previewed.expect((await value()) === wanted, `--tried is ${await value()}, not ${wanted}`);
  };
  const good = readFileSync(style, "utf8");
  writeFileSync(style, `${good}\nbody {\n  --tried: once;\n}\n`);
  await becomes("once");
  const sheets = await page.locator("link[href*='assets/site-']").count();
  previewed.expect(sheets === 1, `the page has ${sheets} stylesheets of the site`);
  // Beside a mistake the page stays as it was.
  writeFileSync(style, `${good}\nbody {\n  --tried: twice;\n  color red;\n}\n`);
  await panel(page).getByText("[E-style]").waitFor();
  await panel(page).getByText("site/browser/styles/prose.css:").first().waitFor();
  await becomes("once");
  writeFileSync(style, good);
  await becomes("");
  await isClean(page);
}

// In all its blocks of rules.
const rulesOf = (page) =>
  page.evaluate(() =>
    [...document.styleSheets]
      .filter(({ href }) => href?.includes("assets/site-"))
      .flatMap(({ cssRules }) => [...cssRules].map(({ cssText }) => cssText))
      .join("\n"),
  );

// Rules are replaced where they are; a page that is loaded has them from a file.
async function rulesAreThoseOfALoadedPage(previewed, page) {
  const good = readFileSync(style, "utf8");
  const rule = ".tried {\n  color: red;\n}\n";
  const saves = [
    good + rule,
    rule + good,
    `@media print {\n  .a {\n    color: red;\n  }\n  .b {\n    color: blue;\n  }\n}\n${rule}${good}${rule}`,
    `@media print {\n  .b {\n    color: blue;\n  }\n}\n${good}`,
    good.slice(good.lastIndexOf("\n}\n", good.length / 2) + 3),
    "",
    good,
  ];
  for (const save of saves) {
    const { stylesheet } = await previewed.state(address);
    writeFileSync(style, save);
    const hasChanged = async () => (await previewed.state(address)).stylesheet !== stylesheet;
    for (let i = 0; i < 100 && !(await hasChanged()); i++) await page.waitForTimeout(50);
    const loaded = await previewed.open(address);
    const wanted = await rulesOf(loaded);
    for (let i = 0; i < 40 && (await rulesOf(page)) !== wanted; i++) await page.waitForTimeout(50);
    previewed.expect((await rulesOf(page)) === wanted, `not the rules of ${save.slice(0, 60)}`);
    await loaded.close();
  }
}

async function templatesFollow(previewed, page) {
  const good = readFileSync(template, "utf8");
  edit(template, (text) => text.replace("<h1>{{title}}</h1>", "<h1>{{title}}!</h1>"));
  await page.locator("h1", { hasText: "Something of everything!" }).waitFor();
  edit(template, (text) => text.replace("{{title}}!", "{{titel}}"));
  await panel(page).getByText("[E-template]").waitFor();
  await panel(page).getByText("site/press/templates/lesson.hbs:").first().waitFor();
  await page.locator("h1", { hasText: "Something of everything!" }).waitFor();
  writeFileSync(template, good);
  await page.getByRole("heading", { name: "Something of everything", exact: true }).waitFor();
  await isClean(page);
}

try {
  await preview(mjcourse, folder, async (previewed) => {
    await previewed.settled();
    const page = await previewed.open(address);
    await isClean(page);
    await page.evaluate(() => (document.body.dataset.loaded = "once"));
    await stylesSwap(previewed, page);
    await rulesAreThoseOfALoadedPage(previewed, page);
    await templatesFollow(previewed, page);
    const loaded = await page.evaluate(() => document.body.dataset.loaded);
    previewed.expect(loaded === "once", "the page was loaded again");
  });
} finally {
  checkout.remove();
}
