// What a reader's browser transfers, as a server compresses it, stays below the bars.
//
//   a lesson's page before a lab is played   100 KB: HTML, styles, script and poster, which is the
//                                            first picture; those that wait to be scrolled to are
//                                            not in it
//   of that, script                           20 KB, beside the questions that review.html draws from
//   the search, which comes at its first use  20 KB and its index
//   what a page loads once it is shown          3 KB
//   a lab's own code, without the engine     240 KB; its editor is loaded only where one is opened
//   what edits a program, with its editor    240 KB; the compiler comes when its reader has agreed
//   the engine                               450 KB

import { globSync, readFileSync } from "node:fs";
import { dirname, join, normalize } from "node:path";
import { brotliCompressSync } from "node:zlib";

const folder = process.argv[2] ?? "build/release/test-site";
const picture = /\.(webp|png|woff2)$/; // is compressed already
let problems = 0;

// Most files are of many pages.
const sizes = new Map();
function transferred(path) {
  if (!sizes.has(path)) {
    const bytes = readFileSync(join(folder, path));
    sizes.set(path, picture.test(path) ? bytes.length : brotliCompressSync(bytes).length);
  }
  return sizes.get(path);
}

const total = (paths) => [...new Set(paths)].map(transferred).reduce((sum, size) => sum + size, 0);

// Complains where `paths` are more than `most` kilobytes together.
function weigh(what, paths, most) {
  const size = total(paths) / 1000;
  const good = paths.length > 0 && size <= most;
  if (!good) ++problems;
  console.log(`${size.toFixed(1).padStart(7)} KB of ${most}  ${what}${good ? "" : "  TOO MUCH"}`);
}

// The values of an attribute in `html`, as paths below the site's root.
function addresses(page, html, pattern) {
  const found = [...html.matchAll(pattern)].map(([, address]) => address);
  return found.map((address) => normalize(join(dirname(page), address)));
}

// `module` and what it imports at once; what import() brings is not loaded with it.
function closure(module, known = new Set()) {
  if (known.has(module)) return known;
  known.add(module);
  const text = readFileSync(join(folder, module), "utf8");
  const imports = /(?:from|import)\s*"(\.[^"]+)"/g;
  for (const path of addresses(module, text, imports)) closure(path, known);
  return known;
}

const labCode = new Set();
const engine = new Set();
const later = new Set();
for (const page of globSync("**/*.html", { cwd: folder }).sort()) {
  if (page === "404.html") continue; // it looks for its assets in several folders
  if (page === "print.html") continue; // all of the course, for a printer
  const html = readFileSync(join(folder, page), "utf8");
  const scripts = addresses(page, html, /<script src="([^"]+)"/g);
  const styles = addresses(page, html, /<link rel="stylesheet" href="([^"]+)"/g);
  const all = addresses(page, html, /srcset="([^"]+)"/g);
  const atOnce = addresses(page, html, /srcset="([^"]+)"><img (?![^>]*loading="lazy")/g);
  const pictures = new Set([...all.slice(0, 1), ...atOnce]);
  weigh(`${page} before a lab is played`, [page, ...scripts, ...styles, ...pictures], 100);
  const code = scripts.filter((path) => !path.startsWith("review/questions-"));
  weigh(`its script`, code, 20);
  for (const path of addresses(page, html, /data-(?:reading|offline)="([^"]+\.js)"/g))
    later.add(path);
  for (const path of addresses(page, html, /data-code="([^"]+)"/g)) labCode.add(path);
  for (const path of addresses(page, html, /data-(?:engine|wasm)="([^"]+)"/g)) engine.add(path);
}
const search = globSync("assets/search-*.js", { cwd: folder });
weigh("the search", [...search, "search.js"], 20);
weigh("what follows the reader", [...later], 3);
for (const path of labCode) weigh(`${path} with all it imports`, [...closure(path)], 240);
if (engine.size > 0) weigh("the engine", [...engine], 450);
console.log(`${problems} problems`);
process.exitCode = problems > 0 ? 1 : 0;
