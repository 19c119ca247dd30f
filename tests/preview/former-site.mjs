// A site that was served where the preview is now has left its service worker: the preview ends it, and
// what was kept, and shows its own pages.
//
//   node tests/preview/former-site.mjs MJCOURSE COURSE

import { spawn, spawnSync } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { launch } from "../site/chromium.mjs";
import { serve } from "../site/server.mjs";
import { until } from "../site/until.mjs";

const [mjcourse, course] = process.argv.slice(2);
const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const site = join(home, "site");
const built = spawnSync(mjcourse, ["build", "--course", course, "--out", site]);
if (built.status !== 0) throw new Error(`${built.stderr}`);

const left = (page) =>
  page.evaluate(async () => {
    const workers = await navigator.serviceWorker.getRegistrations();
    return `${workers.length} workers, ${(await caches.keys()).length} caches`;
  });
const problems = [];
function expect(good, what) {
  if (!good) problems.push(what);
}

const browser = await launch();
const page = await browser.newPage();
const former = await serve(site, { base: "/" });
await page.goto(former.root);
await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
expect((await left(page)) === "1 workers, 1 caches", `the site has left ${await left(page)}`);
former.close();

const words = ["preview", "--course", course, "--port", new URL(former.root).port];
const preview = spawn(mjcourse, words, { stdio: ["ignore", "pipe", "inherit"] });
await once(preview.stdout, "data");
await page.goto(former.root);
await until(page, async () => (await navigator.serviceWorker.getRegistrations()).length === 0);
await page.locator("html[data-preview-version]").waitFor({ state: "attached" });
expect((await left(page)) === "0 workers, 0 caches", `the preview leaves ${await left(page)}`);
await page.reload();
await page.locator("html[data-preview-version]").waitFor({ state: "attached" });
expect((await left(page)) === "0 workers, 0 caches", `a previewed page has ${await left(page)}`);

await browser.close();
preview.kill("SIGINT");
await once(preview, "exit");
rmSync(home, { recursive: true });
for (const problem of problems) console.error(problem);
console.log(`${problems.length} problems`);
process.exitCode = problems.length > 0 ? 1 : 0;
