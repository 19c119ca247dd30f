// The formulas of the course, set by our typesetter and by KaTeX under Node, from the start of the
// process and warm.
//
//   node tests/bench/formulas.mjs TYPESET_BENCH ASSETS [CONTENT]
//
// TYPESET_BENCH is typeset_bench.cpp's program, ASSETS what the site's build made. Run with a second
// argument of "--node" instead, this file is the side of Node. The last line is JSON.

import { execFileSync } from "node:child_process";
import { globSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

const root = resolve(import.meta.dirname, "../..");
const passes = 30; // over all formulas; the last is the warm one

/** Times the first and the last of the passes, in seconds. */
function setByNode(formulas) {
  const katex = createRequire(join(root, "site/package.json"))("katex");
  const seconds = [];
  for (let pass = 0; pass < passes; ++pass) {
    const start = process.hrtime.bigint();
    for (const { tex, display } of formulas) {
      katex.renderToString(tex, { displayMode: display, output: "htmlAndMathml" });
    }
    seconds.push(Number(process.hrtime.bigint() - start) / 1e9);
  }
  return { first: seconds[0], warm: seconds.at(-1) };
}

/** `$…$` and `$$…$$` outside of code. */
function formulasIn(markdown) {
  const text = markdown
    .replace(/^(`{3,})[^\n]*\n[^]*?^\1$/gm, "")
    .replace(/(`+)[^`][^]*?\1/g, "")
    .replace(/\\\$/g, "");
  const found = text.matchAll(/\$\$([^$]+)\$\$|\$(?=\S)([^$\n]+?)(?<=\S)\$(?!\d)/g);
  return [...found].map(([, block, inline]) => ({
    tex: block ?? inline,
    display: block !== undefined,
  }));
}

if (process.argv[2] === "--node") {
  const formulas = JSON.parse(readFileSync(process.argv[3], "utf8"));
  console.log(JSON.stringify(setByNode(formulas)));
  process.exit(0);
}

const [, , bench, assets, content = join(root, "content")] = process.argv;
const formulas = globSync(join(content, "**/*.md")).flatMap((file) =>
  formulasIn(readFileSync(file, "utf8")),
);
const home = mkdtempSync(join(tmpdir(), "mjcourse-bench-"));
const list = join(home, "formulas.json");
writeFileSync(list, JSON.stringify(formulas));

function timed(command, args) {
  const start = process.hrtime.bigint();
  const answer = JSON.parse(execFileSync(command, args, { encoding: "utf8" }));
  const whole = Number(process.hrtime.bigint() - start) / 1e9;
  // From the start of the process to the end of its first pass over the formulas.
  const { first, warm, passed = passes } = answer;
  return { first, warm, whole, passed };
}

const ours = timed(bench, [join(assets, "script/typeset.js"), list, String(passes)]);
const node = timed(process.execPath, [import.meta.filename, "--node", list]);
rmSync(home, { recursive: true });

const result = { name: "formulas", formulas: formulas.length, ours, node };
for (const [name, key] of [
  ["first pass", "first"],
  ["warm pass", "warm"],
  [`process, ${passes} passes`, "whole"],
]) {
  result[`${key}_of_node`] = Number((ours[key] / node[key]).toFixed(3));
  const columns = [ours[key], node[key]].map((s) => `${(1000 * s).toFixed(1)} ms`.padStart(11));
  console.log(
    `${formulas.length} formulas, ${name.padEnd(20)} ours ${columns[0]}  Node ${columns[1]}  ${result[`${key}_of_node`]}`,
  );
}
console.log(JSON.stringify(result));
