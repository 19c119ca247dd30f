// The engine runs in a page and in a worker, under the site's content security policy.
//
//   node --test tests/engine/browser.mjs

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import path from "node:path";
import { after, test } from "node:test";

import { built, bundleText, models, nativeState, require } from "./harness.mjs";

const policy = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'";
const model = path.join(models, "box_and_sphere.xml");
const run = `import { loadEngine } from "./bundle.js";
  export async function run() {
    const engine = await loadEngine({ glue: new URL("engine.mjs", import.meta.url).href });
    const mjcf = await (await fetch("box.xml")).text();
    const simulation = engine.load("box.xml", { "box.xml": mjcf });
    simulation.step(500);
    return [...simulation.state];
  }`;
const files = {
  "/": ["text/html", "<!doctype html><title>engine</title>"],
  "/bundle.js": ["text/javascript", await bundleText("browser/engine/engine.ts")],
  "/run.js": ["text/javascript", run],
  "/worker.js": ["text/javascript", 'import { run } from "./run.js"; postMessage(await run());'],
  "/box.xml": ["text/xml", readFileSync(model)],
  "/engine.mjs": ["text/javascript", readFileSync(path.join(built, "engine.mjs"))],
  "/engine.wasm": ["application/wasm", readFileSync(path.join(built, "engine.wasm"))],
};
const server = createServer((request, response) => {
  const [type, content] = files[request.url] ?? ["text/plain", ""];
  response.writeHead(files[request.url] ? 200 : 404, {
    "Content-Type": type,
    "Content-Security-Policy": policy,
  });
  response.end(content);
});
await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
after(() => server.close());

const chromium = "/usr/bin/chromium-headless-shell";
test("the same bits in a page and in its worker", { skip: !existsSync(chromium) }, async () => {
  const launch = { executablePath: chromium, args: ["--no-sandbox"] };
  const browser = await require("playwright-core").chromium.launch(launch);
  try {
    const page = await browser.newPage();
    const problems = [];
    page.on("console", (message) => problems.push(message.text()));
    page.on("pageerror", (error) => problems.push(String(error)));
    await page.route("**/favicon.ico", (route) => route.fulfill({ status: 204 }));
    await page.goto(`http://127.0.0.1:${server.address().port}/`);
    const inPage = await page.evaluate("import('/run.js').then(({ run }) => run())");
    const inWorker = await page.evaluate(`new Promise((resolve, reject) => {
      const worker = new Worker("/worker.js", { type: "module" });
      worker.onmessage = ({ data }) => resolve(data);
      worker.onerror = reject;
    })`);
    const expected = [...nativeState(model, 500)];
    assert.deepEqual(inPage, expected);
    assert.deepEqual(inWorker, expected);
    assert.deepEqual(problems, []);
  } finally {
    await browser.close();
  }
});
