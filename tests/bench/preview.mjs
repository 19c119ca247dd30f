// How long an author waits: from a save to the new text, output or style in the page.
//
//   node tests/bench/preview.mjs MJCOURSE FOLDER [SAVES]
//
// 100 saves of each kind of the course in FOLDER, one after the other, in headless Chromium. Each is
// timed from when its file is written, which may itself have to wait for the disk, until the page's
// own document has it, by the clock of the machine, which both processes share. The last line is the
// JSON that tests/bench/run keeps.

import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { checkOut } from "../preview/checkout.mjs";
import { preview } from "../preview/previewed.mjs";

const [mjcourse, folder, saves = "100"] = process.argv.slice(2);
const lesson = "content/1-state/1.2-generalized-coordinates.md";
const address = "1-state/1.2-generalized-coordinates.html";

const at = (sorted, part) => sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))];
// No other run has left results of the same programs.
const begun = Date.now();
const pause = (ms) => new Promise((done) => setTimeout(done, ms));

// The processor's ticks that a process has taken, and all that it has begun.
function ticksOf(pid) {
  try {
    const fields = readFileSync(`/proc/${pid}/stat`, "utf8")
      .replace(/^.*\) /, "")
      .split(" ");
    const own = fields.slice(11, 15).reduce((sum, ticks) => sum + Number(ticks), 0);
    const children = readdirSync(`/proc/${pid}/task`).flatMap((thread) =>
      readFileSync(`/proc/${pid}/task/${thread}/children`, "utf8").trim().split(" "),
    );
    return children.filter((child) => child !== "").reduce((sum, c) => sum + ticksOf(c), own);
  } catch {
    return 0; // it has just ended
  }
}

// Until the process has nothing to do any more, nor do those that it has begun.
async function idle(pid) {
  for (let quiet = 0, before = 0; quiet < 5;) {
    await pause(1000);
    const ticks = ticksOf(pid);
    quiet = Math.abs(ticks - before) < 5 ? quiet + 1 : 0;
    before = ticks;
  }
}

// `save` writes the text that it is given somewhere; `wait` is run in the page with it before, and
// gives the time at which it is there.
async function measure(page, save, wait, text = (i) => `saved ${begun}, ${i}`) {
  const times = [];
  for (let i = 0; i < Number(saves); i++) {
    const wanted = text(i);
    const seen = page.evaluate(wait, wanted);
    await pause(200);
    save(wanted);
    const saved = Date.now();
    times.push((await seen) - saved);
  }
  times.sort((a, b) => a - b);
  return { median: at(times, 0.5), p95: at(times, 0.95), max: times.at(-1) };
}

// In the page: looks at each change of it.
const untilText = (wanted) =>
  new Promise((found) => {
    const watch = new MutationObserver(() => {
      if (!document.querySelector(".prose").textContent.includes(wanted)) return;
      found(Date.now());
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
      found(Date.now());
      watch.disconnect();
    });
    watch.observe(document.body, { subtree: true, childList: true });
  });
// After each rule that is put in place: to ask for a style has the browser work it out.
const untilStyle = (wanted) =>
  new Promise((found) => {
    const kinds = [CSSStyleSheet.prototype, CSSGroupingRule.prototype];
    const own = kinds.map(({ insertRule }) => insertRule);
    const look = () => {
      const { outlineColor } = getComputedStyle(document.querySelector(".prose > p"));
      if (outlineColor !== wanted) return;
      found(Date.now());
      kinds.forEach((kind, index) => (kind.insertRule = own[index]));
    };
    kinds.forEach((kind, index) => {
      kind.insertRule = function (...rule) {
        queueMicrotask(look);
        return own[index].apply(this, rule);
      };
    });
  });

const result = { name: "preview" };
const checkout = checkOut("site", "build/release/assets");
await preview(mjcourse, folder, async (previewed) => {
  await previewed.settled();
  const page = await previewed.open(address);
  await idle(previewed.process.pid); // then the page has loaded what it needs, and the headers are warm
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

  const style = join(checkout.site, "browser/styles/prose.css");
  const css = readFileSync(style, "utf8");
  const colour = (text) =>
    writeFileSync(style, `${css}\n.prose > p {\n  outline-color: ${text};\n}\n`);
  result.style = await measure(page, colour, untilStyle, (i) => `rgb(${i % 255}, 2, 3)`);
});
checkout.remove();
for (const kind of ["prose", "example", "style"]) {
  const { median, p95, max } = result[kind];
  const ms = (time) => `${time.toFixed(0)} ms`;
  console.log(`${kind}: median ${ms(median)}, p95 ${ms(p95)}, longest ${ms(max)}`);
}
console.log(JSON.stringify(result));
