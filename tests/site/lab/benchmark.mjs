// How long a frame of the humanoid's lab takes: the script's part, as on a machine whose graphics card
// does the drawing. WebGL's draw calls and the copy of the picture are left out for that.
//
//   node tests/site/lab/benchmark.mjs MJCOURSE

import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

import { chromium } from "../../../site/node_modules/playwright-core/index.mjs";
import { serve } from "../server.mjs";

const humanoid = "/usr/share/mujoco/model/humanoid/humanoid.xml"; // of libmujoco-samples
const frames = 300;
const lab = {
  title: "Humanoid",
  alt: "A humanoid above the floor.",
  model: "humanoid",
  height: 400,
  overlays: { contacts: true, forces: true },
  readouts: [{ label: "height", expr: "data.qpos[2]", digits: 3, unit: "m" }],
  plots: [{ ylabel: "height", traces: [{ label: "z", expr: "data.qpos[2]" }] }],
};
const files = {
  "content/course.yaml":
    "title: Benchmark\ndescription: One lab.\nlevels:\n" +
    "  - {folder: 1-labs, title: Labs, lessons: [1.1-humanoid]}\n",
  "content/1-labs/1.1-humanoid.md":
    "---\ntitle: Humanoid\n---\n\n```lab simlab\n" + JSON.stringify(lab) + "\n```\n",
};

function build(folder) {
  for (const [name, text] of Object.entries(files)) {
    mkdirSync(join(folder, name, ".."), { recursive: true });
    writeFileSync(join(folder, name), text);
  }
  mkdirSync(join(folder, "models"));
  cpSync(humanoid, join(folder, "models/humanoid.xml"));
  const site = join(folder, "site");
  execFileSync(resolve(process.argv[2]), ["build", "--course", folder, "--out", site]);
  return site;
}

// In the page, before its own scripts: drawing costs nothing, and each frame's script is timed.
function instrument() {
  for (const name of [
    "drawArrays",
    "drawElements",
    "drawArraysInstanced",
    "drawElementsInstanced",
  ]) {
    WebGL2RenderingContext.prototype[name] = () => undefined;
  }
  CanvasRenderingContext2D.prototype.drawImage = () => undefined;
  globalThis.times = [];
  const ask = globalThis.requestAnimationFrame.bind(globalThis);
  globalThis.requestAnimationFrame = (callback) =>
    ask((now) => {
      const begin = performance.now();
      callback(now);
      globalThis.times.push(performance.now() - begin);
    });
}

const folder = mkdtempSync(join(tmpdir(), "mjcourse-benchmark-"));
try {
  const server = await serve(build(folder));
  const browser = await chromium.launch({
    executablePath: "/usr/bin/chromium-headless-shell",
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  });
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  await page.addInitScript(instrument);
  await page.goto(`${server.root}1-labs/1.1-humanoid.html`);
  await page.getByRole("button", { name: "Play" }).first().click();
  await page.waitForFunction((count) => globalThis.times.length > count, frames);
  const times = await page.evaluate(() => globalThis.times);
  const rate = await page.locator(".lab-rate").innerText();
  times.sort((a, b) => a - b);
  const at = (part) => `${times[Math.floor(part * (times.length - 1))].toFixed(1)} ms`;
  console.log(`script a frame: median ${at(0.5)}, 90th percentile ${at(0.9)}; it runs ${rate}`);
  await browser.close();
  server.close();
} finally {
  rmSync(folder, { recursive: true });
}
