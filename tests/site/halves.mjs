// What has arrived of a page stays where it is when the rest comes: the home page, cut behind the picture
// of a lesson, as a slow network or a busy browser may show it.
//
//   node tests/site/halves.mjs SITE

import { createServer } from "node:http";
import { readFileSync } from "node:fs";
import { join, resolve } from "node:path";

import { launch } from "./chromium.mjs";
import { serve } from "./server.mjs";
import { mostShifted, shiftOf } from "./shift.mjs";

const folder = resolve(process.argv[2]);

const html = readFileSync(join(folder, "index.html"));
const cut = html.indexOf("</picture>") + "</picture>".length;

const site = await serve(folder);
let sendRest;
const halves = createServer(async (request, response) => {
  if (request.url === "/") {
    response.writeHead(200, { "content-type": "text/html; charset=utf-8" });
    response.write(html.subarray(0, cut));
    sendRest = () => response.end(html.subarray(cut));
  } else {
    const answer = await fetch(site.root + request.url.slice(1));
    response.writeHead(answer.status, { "content-type": answer.headers.get("content-type") });
    response.end(Buffer.from(await answer.arrayBuffer()));
  }
});
await new Promise((listening) => halves.listen(0, "127.0.0.1", listening));
const browser = await launch();
const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
await page.addInitScript(() => delete Navigator.prototype.serviceWorker);
await page.goto(`http://127.0.0.1:${halves.address().port}/`, { waitUntil: "commit" });
await page.locator("picture").first().waitFor();
await page.waitForFunction(() => performance.getEntriesByType("paint").length > 0);
sendRest();
await page.waitForLoadState("load");
const moved = await shiftOf(page);
await browser.close();
halves.close();
halves.closeAllConnections();
site.close();

const good = cut > 10 && moved <= mostShifted;
if (!good) console.error(`cut at byte ${cut}, the home page moves by ${moved}`);
console.log(good ? "1 passed, 0 failed" : "0 passed, 1 failed");
process.exitCode = good ? 0 : 1;
