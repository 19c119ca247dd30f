// The arrows between the rooms of the generator run one way (generator/arrows.cmake): no file includes
// a room that is not named for its own, and none reaches, through however many headers, what is
// forbidden to it.
//
//   node tests/lint/arrows.mjs GENERATOR [README]
//
// With README, the last column of its table of rooms is held against the arrows too.

import { globSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";

const [generator, readme] = process.argv.slice(2);
const arrows = readFileSync(join(import.meta.dirname, "../../generator/arrows.cmake"), "utf8");
const listed = new Map(
  [...arrows.matchAll(/^set\(([\w/]+)\s*([^)]*)\)/gm)].map(([, name, words]) => [
    name,
    words.split(/\s+/).filter(Boolean),
  ]),
);
const rooms = listed.get("rooms");
const problems = [];

const files = new Map(
  globSync("**/*.{h,cpp,c}", { cwd: generator, exclude: ["cli/skeleton/**"] }).map((file) => {
    const text = readFileSync(join(generator, file), "utf8");
    const includes = [...text.matchAll(/^ *# *include *[<"]([^>"]+)[>"]/gm)].map(([, to]) => to);
    return [file, includes];
  }),
);
// "evaluate/scenes", or a library's "mujoco".
const roomOf = (file) => (rooms.includes(dirname(file)) ? dirname(file) : file.split("/", 1)[0]);

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

rooms.forEach((room, i) => {
  for (const included of listed.get(`${room}_includes`)) {
    const place = rooms.indexOf(included);
    if (place < 0 || place >= i) problems.push(`arrows.cmake: ${included} is not before ${room}`);
  }
});

let checked = 0;
for (const file of files.keys()) {
  if (!file.includes("/")) continue; // main.cpp
  const room = dirname(file);
  if (!rooms.includes(room)) {
    problems.push(`${file}: arrows.cmake has no room ${room}`);
    continue;
  }
  const allowed = [room, ...listed.get(`${room}_includes`)];
  const never = listed.get(`${room}_never`) ?? [];
  const wrong = new Set();
  for (const [to, way] of reached(file)) {
    const its = roomOf(to);
    const inRoom = rooms.includes(its);
    if (inRoom) checked++;
    const against = way.length === 1 && inRoom && !allowed.includes(its);
    const forbidden = never.includes(its) || never.includes(its.split("/", 1)[0]);
    if ((!against && !forbidden) || wrong.has(its)) continue;
    wrong.add(its);
    const what = against ? "include" : "reach";
    problems.push(`${file}: ${room} may not ${what} ${its}: ${way.join(" includes ")}`);
  }
}
if (checked === 0) problems.push(`no includes were found below ${generator}`);

if (readme !== undefined) {
  const rows = readFileSync(readme, "utf8").matchAll(/^\| `([\w/]+)\/` \|.*\| ([^|]*) \|$/gm);
  const told = new Map([...rows].map(([, room, words]) => [room, words]));
  for (const room of rooms) {
    const words = listed.get(`${room}_includes`).join(", ") || "nothing of ours";
    if (told.get(room) === words) continue;
    problems.push(`${readme}: \`${room}/\` may include ${words}, and not ${told.get(room)}`);
  }
}

for (const problem of problems) console.error(problem);
console.log(`${files.size} files, ${checked} ways, ${problems.length} against the arrows`);
process.exitCode = problems.length > 0 ? 1 : 0;
