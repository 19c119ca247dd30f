// What an author sees while writing: what is saved is there, what was not touched stays, mistakes are
// shown where they are and go when they are mended.

import { mkdirSync, renameSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { request } from "node:http";
import { dirname } from "node:path";

import { preview } from "./previewed.mjs";

const [mjcourse, folder] = process.argv.slice(2);
const lesson = "content/1-first/1.1-everything.md";
const address = "1-first/1.1-everything.html";

// Resolves when the page says `text`, or does not any more.
const says = (page, text) => page.locator("main", { hasText: text }).waitFor();
const saysNot = (page, text) =>
  page.locator("main", { hasText: text }).waitFor({ state: "detached" });
const panel = (page) => page.locator(".preview-panel");
const isClean = (page) => panel(page).getByText("up to date", { exact: true }).waitFor();

function ask(previewed, path, headers) {
  const { port } = new URL(previewed.root);
  return new Promise((answered) => {
    request({ host: "127.0.0.1", port, path, headers }, (answer) => {
      let body = "";
      answer.on("data", (text) => (body += text));
      answer.on("end", () => answered({ status: answer.statusCode, body }));
    }).end();
  });
}

async function whatIsAroundStays(previewed, page) {
  const lab = page.locator("sim-lab");
  // A smooth scroll that is still under way would be taken for a page that moves.
  await page.evaluate(() => (document.documentElement.style.scrollBehavior = "auto"));
  await lab.scrollIntoViewIfNeeded();
  await page.locator("sim-lab[data-live]").waitFor();
  await lab.getByRole("button", { name: "Push", exact: true }).click();
  await lab.locator(".lab-play").click();
  await page.locator("details.callout > summary").click();
  await page.locator("form.question input").fill("17");
  const before = await page.evaluate(() => {
    document.querySelector("sim-lab").touched = true;
    scrollTo({ top: document.querySelector("table").offsetTop, behavior: "instant" });
    return document.querySelector("table").getBoundingClientRect().top;
  });
  const folded = () => page.evaluate(() => document.querySelector("details.callout").open);
  const wasOpen = await folded();

  previewed.edit(
    lesson,
    "first paragraph is edited",
    `paragraph grew. ${"It is long. ".repeat(60)}`,
  );
  await says(page, "The paragraph grew.");
  previewed.edit(lesson, "below the lab is edited too", "below the lab was edited");
  await says(page, "below the lab was edited");

  const after = await page.evaluate(() => ({
    touched: document.querySelector("sim-lab").touched,
    top: document.querySelector("table").getBoundingClientRect().top,
    typed: document.querySelector("form.question input").value,
  }));
  previewed.expect(after.touched, "the lab was replaced");
  previewed.expect(Math.abs(after.top - before) < 2, `the page moved by ${after.top - before} px`);
  previewed.expect(after.typed === "17", `the answer is ${after.typed} now`);
  previewed.expect((await folded()) === wasOpen, "the callout folded");
  // It rests while nobody sees it.
  await lab.scrollIntoViewIfNeeded();
  const then = await lab.locator(".lab-time").innerText();
  await page.waitForFunction(
    (text) => document.querySelector(".lab-time").innerText !== text,
    then,
  );
}

async function outputsFollow(previewed, page) {
  const text = previewed.read(lesson);
  previewed.write("examples/say.cpp", previewed.read("examples/say.cpp").replace('"one"', '"two"'));
  previewed.write(lesson, text.replace('"one"', '"two"').replace("\none\n", "\ntwo\n"));
  await page
    .locator("figure, .example, pre", { hasText: /^two\n?$/ })
    .first()
    .waitFor();
  await isClean(page);
}

async function mistakesAreShown(previewed, page) {
  // In a program, where nothing else is lost.
  previewed.edit(lesson, 'std::puts("two");', 'std::puts("two")');
  const flag = page.locator(".preview-flag");
  await flag
    .filter({ hasText: "error, line 21: expected ‘;’" })
    .or(flag.filter({ hasText: "error, line 21: expected ';'" }))
    .waitFor();
  await panel(page).getByText("[E-example-compile]").first().waitFor();
  await says(page, "The last paragraph.");
  // Another paragraph can be written meanwhile.
  previewed.edit(lesson, "The last paragraph.", "The very last paragraph.");
  await says(page, "The very last paragraph.");
  previewed.edit(lesson, 'std::puts("two")\n', 'std::puts("two");\n');
  await flag.first().waitFor({ state: "detached" });
  await isClean(page);

  // Everything at once: the last good page stays.
  const good = previewed.read("content/course.yaml");
  previewed.write("content/course.yaml", "levels: [");
  await panel(page).getByText("content/course.yaml:1").first().waitFor();
  await says(page, "The very last paragraph.");
  previewed.write("content/course.yaml", good);
  await isClean(page);

  // Of another lesson: told, and not in the way.
  previewed.edit("content/1-first/1.2-another.md", "Another lesson.", "Another $\\lesson$.");
  await panel(page).getByText("1 error elsewhere in the course").waitFor();
  previewed.edit(lesson, "The very last", "The really last");
  await says(page, "The really last paragraph.");
  previewed.edit("content/1-first/1.2-another.md", "$\\lesson$", "lesson");
  await isClean(page);
}

async function filesComeAndGo(previewed, page) {
  // As some editors save: the old one moved away, another written, and renamed.
  const text = previewed.read(lesson);
  renameSync(previewed.path(lesson), previewed.path(`${lesson}.bak`));
  previewed.write(`${lesson}.new`, text.replace("really last", "renamed"));
  renameSync(previewed.path(`${lesson}.new`), previewed.path(lesson));
  rmSync(previewed.path(`${lesson}.bak`));
  await says(page, "The renamed paragraph.");

  // A new level in a new folder, with a draft.
  mkdirSync(previewed.path("content/2-second"));
  previewed.write("content/2-second/2.1-new.md", "---\ntitle: New\n---\n\nA new lesson.\n");
  const yaml = previewed.read("content/course.yaml");
  previewed.write(
    "content/course.yaml",
    `${yaml}  - folder: 2-second\n    title: Second\n    lessons: [2.1-new]\n`,
  );
  await page.locator(".lessons", { hasText: "2.1" }).first().waitFor();
  const fresh = await previewed.open("2-second/2.1-new.html");
  previewed.edit("content/2-second/2.1-new.md", "A new lesson.", "A newer lesson.");
  await says(fresh, "A newer lesson.");
  previewed.edit("content/2-second/2.1-new.md", "title: New\n", "title: New\ndraft: true\n");
  await panel(fresh).getByText("2.1 New").waitFor();
  await fresh.close();
  previewed.write("content/course.yaml", yaml);
  rmSync(previewed.path("content/2-second"), { recursive: true });
  await page.locator(".lessons", { hasText: "2.1" }).first().waitFor({ state: "detached" });
  await isClean(page);
}

async function picturesAreRenewed(previewed, page) {
  const picture = () =>
    page.evaluate(async () => {
      const image = document.querySelector("figure.figure img");
      const bytes = await (await fetch(image.currentSrc)).arrayBuffer();
      return new Uint8Array(await crypto.subtle.digest("SHA-256", bytes)).join();
    });
  const before = await picture();
  previewed.edit("models/swing.xml", 'size="0.03"', 'size="0.12"');
  await page.waitForFunction(() =>
    document.querySelector("figure.figure img").getAttribute("src").includes("?"),
  );
  previewed.expect((await picture()) !== before, "the picture is the old one");
  await isClean(page);
}

// A robot with a folder of its own, and what it includes there.
async function modelsLieInFolders(previewed, page) {
  mkdirSync(previewed.path("models/robot"));
  const joint = '<joint name="knuckle"/><geom size="0.1"/>';
  previewed.write(
    "models/robot/arm.xml",
    `<mujoco><worldbody><body name="finger">${joint}</body></worldbody></mujoco>`,
  );
  previewed.write("models/robot/scene.xml", '<mujoco><include file="arm.xml"/></mujoco>');
  previewed.edit(
    lesson,
    "The renamed paragraph.",
    "[The robot](model:robot/scene) has nv = `{robot/scene} model.nv`.",
  );
  await says(page, "The robot has nv = 1.");
  await isClean(page);
  previewed.edit("models/robot/arm.xml", "<joint", '<joint type="ball"/><joint');
  await panel(page).getByText("models/robot/arm.xml:1").first().waitFor();
  previewed.edit("models/robot/arm.xml", joint, '<geom size="0.1"/>');
  await says(page, "The robot has nv = 3.");
  await isClean(page);
  const model = await previewed.open("models/robot/scene.html");
  await says(model, "finger");
  await model.close();
}

// A page of the web that gives this machine a name of its own learns nothing, nor does anybody get
// files that are not the site's.
async function othersAreRefused(previewed) {
  const { host } = new URL(previewed.root);
  const status = async (path, headers) => (await ask(previewed, path, headers)).status;
  const expect = async (wanted, path, headers, what) =>
    previewed.expect((await status(path, headers)) === wanted, what);
  await expect(200, "/", { host }, "the home page is not there");
  await expect(403, "/", { host: "evil.example" }, "another host is answered");
  const other = { host, origin: "http://evil.example" };
  await expect(403, "/.preview/state?page=index.html", other, "another origin is answered");
  for (const path of [
    "/../../../etc/passwd",
    "/%2e%2e/%2e%2e/etc/passwd",
    "/content/course.yaml",
  ]) {
    await expect(404, path, { host }, `${path} is given`);
  }
  symlinkSync("/etc/hostname", previewed.path("examples/link.cpp"));
  await expect(404, "/examples/link.cpp", { host }, "a link out of the course is followed");
  await expect(404, "/.preview/../manifest.json", { host }, "a file beside the scripts is given");
}

// What stands for nothing in a theme is said when it comes, and no more when it has gone.
async function themesAreChecked(previewed) {
  const stray = previewed.path("theme/templates/leson.hbs");
  const said = async (wanted) => {
    for (let left = 200; left > 0; left--) {
      const { diagnostics } = await previewed.settled();
      if (diagnostics.some(({ id }) => id === "E-theme-file") === wanted) return;
      await new Promise((waited) => setTimeout(waited, 50));
    }
    previewed.complain(`a stray template ${wanted ? "is not told" : "is told for ever"}`);
  };
  mkdirSync(dirname(stray), { recursive: true });
  writeFileSync(stray, "x");
  await said(true);
  rmSync(previewed.path("theme"), { recursive: true });
  await said(false);
}

async function manyTabs(previewed) {
  const tabs = [];
  for (let i = 0; i < 12; i++) tabs.push(await previewed.open("1-first/1.2-another.html"));
  previewed.edit("content/1-first/1.2-another.md", "Another lesson.", "One for all tabs.");
  for (const tab of tabs) await says(tab, "One for all tabs.");
  for (const tab of tabs) await tab.close();
}

await preview(mjcourse, folder, async (previewed) => {
  await previewed.settled();
  const page = await previewed.open(address);
  await isClean(page);
  await whatIsAroundStays(previewed, page);
  await outputsFollow(previewed, page);
  await mistakesAreShown(previewed, page);
  await filesComeAndGo(previewed, page);
  await picturesAreRenewed(previewed, page);
  await modelsLieInFolders(previewed, page);
  await othersAreRefused(previewed);
  await themesAreChecked(previewed);
  await manyTabs(previewed);
  await saysNot(page, "no such text");
});
