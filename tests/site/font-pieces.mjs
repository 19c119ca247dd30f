// The fonts are cut into pieces, and nothing is lost: what the packages' stylesheets promise, the
// site's has too, in every weight, with the same measures; and no changed file bears a reserved name.
//
//   node tests/site/font-pieces.mjs SITE

import { globSync, readFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";

import { Font } from "../../site/bundle/sfnt.mjs";

const folder = process.argv[2] ?? "build/release/test-site";
const modules = join(import.meta.dirname, "../../site/node_modules");
const packages = [
  "@fontsource-variable/source-serif-4/wght.css",
  "@fontsource-variable/source-serif-4/wght-italic.css",
  "@fontsource-variable/source-sans-3/wght.css",
  "@fontsource-variable/source-sans-3/wght-italic.css",
  "@fontsource-variable/source-code-pro/wght.css",
  "katex/dist/katex.css",
];
const problems = [];

// The faces that a stylesheet declares from files.
function facesOf(path) {
  const rules = readFileSync(path, "utf8").matchAll(/@font-face\s*{([^}]*)}/g);
  return [...rules].flatMap(([, body]) => {
    const find = (name) => body.match(new RegExp(`${name}:\\s*([^;]+)`))?.[1];
    const file = body.match(/url\(["']?([^"')]+\.woff2)/)?.[1];
    if (!file) return [];
    return {
      family: find("font-family").replace(/["']| Variable/g, ""),
      style: find("font-style") ?? "normal",
      weight: find("font-weight").replace("normal", "400").replace("bold", "700"),
      ranges: find("unicode-range")?.split(",") ?? ["U+0-10FFFF"],
      file: join(dirname(path), file),
    };
  });
}

function inRange(code, ranges) {
  return ranges.some((range) => {
    const [first, last = first] = range.trim().slice(2).split("-");
    return code >= parseInt(first, 16) && code <= parseInt(last, 16);
  });
}

const fonts = new Map();
async function fontOf(file) {
  if (!fonts.has(file)) fonts.set(file, await Font.of(readFileSync(file)));
  return fonts.get(file);
}

// The characters of a face that a browser takes from it.
async function charactersOf({ file, ranges }) {
  const { characters } = await fontOf(file);
  return [...characters].filter((code) => inRange(code, ranges));
}

const shipped = facesOf(globSync(join(folder, "assets/site-*.css"))[0]);
let cut = 0;

// In each weight that the site has: `original` is a face of a package.
async function compare(original) {
  const name = basename(original.file, ".woff2");
  const { family, style, weight } = original;
  const alike = shipped.filter((face) => face.family === family && face.style === style);
  const fits = (one) => weight.includes(" ") || one === weight; // a variable font has them all
  const weights = new Set(alike.map((face) => face.weight).filter(fits));
  if (weights.size === 0) problems.push(`${name} is not there`);
  const wanted = await charactersOf(original);
  for (const one of weights) {
    const faces = alike.filter((face) => face.weight === one);
    const covered = new Set((await Promise.all(faces.map(charactersOf))).flat());
    const lost = wanted.filter((code) => !covered.has(code)).map((code) => code.toString(16));
    if (lost.length > 0) problems.push(`${name} ${one} lacks ${lost.length}: ${lost.slice(0, 9)}`);
    const pieces = faces.map(({ file }) => file).filter((file) => isPiece(file, name));
    for (const file of pieces) await comparePiece(file, original.file);
    cut += pieces.length;
  }
}

// esbuild puts a hash after a file's name; before it are a piece's weights and number.
function isPiece(file, name) {
  const rest = basename(file).slice(name.length);
  return basename(file).startsWith(name) && /^(-\d+)+-[A-Z0-9]{8}\.woff2$/.test(rest);
}

async function comparePiece(file, original) {
  const [piece, whole] = [await fontOf(file), await fontOf(original)];
  const name = basename(file);
  if (piece.measures !== whole.measures) {
    problems.push(`${name} measures ${piece.measures}, not ${whole.measures}`);
  }
  const reserved = piece.names.filter((text) => /Source|KaTeX/.test(text));
  if (reserved.length > 0) problems.push(`${name} calls itself ${reserved[0]}`);
}

for (const original of packages.flatMap((path) => facesOf(join(modules, path)))) {
  await compare(original);
}
if (cut === 0) problems.push("no font is cut");
for (const problem of problems) console.error(problem);
console.log(`${shipped.length} faces, ${cut} of them pieces, ${problems.length} problems`);
process.exitCode = problems.length > 0 ? 1 : 0;
