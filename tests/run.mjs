// Runs ctest, and says meanwhile how long the rest took last time, and at the end what took longest.
//
//   node tests/run.mjs --test-dir build/release --parallel 2 …     all that ctest takes
//
// What ctest says goes through as it comes, but its last word: "100% tests passed, …" stands at the
// very end. On a terminal the rest is a line of its own that changes, and elsewhere it is said at the
// start and behind each test that has ended. A test that looks at many files (tests/lint/look.mjs) says
// how far it is in a file of the folder MJCOURSE_PROGRESS: `DONE ALL SECONDS`, the last of which are those
// that the rest will take, where that is known. Where all tests pass, the file MJCOURSE_PASSED says when
// and at which commit. The exit code is ctest's.

import { spawn, spawnSync } from "node:child_process";
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { createInterface } from "node:readline";

const words = process.argv.slice(2);

// The last value that follows one of `names`, also without a space: `-j2`.
function option(names, otherwise) {
  const text = words.join("\n");
  const found = [...text.matchAll(new RegExp(`^(?:${names.join("|")})\n?([^\n-].*)$`, "gm"))];
  return found.at(-1)?.[1] ?? otherwise;
}
const tree = option(["--test-dir"], ".");
const jobs = Number(option(["-j", "--parallel"], process.env.CTEST_PARALLEL_LEVEL)) || 1;

// The seconds that each test took when it last passed, which ctest keeps as `name runs seconds`.
function formerSeconds() {
  const file = join(tree, "Testing/Temporary/CTestCostData.txt");
  const text = existsSync(file) ? readFileSync(file, "utf8") : "";
  const lines = text.matchAll(/^(.+) (\d+) ([\d.e+-]+)$/gm);
  return new Map(
    [...lines].filter(([, , runs]) => runs > 0).map(([, name, , seconds]) => [name, +seconds]),
  );
}

// The names of the tests that the same words make ctest run.
function wantedTests() {
  const { stdout } = spawnSync("ctest", [...words, "-N"], { encoding: "utf8" });
  return new Set([...stdout.matchAll(/^ +Test +#\d+: (.+)$/gm)].map(([, name]) => name));
}

const spoken = (seconds) =>
  seconds < 90 ? `${Math.ceil(seconds)} s` : `${Math.round(seconds / 60)} min`;

// How long `names` will take, as a part of a line; "" where there are none. Nothing can be sooner than
// the longest of them.
function rest(names, former) {
  const times = [...names].filter((name) => former.has(name)).map((name) => former.get(name));
  const untimed = names.size - times.length;
  const tests = `${untimed} test${untimed === 1 ? "" : "s"}`;
  if (times.length === 0) return untimed > 0 ? `${tests} left, never timed` : "";
  const sum = times.reduce((a, b) => a + b, 0);
  const left = `about ${spoken(Math.max(sum / jobs, ...times))} left`;
  return untimed > 0 ? `${left}, and ${tests} never timed` : left;
}

const former = formerSeconds();
const waiting = wantedTests();
const all = waiting.size;
const took = new Map();
const terminal = process.stderr.isTTY;

// Whatever is said takes the place of the line that changes, which then follows.
function say(text, stream = process.stdout) {
  if (terminal) process.stderr.write("\r\x1b[K");
  stream.write(text);
  const left = rest(waiting, former);
  if (terminal && left) process.stderr.write([count(), left, ...marches()].join("; "));
}
const count = () => `${all - waiting.size}/${all} tests`;

// Of a test that looks at files: how many it has to look at, and how many are done.
const progress = mkdtempSync(join(tmpdir(), "mjcourse-progress-"));
const looking = new Map();
const marchOf = (name, { done, files }) => `${name} ${done}/${files} files`;

// The tests that look at files now.
function marches() {
  const now = [...looking].filter(([name, { done, files }]) => waiting.has(name) && done < files);
  return now.map(([name, one]) => marchOf(name, one));
}

// Reads how far such tests are, whose rest is then what they say, and not what they took last time. In a
// log there is a line at its start and at each quarter.
function follow() {
  const before = marches().join();
  for (const name of readdirSync(progress).filter((file) => waiting.has(file))) {
    const told = readFileSync(join(progress, name), "utf8").split(" ").map(Number);
    const [done, files, seconds] = told;
    const one = looking.get(name) ?? { quarters: -1 };
    looking.set(name, Object.assign(one, { done, files }));
    if (seconds !== undefined) former.set(name, seconds);
    else former.delete(name);
    const quarters = Math.floor((4 * done) / files);
    if (terminal || files === 0 || quarters <= one.quarters || quarters === 4) continue;
    one.quarters = quarters;
    const left = rest(waiting, former);
    say(`${marchOf(name, one)}${left && `; ${left}`}\n`);
  }
  if (terminal && marches().join() !== before) say("");
}

// What ctest says from its last "N% tests passed" on, to be said once the slowest tests are.
let closing = [];
// The beginning of what is said of a test that has ended: the reason may hold the end of a line.
let beginning = "";

function tell(line) {
  const text = beginning + line;
  const ended = /^ *\d+\/\d+ Test +#\d+: (\S+) /.exec(text);
  const seconds = /([\d.]+) sec *$/.exec(text)?.[1];
  if (ended && !seconds) {
    beginning = `${text}\n`;
    return;
  }
  beginning = "";
  if (!ended || !waiting.delete(ended[1])) {
    say(`${text}\n`);
    return;
  }
  took.set(ended[1], Number(seconds));
  const left = terminal ? "" : rest(waiting, former);
  say(left ? `${text}; ${left}\n` : `${text}\n`);
}

function slowest() {
  const first = [...took].sort(([, a], [, b]) => b - a).slice(0, 10);
  const rows = first.map(([name, seconds]) => `${seconds.toFixed(2).padStart(9)} sec  ${name}\n`);
  return first.length > 1 ? `The slowest tests:\n${rows.join("")}\n` : "";
}

// For the launcher, which tells it next time.
function keepPassed(file) {
  const asked = spawnSync("git", ["-C", import.meta.dirname, "describe", "--always", "--dirty"]);
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, `on ${new Date().toISOString().slice(0, 10)} at ${asked.stdout}`);
}

const lists = words.some((word) => /^(-N|--show-only(=.*)?)$/.test(word));
if (!lists && all > 0) say(terminal ? "" : `${count()}; ${rest(waiting, former)}\n`);
const ctest = spawn("ctest", words, {
  stdio: ["inherit", "pipe", "pipe"],
  env: { ...process.env, MJCOURSE_PROGRESS: progress },
});
const following = setInterval(follow, 500);
// Ctrl-C comes to both; a signal to this process alone is handed on.
for (const signal of ["SIGINT", "SIGTERM", "SIGHUP"]) process.on(signal, () => ctest.kill(signal));

createInterface({ input: ctest.stdout }).on("line", (line) => {
  if (/^\d+% tests passed/.test(line)) {
    closing.forEach(tell); // a test's own output looked like it
    closing = [];
  }
  if (closing.length > 0 || /^\d+% tests passed/.test(line)) closing.push(line);
  else tell(line);
});
let complaints = "";
ctest.stderr.on("data", (text) => {
  if (closing.length > 0) complaints += text;
  else say(text, process.stderr);
});

ctest.on("close", (code, signal) => {
  clearInterval(following);
  rmSync(progress, { recursive: true });
  waiting.clear();
  const [summary, ...lines] = closing;
  const rows = lines.join("\n").trim();
  say(`${beginning}${slowest()}${rows && `${rows}\n`}`);
  if (complaints) say(complaints, process.stderr);
  if (summary) say(`\n${summary}\n`);
  if (signal) {
    process.removeAllListeners(signal);
    process.kill(process.pid, signal);
  }
  if (code === 0 && process.env.MJCOURSE_PASSED) keepPassed(process.env.MJCOURSE_PASSED);
  process.exitCode = code;
});
