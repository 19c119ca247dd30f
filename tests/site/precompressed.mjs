// `build --compress`: what stands beside a file is that file, packed, and smaller; the same each time;
// a build without it leaves none.
//
//   node tests/site/precompressed.mjs MJCOURSE COURSE

import { spawnSync } from "node:child_process";
import { globSync, mkdtempSync, readFileSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { brotliDecompressSync, gunzipSync } from "node:zlib";

const [mjcourse, course] = process.argv.slice(2);
const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const site = join(home, "site");
const problems = [];

// The packed files of the site, with their bytes.
function build(...options) {
  const words = ["build", "--course", course, "--out", site, ...options];
  const { status, stderr } = spawnSync(mjcourse, words);
  if (status !== 0) throw new Error(`${stderr}`);
  const files = globSync("**/*.{br,gz}", { cwd: site }).sort();
  return new Map(files.map((file) => [file, readFileSync(join(site, file))]));
}

const packed = build("--compress");
for (const [file, bytes] of packed) {
  const plain = readFileSync(join(site, file.slice(0, -3)));
  const unpacked = file.endsWith(".br") ? brotliDecompressSync(bytes) : gunzipSync(bytes);
  if (!unpacked.equals(plain)) problems.push(`${file} is not the file beside it`);
  if (bytes.length >= plain.length) problems.push(`${file} is not smaller`);
}
for (const path of ["index.html", "sw.js", "search.js"]) {
  for (const ending of [".br", ".gz"]) {
    if (!packed.has(path + ending)) problems.push(`there is no ${path}${ending}`);
  }
}
const known = readFileSync(join(site, globSync("edition-*.json", { cwd: site })[0]), "utf8");
if (/\.(br|gz)"/.test(known)) problems.push("browsers are to keep packed files");
const size = (files) => files.reduce((sum, file) => sum + statSync(join(site, file)).size, 0);
const brotli = [...packed.keys()].filter((file) => file.endsWith(".br"));
console.log(`${size(brotli.map((file) => file.slice(0, -3)))} bytes become ${size(brotli)}`);

const again = build("--compress", "--jobs", "1");
const same = [...packed].every(([file, bytes]) => again.get(file)?.equals(bytes));
if (!same || again.size !== packed.size) problems.push("a second build packs otherwise");
if (build().size > 0) problems.push("a build without --compress leaves packed files");

rmSync(home, { recursive: true });
for (const problem of problems) console.error(problem);
console.log(`${packed.size} files, ${problems.length} problems`);
process.exitCode = problems.length > 0 ? 1 : 0;
