// How long an author waits: from a save to the new text, output or style in the page.
//
//   node tests/bench/preview.mjs MJCOURSE FOLDER [SAVES]
//
// 100 saves of each kind of the course in FOLDER, one after the other, in headless Chromium. Each is
// timed from just before the file is written until the page's own document has it. The last line is
// the JSON that tests/bench/run keeps.

import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { checkOut } from "../preview/checkout.mjs";
import { preview } from "../preview/previewed.mjs";

const [mjcourse, folder, saves = "100"] = process.argv.slice(2);
const lesson = "content/1-state/1.2-generalized-coordinates.md";
const address = "1-state/1.2-generalized-coordinates.html";

const at = (sorted, part) => sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))];
const pause = (ms) => new Promise((done) => setTimeout(done, ms));

// `save` writes the text that it is given somewhere; `wait` is run in the page with it before, and
// gives the time at which it is there.
async function measure(page, save, wait) {
  const times = [];
  for (let i = 0; i < Number(saves); i++) {
    const wanted = `saved${i}`;
    const seen = page.evaluate(wait, wanted);
    await pause(200);
    const before = performance.timeOrigin + performance.now();
    save(wanted);
    times.push((await seen) - before);
  }
  times.sort((a, b) => a - b);
  return { median: at(times, 0.5), p95: at(times, 0.95), max: times.at(-1) };
}

// In the page: looks at each change of it.
const untilText = (wanted) =>
  new Promise((found) => {
    const watch = new MutationObserver(() => {
      if (!document.querySelector(".prose").textContent.includes(wanted)) return;
      found(performance.timeOrigin + performance.now());
      watch.disconnect();
    });
    watch.observe(document.body, { subtree: true, childList: true });
  });
// In what the program printed, and not in the program itself.
const untilOutput = (wanted) =>
  new Promise((found) => {
    const has = (output) => output.textContent.includes(wanted);
    const watch = new MutationObserver(() => {
      if (![...document.querySelectorAll(".output")].some(has)) return;
      found(performance.timeOrigin + performance.now());
      watch.disconnect();
    });
    watch.observe(document.body, { subtree: true, childList: true });
  });
// A stylesheet comes into force when it is loaded.
const untilStyle = (wanted) =>
  new Promise((found) => {
    const value = () =>
      getComputedStyle(document.documentElement).getPropertyValue("--bench").trim();
    const look = (event) => {
      if (!(event.target instanceof HTMLLinkElement) || value() !== wanted) return;
      found(performance.timeOrigin + performance.now());
      document.removeEventListener("load", look, true);
    };
    document.addEventListener("load", look, true);
  });

const result = { name: "preview" };
const checkout = checkOut("site", "build/release/assets");
await preview(mjcourse, folder, async (previewed) => {
  await previewed.settled();
  const page = await previewed.open(address);
  await pause(3000); // until the page has loaded what it loads when it is idle
  const prose = previewed.read(lesson);
  const [sentence] = /^[A-Z][^\n]{40,}$/m.exec(prose.slice(prose.indexOf("\n## ")));
  const edit = (text) => previewed.write(lesson, prose.replace(sentence, `${sentence} ${text}.`));
  result.prose = await measure(page, edit, untilText);
  previewed.write(lesson, prose);

  // A program of Eigen and MuJoCo, which the lesson shows as a whole.
  const file = "examples/l1_2_generalized_coordinates.cpp";
  const program = previewed.read(file);
  const last = "  integrate_pose(model);\n";
  const print = (text) => {
    const longer = program.replace(last, `${last}  std::puts("${text}");\n`);
    previewed.write(lesson, prose.replace(program, longer));
    previewed.write(file, longer);
  };
  result.example = await measure(page, print, untilOutput);
  previewed.write(lesson, prose);
  previewed.write(file, program);

  const style = join(checkout.site, "styles/tokens.css");
  const css = readFileSync(style, "utf8");
  const colour = (text) => writeFileSync(style, `${css}\n:root {\n  --bench: ${text};\n}\n`);
  result.style = await measure(page, colour, untilStyle);
});
checkout.remove();
for (const kind of ["prose", "example", "style"]) {
  const { median, p95, max } = result[kind];
  const ms = (time) => `${time.toFixed(0)} ms`;
  console.log(`${kind}: median ${ms(median)}, p95 ${ms(p95)}, longest ${ms(max)}`);
}
console.log(JSON.stringify(result));
