// How evenly a large course is dealt to machines, and what a store costs whose server is off.
//
//   node tests/bench/shards.mjs MJCOURSE DEAL_BENCH [PROGRAMS]
//
// A course is written that has PROGRAMS programs (400), one in ten much longer than the others, and
// five times as many other tasks: questions, each proved in a model of its own, and figures. It is
// checked once, and the trace says how long each task took. Then 1, 2, 4 and 8 shards find all in the
// store, so that their traces say only whose task is whose; the times are those of the first check.
// DEAL_BENCH deals 100,000 portions. At the end a tenth of the course is checked in an empty store,
// alternately without a shared one and with one whose server does not answer. The last line is the
// JSON that tests/bench/run keeps.

import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";

import { freePort } from "../store/servers.mjs";
import { measure, median } from "./measure.mjs";

const mjcourse = resolve(process.argv[2]);
const dealBench = resolve(process.argv[3]);
const programs = Number(process.argv[4] ?? 400);
const programsOfLesson = 4;
const home = mkdtempSync(join(tmpdir(), "mjcourse-bench-"));
process.on("exit", () => rmSync(home, { recursive: true }));

const folderOf = (lesson) => `${Math.floor(lesson / 20)}-level`;
const nameOf = (lesson) => `${Math.floor(lesson / 20)}.${(lesson % 20) + 1}-lesson`;

const programText = (number) => `#include <cstdio>
#include <mjcourse/mjcourse.hpp>

int main() {
  const mjcourse::Model model = mjcourse::load_model("box");
  const mjcourse::Data data = mjcourse::make_data(model);
  const int steps = ${number % 10 === 0 ? 400000 : 1000 + 37 * number};
  for (int i = 0; i < steps; ++i) mj_step(model, data);
  std::printf("${number}\\n");
}
`;

const programBlock = (number) => `\`\`\`cpp file=examples/p${number}.cpp
\`\`\`

\`\`\`text
${number}
\`\`\`
`;

function quizBlock(number) {
  const mass = 1 + (number % 97);
  const question = {
    kind: "numeric",
    q: `What is the mass of body ${number}?`,
    answer: mass,
    tol: 0.001,
    verify: [
      {
        mjcf: [
          `<mujoco model='m${number}'><worldbody><body><freejoint/>`,
          `<geom size='0.1' mass='${mass}'/></body></worldbody></mujoco>`,
        ],
        run: `step(${100 + 50 * (number % 20)})`,
        value: "model.body_mass[1]",
      },
    ],
  };
  const quiz = JSON.stringify({ id: `q${number}`, questions: [question] });
  return `\`\`\`quiz\n${quiz}\n\`\`\`\n`;
}

const figure = (number) => `\`\`\`figure
{"model": "box", "size": [320, 200], "alt": "A box.", "caption": "From side ${number}.",
 "camera": {"azimuth": ${number % 360}, "elevation": -20, "distance": 2, "target": [0, 0, 0.2]}}
\`\`\`
`;

function lessonText(lesson) {
  const numbers = Array.from({ length: programsOfLesson }, (_, i) => lesson * programsOfLesson + i);
  const blocks = numbers.flatMap((number) => {
    const quizzes = Array.from({ length: 5 }, (_, i) => quizBlock(5 * number + i));
    return [programBlock(number), ...quizzes, figure(number)];
  });
  return `---\ntitle: Lesson ${lesson}\n---\n\n${blocks.join("\n")}`;
}

function writeCourse(name, count) {
  const write = (path, text) => {
    const file = join(home, name, path);
    mkdirSync(dirname(file), { recursive: true });
    writeFileSync(file, text);
  };
  const lessons = Array.from({ length: count / programsOfLesson }, (_, i) => i);
  const levels = Map.groupBy(lessons, folderOf);
  const level = ([folder, its]) =>
    `  - {folder: ${folder}, title: ${folder}, lessons: [${its.map(nameOf).join(", ")}]}\n`;
  write("content/course.yaml", `title: ${name}\nlevels:\n${[...levels].map(level).join("")}`);
  write(
    "models/box.xml",
    `<mujoco><worldbody><light pos="0 0 3"/><geom type="plane" size="1 1 0.1"/>
<body pos="0 0 0.5"><freejoint/><geom type="box" size="0.1 0.1 0.1"/></body></worldbody></mujoco>\n`,
  );
  for (const lesson of lessons) {
    write(`content/${folderOf(lesson)}/${nameOf(lesson)}.md`, lessonText(lesson));
  }
  cpSync("examples/include", join(home, name, "examples/include"), { recursive: true });
  for (let i = 0; i < count; ++i) write(`examples/p${i}.cpp`, programText(i));
  return join(home, name);
}

// The tasks of a check by their names, and how long each took, in seconds.
function check(course, ...more) {
  const trace = join(home, "trace.json");
  const words = ["--course", course, "--store", join(home, "store"), "--trace", trace, ...more];
  execFileSync(mjcourse, ["check", ...words], { stdio: ["ignore", "ignore", "inherit"] });
  const { traceEvents } = JSON.parse(readFileSync(trace, "utf8"));
  return new Map(
    traceEvents
      .filter(({ cat, name }) => cat !== undefined && !name.startsWith("compile once"))
      .map(({ name, dur }) => [name, dur / 1e6]),
  );
}

const sum = (numbers) => numbers.reduce((all, one) => all + one, 0);

function longestOfMean(course, times, count) {
  const loads = Array.from({ length: count }, (_, i) => {
    const names = [...check(course, "--shard", `${i + 1}/${count}`).keys()];
    return sum(names.map((name) => times.get(name)));
  });
  return Number(((Math.max(...loads) * count) / sum(loads)).toFixed(3));
}

const course = writeCourse("large", programs);
const times = check(course);
const seconds = sum([...times.values()]);
const result = { name: "shards", programs, tasks: times.size, seconds: Math.round(seconds) };
console.log(`${times.size} tasks take ${result.seconds} s; the longest share by the mean:`);
result.longest_of_mean = {};
for (const count of [1, 2, 4, 8]) {
  const longest = longestOfMean(course, times, count);
  result.longest_of_mean[count] = longest;
  console.log(`  ${count} shards: ${longest}; at most 1.1 is wanted`);
}
result.dealing = JSON.parse(execFileSync(dealBench, ["100000", "64"], { encoding: "utf8" }));
console.log(`100,000 tasks are dealt in ${result.dealing.seconds} s; less than 1 s is wanted`);

const small = writeCourse("small", programs / 10);
const off = `http://127.0.0.1:${await freePort()}`;
const [without, withServerOff] = [[], []];
for (let i = 0; i < 3; ++i) {
  for (const [runs, url] of [
    [without, "none"],
    [withServerOff, off],
  ]) {
    const store = ["--store", join(home, `store-${url === off}-${i}`), "--store-url", url];
    runs.push(measure(mjcourse, ["check", "--course", small, ...store]));
  }
}
result.without = median(without);
result.server_off = median(withServerOff);
const [own, shared] = [result.without.wall, result.server_off.wall];
console.log(`a check in an empty store takes ${own} s, with a server that is off ${shared} s`);
console.log(JSON.stringify(result));
