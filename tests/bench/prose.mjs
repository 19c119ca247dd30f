// A thousand lessons of prose, written from nothing by mjcourse, by Hugo and by Pandoc; and ten
// thousand by mjcourse, whose memory should not grow with them.
//
//   node tests/bench/prose.mjs MJCOURSE [LESSONS]
//
// Hugo gets the same Markdown but for what opens its fences, and a theme that does what our pages
// do: the list of the level's lessons, contents, highlighting by classes, the way on. Pandoc, which
// has no sites, converts some of the lessons, each with contents, and is scaled up. The last line
// is JSON. Hugo or Pandoc may be missing, and then are left out.

import { execFileSync } from "node:child_process";
import { cpSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

import { has, measure, median, row } from "./measure.mjs";
import { writeCourse, writePlainLessons } from "./prose-course.mjs";

const mjcourse = resolve(process.argv[2]);
const lessons = Number(process.argv[3] ?? 1000);
const runs = 7;
const ofPandoc = 40; // lessons
const many = 10; // times as many lessons, for the memory

if (!has("time")) {
  console.log("prose: skipped; it measures with GNU time: apt-get install time");
  process.exit(0);
}
const home = mkdtempSync(join(tmpdir(), "mjcourse-bench-"));
process.on("exit", () => rmSync(home, { recursive: true }));

// Every run writes a folder of its own, and all are removed at the end: for some seconds after a
// site was removed, ext4 looks long for inodes.
let sites = 0;
const nextSite = () => join(home, `site-${sites++}`);

function build(course) {
  return measure(mjcourse, ["build", "--course", join(home, course), "--out", nextSite()]);
}

function hugo() {
  return measure("hugo", ["--quiet", "--source", join(home, "plain"), "-d", nextSite()]);
}

function pandoc() {
  const loop = `ls ${join(home, "plain/content")}/*/*lesson.md | head -n ${ofPandoc} |
    while read -r file; do pandoc -f gfm -s --toc --metadata title=T -o ${home}/p.html "$file"; done`;
  const taken = measure("sh", ["-c", loop]);
  const times = lessons / ofPandoc;
  return { ...taken, wall: taken.wall * times, cpu: taken.cpu * times };
}

writeCourse(join(home, "course"), lessons);
writePlainLessons(join(home, "plain"), lessons);
cpSync(join(import.meta.dirname, "hugo"), join(home, "plain"), { recursive: true });

// One after the other, so that whatever else the machine does meets both.
const compared = has("hugo");
const ours = [];
const theirs = [];
for (let run = 0; run < runs; ++run) {
  ours.push(build("course"));
  if (compared) theirs.push(hugo());
}
const result = { name: "prose", lessons, mjcourse: median(ours) };
console.log(row(`mjcourse, ${lessons} lessons`, result.mjcourse));
if (compared) {
  result.hugo = median(theirs);
  result.of_hugo = Number((result.mjcourse.wall / result.hugo.wall).toFixed(3));
  const version = /v[\d.]+/.exec(execFileSync("hugo", ["version"], { encoding: "utf8" }))?.[0];
  console.log(row(`Hugo ${version}`, result.hugo));
  console.log(`mjcourse takes ${result.of_hugo} of Hugo's wall time; at most 0.5 is wanted`);
} else {
  console.log("Hugo: skipped; apt-get install hugo");
}
if (has("pandoc")) {
  result.pandoc = pandoc();
  console.log(row(`Pandoc, of ${ofPandoc} lessons`, result.pandoc));
} else {
  console.log("Pandoc: skipped; apt-get install pandoc");
}
writeCourse(join(home, "many"), lessons * many);
result.many = { lessons: lessons * many, ...build("many") };
result.memory_growth = Number((result.many.memory / result.mjcourse.memory).toFixed(3));
console.log(row(`mjcourse, ${lessons * many} lessons`, result.many));
console.log(`${many} times the lessons take ${result.memory_growth} times the memory`);
console.log(JSON.stringify(result));
