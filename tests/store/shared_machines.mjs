// Machines that share a store: each has a place of its own for a small course and for a store on its
// disk, and a check of it tells what was worked out there and what was said.
//
// A script of such cases takes MJCOURSE and, to run some of them alone, a part of their names.

import { spawn, spawnSync } from "node:child_process";
import {
  appendFileSync,
  cpSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";

import { withPageHalves } from "./page_halves.mjs";
import { token } from "./servers.mjs";

export const [mjcourse, asked = ""] = process.argv.slice(2);
export const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
let failed = 0;
let cases = 0;

export function expect(good, what) {
  if (good) return;
  ++failed;
  console.error(what);
}

export function write(folder, path, text) {
  mkdirSync(dirname(join(folder, path)), { recursive: true });
  writeFileSync(join(folder, path), text);
}

export const course = join(home, "course");
write(
  course,
  "content/course.yaml",
  "title: T\nlevels:\n  - {folder: 1-a, title: A, lessons: [1.1-b]}\n",
);
write(
  course,
  "models/ball.xml",
  '<mujoco><worldbody><light pos="0 0 3"/><body name="ball" pos="0 0 1"><freejoint/>' +
    '<geom size="0.1"/></body></worldbody></mujoco>\n',
);
write(
  course,
  "content/1-a/1.1-b.md",
  `---
title: B
---

The ball has \`{ball} model.nv :.0f\` degrees of freedom.

\`\`\`figure
{"model": "ball", "alt": "A ball.", "size": [160, 100]}
\`\`\`

\`\`\`lab simlab
{
  "title": "A ball",
  "model": "ball",
  "alt": "A ball in the air",
  "controls": [{"type": "button", "label": "Kick", "run": "data.qvel[0] = 1"}]
}
\`\`\`
`,
);
// What takes long, and depends on hundreds of headers.
export const program = `
\`\`\`cpp snippet model=ball
std::cout << model->nq << '\\n';
\`\`\`

\`\`\`text
7
\`\`\`
`;

// A machine has a place of its own for the course and for its store.
let machines = 0;
export function machine(more = "") {
  const folder = join(home, `machine-${++machines}`);
  const place = join(folder, "x".repeat(machines), "course");
  cpSync(course, place, { recursive: true });
  appendFileSync(join(place, "content/1-a/1.1-b.md"), more);
  return { folder, place, store: join(folder, "store") };
}

// Checks the course there; gives what was worked out, and what was said.
export async function check(there, server, ...more) {
  const trace = join(there.folder, "trace.json");
  const words = ["check", "--course", there.place, "--store", there.store, "--trace", trace];
  if (server?.url) words.push("--store-url", server.url);
  const environment = { ...process.env, ...server?.environment };
  const child = spawn(mjcourse, [...words, ...more], { env: environment });
  let said = "";
  for (const stream of [child.stdout, child.stderr]) stream.on("data", (bytes) => (said += bytes));
  const begin = Date.now();
  const status = await new Promise((done) => child.on("close", done));
  const seconds = (Date.now() - begin) / 1000;
  const { traceEvents } = JSON.parse(readFileSync(trace, "utf8"));
  const anew = traceEvents.filter((event) => event.cat === "worked").map((event) => event.name);
  const notes = said.split("\n").filter((line) => line.startsWith("note: "));
  return { status, said, anew: anew.sort(), notes, seconds };
}

export const all = (await check(machine(), undefined)).anew;
export const allOf = (more) =>
  more === ""
    ? all
    : [...all, ...withPageHalves(["compile and run the snippets of 1.1"], mjcourse)].sort();
expect(all.length > 3, `only ${all} is worked out`);

export async function test(name, run) {
  if (!name.includes(asked)) return;
  ++cases;
  try {
    await run();
  } catch (error) {
    expect(false, `${name}: ${error.stack}`);
  }
}

// A check that ends as without a server.
export async function expectRight(name, there, server, ...more) {
  const run = await check(there, server, ...more);
  expect(run.status === 0, `${name}: the check ends with ${run.status}: ${run.said}`);
  expect(!run.said.includes(token), `${name}: the token is told: ${run.said}`);
  return run;
}

// What another command says there, as [exit code, lines of stdout and stderr].
export function say(there, server, ...words) {
  const where = ["--store", there.store, ...(server ? ["--store-url", server.url] : [])];
  const ran = spawnSync(mjcourse, [...words, ...where], {
    encoding: "utf8",
    env: { ...process.env, ...server?.environment },
  });
  return [ran.status, (ran.stdout + ran.stderr).trim().split("\n")];
}

// At the end of all cases.
export function finish() {
  rmSync(home, { recursive: true });
  console.log(`${cases} cases, ${failed} problems`);
  process.exitCode = failed === 0 ? 0 : 1;
}
