// The live view draws what MuJoCo's own renderer draws: each lab of tests/site/lab/stage-course is
// drawn in a browser and laid over its poster. And the stage lives through what browsers do to it.
//
//   node tests/site/lab/stage.mjs MJCOURSE

import { cp, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { execFileSync } from "node:child_process";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import path from "node:path";

const root = path.resolve(import.meta.dirname, "../../..");
const require = createRequire(path.join(root, "site/package.json"));
const lesson = "1-scenes/1.1-scenes.html";

// Of a number of 0 to 255: the edges of shadows are softer than MuJoCo's, and the C libraries' last
// bits are others. A wrong light or a shape a pixel aside is far above.
const closest = { mean: 1, far: 0.005 };

// The course's own models are beside those of this test.
async function buildSite(folder, mjcourse) {
  await cp(path.join(import.meta.dirname, "stage-course"), folder, {
    recursive: true,
  });
  await cp(path.join(root, "models"), path.join(folder, "models"), {
    recursive: true,
  });
  const site = path.join(folder, "site");
  const icon = path.join(root, "site/browser/icons/favicon.svg");
  execFileSync(mjcourse, ["build", "--course", folder, "--out", site], {
    stdio: "pipe",
  });
  await require("esbuild").build({
    entryPoints: [path.join(import.meta.dirname, "stage-page.mjs")],
    outfile: path.join(site, "stage.js"),
    bundle: true,
    format: "esm",
    target: "es2022",
    nodePaths: [path.join(root, "site/node_modules")],
  });
  await cp(icon, path.join(site, "stage.svg"));
  await writeFile(
    path.join(site, "stage.html"),
    `<!doctype html><html lang="en"><meta charset="utf-8"><title>Stage</title>
<meta http-equiv="Content-Security-Policy" content="default-src 'self'; script-src 'self' 'wasm-unsafe-eval'">
<link rel="icon" href="stage.svg"><canvas></canvas><script type="module" src="stage.js"></script></html>`,
  );
  return site;
}

// What the lesson's page says of its labs, with addresses as the stage's page has them.
async function readLabs(site) {
  const html = await readFile(path.join(site, lesson), "utf8");
  const attribute = (text, name) => new RegExp(`\\b${name}="([^"]*)"`).exec(text)?.[1];
  return html
    .split("<sim-lab ")
    .slice(1)
    .map((text) => ({
      module: attribute(text, "data-module")?.replace("../", "./"),
      glue: attribute(text, "data-engine")?.replace("../", "./"),
      wasm: attribute(text, "data-wasm")?.replace("../", "./"),
      poster: attribute(text, "src").replace("../", ""),
      width: Number(attribute(text, "width")),
      height: Number(attribute(text, "height")),
    }));
}

async function testStage(visitor, labs) {
  const pixelRatio = { deviceScaleFactor: 2 }; // as the posters are drawn
  await visitor.visit("stage.html", pixelRatio, async (page) => {
    const expect = (good, what) => visitor.expect(good, "the stage", what);
    await page.waitForFunction(() => "open" in window);
    for (const lab of labs) await tryPoster(page, lab, expect);
    const shapes = labs[3];
    await page.evaluate(async (lab) => {
      await window.open(lab);
      window.resize(lab.width / 2, lab.height / 2); // software draws small pictures faster
    }, shapes);
    await tryOverlays(page, expect);
    await tryGhost(page, shapes, expect);
    await trySizesAndMemory(page, shapes, expect);
    await tryLimits(page, shapes, expect);
    await tryLoss(page, expect);
    const time = await page.evaluate(() => window.drawingTime());
    console.log(`a frame takes ${time.toFixed(1)} ms of script`);
  });
}

async function tryPoster(page, lab, expect) {
  await page.evaluate((shown) => window.open(shown), lab);
  const { mean, far } = await page.evaluate((poster) => window.compare(poster), lab.poster);
  const found = `mean difference ${mean.toFixed(2)}, ${(100 * far).toFixed(2)} % of pixels far off`;
  console.log(`${lab.poster}: ${found}`);
  expect(mean <= closest.mean && far <= closest.far, `${lab.poster}: ${found}`);
}

async function tryOverlays(page, expect) {
  const names = await page.evaluate(() => window.overlays());
  expect(names.length > 20, `there are ${names.length} overlays`);
  for (const name of names) {
    const change = await page.evaluate((overlay) => window.overlayChanges(overlay), name);
    expect(change > 0.001, `the overlay ${name} changes nothing`);
  }
}

async function tryGhost(page, { module }, expect) {
  const changes = (steps) =>
    page.evaluate(([address, count]) => window.ghostChanges(address, count), [module, steps]);
  expect((await changes(200)) > 0.3, "the ghost of a run elsewhere is not seen");
  // But through what is clear.
  expect((await changes(0)) < 0.1, "the ghost of a run at the same place is seen");
}

async function trySizesAndMemory(page, { width, height, poster }, expect) {
  const { mean } = await page.evaluate(
    async ([wide, high, address]) => {
      window.resize(0, 0);
      window.draw();
      window.growMemory();
      window.resize(wide, high);
      window.withOverlays(["tendons"]); // as at first
      return window.compare(address);
    },
    [width, height, poster],
  );
  // MuJoCo moves an infinite plane to where the camera was before: from the second frame on the
  // corners of the plane, and the light on them, are elsewhere.
  expect(mean <= 2 * closest.mean, `after other sizes, and in moved memory, it is off by ${mean}`);
}

// A phone's limits, made small: the cube and the sky have 128 pixels a side, the grid 256, and the
// shadows of two lights 4096.
async function tryLimits(page, { width, height }, expect) {
  const { mean, far, size } = await page.evaluate(
    ([wide, high]) => {
      window.resize(wide / 8, high / 8);
      return window.compareUnder({ flat: 200, cube: 50 });
    },
    [width, height],
  );
  await page.evaluate(
    ([wide, high]) => {
      window.resize(wide / 2, high / 2);
      window.draw();
    },
    [width, height],
  );
  const found = `mean difference ${mean.toFixed(2)}, ${(100 * far).toFixed(2)} % of pixels far off`;
  console.log(`with small textures: ${found}`);
  expect(mean <= 5 && far <= 0.05, `with small textures: ${found}`);
  expect(size.join() === "200,100", `a large canvas has ${size.join(" x ")} pixels, of 200`);
}

async function tryLoss(page, expect) {
  const { events, wasLost, isLost, kept, again } = await page.evaluate(() => window.loseContext());
  expect(wasLost && !isLost, "the stage does not know that its context was lost, or is back");
  expect(events.join() === "lost,restored", `of a lost context it told ${events.join()}`);
  expect(kept === 0, "without a context the last picture does not stay");
  expect(again < 0.01, `with a new context the picture differs by ${again}`);
}

const folder = await mkdtemp(path.join(tmpdir(), "mjcourse-stage-"));
try {
  const site = await buildSite(folder, process.argv[2]);
  const labs = await readLabs(site);
  if (labs[0].module === undefined) console.log("MuJoCo for the browser was not built");
  else {
    process.argv[2] = site; // which the browser is shown
    const { testSite } = await import("../browser.mjs");
    await testSite((visitor) => testStage(visitor, labs));
  }
} finally {
  await rm(folder, { recursive: true });
}
