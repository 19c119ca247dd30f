// The arrows between the folders of the generator run one way (generator/arrows.cmake): no header that
// a file includes, directly or through others, lies in a folder that its own may not reach.
//
//   node tests/lint/arrows.mjs GENERATOR [README]
//
// With README, the last column of its table of folders is held against the arrows too.

import { globSync, readFileSync } from "node:fs";
import { join } from "node:path";

const [generator, readme] = process.argv.slice(2);
const arrows = readFileSync(join(import.meta.dirname, "../../generator/arrows.cmake"), "utf8");
const listed = new Map(
  [...arrows.matchAll(/^set\((\w+) ?([^)]*)\)/gm)].map(([, name, words]) => [
    name,
    words.split(" ").filter(Boolean),
  ]),
);
const folders = listed.get("folders");
const problems = [];

const files = new Map(
  globSync("**/*.{h,cpp,c}", { cwd: generator }).map((file) => {
    const text = readFileSync(join(generator, file), "utf8");
    const includes = [...text.matchAll(/^ *# *include *[<"]([^>"]+)[>"]/gm)].map(([, to]) => to);
    return [file, includes];
  }),
);
const folderOf = (file) => file.split("/", 1)[0];

// What `file` includes, each header with the way to it.
function reached(file) {
  const ways = new Map();
  const next = [[file, [file]]];
  for (const [from, way] of next) {
    for (const to of files.get(from) ?? []) {
      if (ways.has(to)) continue;
      ways.set(to, [...way, to]);
      next.push([to, [...way, to]]);
    }
  }
  return ways;
}

let checked = 0;
for (const file of files.keys()) {
  const folder = folderOf(file);
  if (folder === file) continue; // main.cpp
  if (!folders.includes(folder)) {
    problems.push(`${file}: arrows.cmake has no folder ${folder}`);
    continue;
  }
  const reaches = [folder, ...listed.get(`${folder}_reaches`)];
  const never = listed.get(`${folder}_never`) ?? [];
  const wrong = new Set();
  for (const [to, way] of reached(file)) {
    const its = folderOf(to);
    if (folders.includes(its)) checked++;
    const against = folders.includes(its) ? !reaches.includes(its) : never.includes(its);
    if (!against || wrong.has(its)) continue;
    wrong.add(its);
    problems.push(`${file}: ${folder} may not reach ${its}: ${way.slice(1).join(" includes ")}`);
  }
}
if (checked === 0) problems.push(`no includes were found below ${generator}`);

if (readme !== undefined) {
  const rows = readFileSync(readme, "utf8").matchAll(/^\| `(\w+)\/` \|.*\| ([^|]*) \|$/gm);
  const told = new Map([...rows].map(([, folder, words]) => [folder, words]));
  for (const folder of folders) {
    const words = listed.get(`${folder}_reaches`).join(", ") || "nothing of ours";
    if (told.get(folder) === words) continue;
    problems.push(`${readme}: \`${folder}/\` may reach ${words}, and not ${told.get(folder)}`);
  }
}

for (const problem of problems) console.error(problem);
console.log(`${files.size} files, ${checked} ways, ${problems.length} against the arrows`);
process.exitCode = problems.length > 0 ? 1 : 0;
