// How long a reader waits for a program that they have changed: from Run to the end of the run, over the
// programs of a site in headless Chromium.
//
//   node tests/bench/edit_and_run.mjs SITE [EVERY]
//
// A reader opens each page that has programs, and runs every EVERYth of all programs (1), each with a new
// comment at its top, so that it is compiled anew. The first run of a page is told apart, because its
// compiler is not machine code yet. The time that a program itself takes is in all figures. The last line
// is the JSON that tests/bench/run keeps.

import { launch } from "../site/chromium.mjs";
import { pagesWith, folder } from "../site/browser.mjs";
import { Program } from "../site/cpp/program.mjs";
import { serve } from "../site/server.mjs";

const every = Number(process.argv[3] ?? 1);

// Solutions are folded away.
const unfold = () => document.querySelectorAll("details").forEach((one) => (one.open = true));

// The names by which Program.open() finds those that can be run.
const programsOf = (page) =>
  page
    .locator("[data-program]")
    .filter({ has: page.getByRole("button", { name: /^(Edit and run|Solve it here)/ }) })
    .evaluateAll((all) =>
      all.map(({ id, dataset }) => id || dataset.program.replace(/^snippets\/|\.cpp$/g, "")),
    );

async function secondsOf(page, id) {
  const program = await Program.open(page, id);
  await program.write(`// ${Date.now()}\n${await program.text()}`);
  const begin = performance.now();
  await program.run(/^Run/);
  const seconds = (performance.now() - begin) / 1000;
  await program.button("Close").click();
  return seconds;
}

const at = (runs, part) => runs[Math.min(runs.length - 1, Math.floor(part * runs.length))]?.seconds;

function summary(runs) {
  runs.sort((a, b) => a.seconds - b.seconds);
  return {
    runs: runs.length,
    median: at(runs, 0.5),
    p95: at(runs, 0.95),
    max: runs.at(-1)?.seconds,
  };
}

const firsts = [];
const others = [];
const { root, close } = await serve(folder);
const browser = await launch();
const page = await browser.newPage();
let count = 0;
for (const path of pagesWith("data-program=")) {
  await page.goto(root + path);
  await page.evaluate(unfold);
  const ids = (await programsOf(page)).filter(() => count++ % every === 0);
  for (const [i, id] of ids.entries()) {
    (i === 0 ? firsts : others).push({ id, seconds: await secondsOf(page, id) });
  }
}
await browser.close();
close();

const found = {
  first: summary(firsts),
  others: summary(others),
  all: summary([...firsts, ...others]),
};
for (const [name, { runs, median, p95, max }] of Object.entries(found)) {
  const [middle, late, last] = [median, p95, max].map((seconds) => seconds.toFixed(2));
  console.log(
    `${name.padEnd(7)} ${runs} runs: median ${middle} s, p95 ${late} s, longest ${last} s`,
  );
}
const slowest = others.slice(-5).map(({ id, seconds }) => `${id} ${seconds.toFixed(1)} s`);
console.log(`longest: ${slowest.join(", ")}`);
console.log(JSON.stringify({ name: "edit_and_run", every, found }));
