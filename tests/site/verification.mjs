// What was verified, as tools and readers get it: the JSON of a site and of reports has the shape
// that site/browser/report/verification.ts gives it, to the last key; a report of a failed run is written
// too, and its page opens by itself, with a picture that differs beside its reference.
//
//   node tests/site/verification.mjs MJCOURSE SITE    SITE: what a course was built into

import { spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

import { chromium } from "../../site/node_modules/playwright-core/index.mjs";
import { misfits } from "./misfits.mjs";

const [mjcourse, site] = process.argv.slice(2);
const here = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const problems = [];
const expect = (good, what) => good || problems.push(what);

const types = "site/browser/report/verification.ts";

// Runs a check of the course in `folder` with a report, and gives that.
function report(folder, ...more) {
  const out = join(here, "report");
  const run = spawnSync(mjcourse, ["check", "--course", folder, "--report", out, ...more]);
  const text = readFileSync(join(out, "verification.json"), "utf8");
  return {
    exit: run.status,
    text,
    json: JSON.parse(text),
    page: join(out, "index.html"),
  };
}

// A course of one lesson with this body.
function course(body) {
  const folder = join(here, "course");
  mkdirSync(join(folder, "content", "1-a"), { recursive: true });
  writeFileSync(
    join(folder, "content", "course.yaml"),
    "title: C\nlevels: [{folder: 1-a, title: A, lessons: [1.1-x]}]\n",
  );
  writeFileSync(join(folder, "content", "1-a", "1.1-x.md"), `---\ntitle: T\n---\n${body}`);
  return folder;
}

const model = `<mujoco><worldbody><light pos="0 -1 3"/><body pos="0 0 1">
<joint name="swing" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0 0 -0.5" size="0.05"/>
</body></worldbody></mujoco>`;

// A lesson's figure of the arm, turned by `angle`.
const pinned = (angle) => `\`\`\`figure
{"model": "arm", "alt": "An arm.", "size": [160, 100], "pin": "arm", "run": "data.qpos[0] = ${angle}"}
\`\`\`
`;

// What a reader sees of a page that was opened from the disk.
async function opened(page) {
  const quiet = ["--no-sandbox", "--disable-quic", "--no-first-run"];
  const browser = await chromium.launch({
    executablePath: "/usr/bin/chromium-headless-shell",
    args: quiet,
  });
  const tab = await browser.newPage();
  tab.on("console", (message) => problems.push(`${page}: console: ${message.text()}`));
  await tab.goto(pathToFileURL(page).href);
  const first = await tab.locator("h2").first().textContent();
  const messages = await tab.locator(".claim .message").allTextContents();
  const others = await tab.locator("section > .message").allTextContents();
  const pictures = await tab.locator(".compared img").evaluateAll((images) =>
    images.map((image) => ({
      file: image.getAttribute("src"),
      drawn: image.naturalWidth > 0,
      top: image.getBoundingClientRect().top,
    })),
  );
  await browser.close();
  return { first, messages, others, pictures };
}

try {
  const published = readFileSync(join(site, "verification.json"), "utf8");
  problems.push(...misfits(published, "Verification", types));
  // These types can tell: one key more, one less, one of another kind.
  const count = (text) => misfits(text, "Verification", types).length;
  expect(count(published.replace('"format": 1', '"format": 1, "more": 1')) === 1, "a key too many");
  expect(count(published.replace('"what"', '"waht"')) > 0, "a misspelt key");
  expect(count(published.replace(/"line": (\d+)/, '"line": "$1"')) === 1, "a text for a number");
  expect(!published.includes('"seconds":'), "a time in the site, which would never be the same");

  const good = report(course("$x$ and $y$\n"));
  expect(good.exit === 0 && good.json.succeeded, "a clean course, whose report says so");
  problems.push(...misfits(good.text, "Report", types));
  expect(good.json.counts.proved === 2, "two formulas");

  const bad = report(course("$\\alhpa$\n\n> [!nte] x\n\n```sh unchecked\nls\n```\n"), "--strict");
  expect(bad.exit === 1 && !bad.json.succeeded, "a failed run, whose report says so");
  problems.push(...misfits(bad.text, "Report", types));
  const ids = bad.json.diagnostics.map(({ id }) => id).join(" ");
  expect(ids === "E-math E-callout-kind E-strict-unchecked", `other diagnostics: ${ids}`);
  const shown = await opened(bad.page);
  expect(shown.first === "What is not so", `it begins with "${shown.first}"`);
  expect(shown.messages.length === 2, "messages of what failed and of what has no reason");
  expect(shown.messages[0]?.includes("\\alpha"), "first the message of what failed");
  expect(shown.others.length === 1, "the message that is about no claim");

  const arm = course(pinned(0));
  mkdirSync(join(arm, "models"));
  writeFileSync(join(arm, "models", "arm.xml"), model);
  const accepted = spawnSync(mjcourse, ["accept", "--course", arm]);
  expect(accepted.status === 0, "a picture to be pinned");
  const moved = report(course(pinned(1)));
  expect(moved.exit === 1, "a picture that is not as it was pinned");
  problems.push(...misfits(moved.text, "Report", types));
  const { pictures } = await opened(moved.page);
  const files = pictures.map(({ file }) => file).join(" ");
  const three = ["reference", "actual", "difference"].map((name) => `pictures/1.1-arm-${name}.png`);
  expect(files === three.join(" "), `other pictures: ${files}`);
  expect(
    pictures.every(({ drawn, top }) => drawn && top === pictures[0].top),
    "three pictures, drawn side by side",
  );

  rmSync(join(here, "course", "content", "course.yaml"));
  const none = report(join(here, "course"));
  expect(none.exit === 1 && none.json.lessons.length === 0, "no course, and a report all the same");
  problems.push(...misfits(none.text, "Report", types));
} finally {
  rmSync(here, { recursive: true });
}
for (const problem of problems) console.error(problem);
console.log(`${problems.length} problems`);
process.exitCode = problems.length > 0 ? 1 : 0;
