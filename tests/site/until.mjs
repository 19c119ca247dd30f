// Waits for what a page can only tell by and by. Playwright's waitForFunction takes the promise of an
// async function for its answer, and any promise is true.

import { setTimeout as pause } from "node:timers/promises";

const patience = 30_000; // ms
const interval = 20; // ms

// Until `holds`, an async function that runs in `page`, gives true. The page may be loaded anew
// meanwhile.
export async function until(page, holds) {
  const end = Date.now() + patience;
  let answer = false;
  while (answer !== true) {
    if (Date.now() > end) throw new Error(`still ${answer} after ${patience} ms: ${holds}`);
    await pause(interval);
    answer = await page.evaluate(holds).catch((error) => error.message);
  }
}
