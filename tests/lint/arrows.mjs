// The arrows between the folders of the generator run one way (generator/arrows.cmake): no file includes
// a folder that is not named for its own, and none reaches, through however many headers, what is
// forbidden to it.
//
//   node tests/lint/arrows.mjs GENERATOR [README]
//
// With README, its table has these folders in this order, each with a link to a README that is there.

import { existsSync, globSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";

const [generator, readme] = process.argv.slice(2);
const arrows = readFileSync(join(import.meta.dirname, "../../generator/arrows.cmake"), "utf8");
const listed = new Map(
  [...arrows.matchAll(/^set\(([\w/]+)\s*([^)]*)\)/gm)].map(([, name, words]) => [
    name,
    words.split(/\s+/).filter(Boolean),
  ]),
);
const folders = listed.get("folders");
const problems = [];

const files = new Map(
  globSync("**/*.{h,cpp,c}", { cwd: generator, exclude: ["cli/skeleton/**"] }).map((file) => {
    const text = readFileSync(join(generator, file), "utf8");
    const includes = [...text.matchAll(/^ *# *include *[<"]([^>"]+)[>"]/gm)].map(([, to]) => to);
    return [file, includes];
  }),
);
// "evaluate/scenes", or a library's "mujoco".
const folderOf = (file) =>
  folders.includes(dirname(file)) ? dirname(file) : file.split("/", 1)[0];

// What `file` includes, each header with the way to it.
function reached(file) {
  const ways = new Map();
  const next = [[file, []]];
  for (const [from, way] of next) {
    for (const to of files.get(from) ?? []) {
      if (ways.has(to)) continue;
      ways.set(to, [...way, to]);
      next.push([to, [...way, to]]);
    }
  }
  return ways;
}

folders.forEach((folder, i) => {
  for (const included of listed.get(`${folder}_includes`)) {
    const place = folders.indexOf(included);
    if (place < 0 || place >= i) problems.push(`arrows.cmake: ${included} is not before ${folder}`);
  }
});

let checked = 0;
for (const file of files.keys()) {
  if (!file.includes("/")) continue; // main.cpp
  const folder = dirname(file);
  if (!folders.includes(folder)) {
    problems.push(`${file}: arrows.cmake has no folder ${folder}`);
    continue;
  }
  const allowed = [folder, ...listed.get(`${folder}_includes`)];
  const never = listed.get(`${folder}_never`) ?? [];
  const wrong = new Set();
  for (const [to, way] of reached(file)) {
    const its = folderOf(to);
    const isOurs = folders.includes(its);
    if (isOurs) checked++;
    const against = way.length === 1 && isOurs && !allowed.includes(its);
    const forbidden = never.includes(its) || never.includes(its.split("/", 1)[0]);
    if ((!against && !forbidden) || wrong.has(its)) continue;
    wrong.add(its);
    const what = against ? "include" : "reach";
    problems.push(`${file}: ${folder} may not ${what} ${its}: ${way.join(" includes ")}`);
  }
}
if (checked === 0) problems.push(`no includes were found below ${generator}`);

if (readme !== undefined) {
  const rows = [...readFileSync(readme, "utf8").matchAll(/^\| \[`([\w/]+)\/`\]\(([^)#]+)/gm)];
  const told = rows.map(([, folder]) => folder);
  if (told.join() !== folders.join()) {
    problems.push(`${readme}: its table has ${told.join(" ")}, and not ${folders.join(" ")}`);
  }
  for (const [, folder, page] of rows) {
    const whole = folder.startsWith(dirname(page)) && existsSync(join(dirname(readme), page));
    if (!whole) problems.push(`${readme}: \`${folder}/\` is not told in ${page}`);
  }
}

for (const problem of problems) console.error(problem);
console.log(`${files.size} files, ${checked} ways, ${problems.length} against the arrows`);
process.exitCode = problems.length > 0 ? 1 : 0;
