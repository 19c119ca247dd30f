// A site for a class has no line of a solution in any page, program, zip or index; the usual site has
// them. Neither has a wrong variant or a check that is hidden.
//
//   node tests/site/without-solutions.mjs MJCOURSE COURSE SITE

import { execFileSync } from "node:child_process";
import { globSync, mkdtempSync, readFileSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

const [mjcourse, course, usual] = process.argv.slice(2).map((path) => resolve(path));
const folder = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
let problems = 0;

function complain(what) {
  ++problems;
  console.error(what);
}

// Words alone: a page has marks of the highlighter between them, and an index escapes quotes.
const words = (text) => text.replace(/[\\\s]+/g, "");
const entities = { "&lt;": "<", "&gt;": ">", "&quot;": '"', "&#39;": "'", "&amp;": "&" };
const plain = (html) =>
  html.replace(/<[^>]*>/g, "").replace(/&(lt|gt|quot|#39|amp);/g, (entity) => entities[entity]);

function wordsOf(path) {
  const name = path.toLowerCase();
  if (/\.(woff2|webp|png|mp4|wasm|xz)$/.test(name)) return "";
  if (!name.endsWith(".zip")) {
    const text = readFileSync(path, "utf8");
    return words(text) + (name.endsWith(".html") ? words(plain(text)) : "");
  }
  const options = { encoding: "utf8", maxBuffer: 1 << 28 };
  return words(execFileSync("unzip", ["-p", path], options));
}

// The lines of the file's region that say something: those of the solution, and the others.
function linesOf(file) {
  const text = readFileSync(file, "utf8");
  // No other region begins or ends between its mark and the starter's.
  const form = /#region [^\n]*\n((?:(?!#region|#endregion)[^])*?#starter[^]*?)\n *\/\/ #endregion/;
  const [, region] = form.exec(text) ?? [];
  if (region === undefined) return undefined;
  const [solution, starter, ...wrong] = region.split(/^ *\/\/ #(?:starter|wrong).*$/m);
  const lines = (part) =>
    part
      .split("\n")
      .map((line) => words(line.replace(/^ *\/\/ ?/, "")))
      .filter((line) => line.length >= 16 && /[();]/.test(line));
  return {
    solution: lines(solution),
    whole: words(solution),
    wrong: wrong.flatMap(lines),
    rest: words(text.replace(region, "") + starter),
  };
}

const files = globSync("examples/**/*.{cpp,hpp}", { cwd: course }).map((file) =>
  join(course, file),
);
const exercises = files.flatMap((file) => linesOf(file) ?? []);
// What the course says elsewhere as well, it may say.
const others = files
  .filter((file) => !linesOf(file))
  .map((file) => words(readFileSync(file, "utf8")));
const lessons = globSync("content/**/*.md", { cwd: course }).map((file) =>
  words(readFileSync(join(course, file), "utf8").replace(/^> \[!solution\][^]*?\n(?!>)/gm, "")),
);
const elsewhere = [...others, ...lessons, ...exercises.map(({ rest }) => rest)].join("\n");
const own = (lines) => [...new Set(lines)].filter((line) => !elsewhere.includes(line));
const solutions = own(exercises.flatMap(({ solution }) => solution));
const right = exercises.map(({ whole }) => whole).join("\n");
const mistakes = own(exercises.flatMap(({ wrong }) => wrong)).filter(
  (line) => !right.includes(line),
);

function siteWords(site) {
  const paths = globSync("**/*.*", { cwd: site })
    .map((path) => join(site, path))
    .filter((path) => statSync(path).isFile());
  return paths.map((path) => [path, wordsOf(path)]);
}

if (exercises.length < 20) complain(`only ${exercises.length} exercises were found`);
execFileSync(mjcourse, ["build", "--course", course, "--out", folder, "--without-solutions"]);
for (const [path, text] of siteWords(folder)) {
  for (const line of [...solutions, ...mistakes]) {
    if (text.includes(line)) complain(`${path} has ${line}`);
  }
}
const known = siteWords(usual);
for (const line of solutions) {
  if (!known.some(([, text]) => text.includes(line))) complain(`the usual site lacks ${line}`);
}
for (const [path, text] of known) {
  for (const line of mistakes) {
    if (text.includes(line)) complain(`${path} has the mistake ${line}`);
  }
}
rmSync(folder, { recursive: true });
console.log(
  `${exercises.length} exercises, ${solutions.length} lines of solutions, ${mistakes.length} of mistakes, ` +
    `${problems} problems`,
);
process.exitCode = problems > 0 ? 1 : 0;
