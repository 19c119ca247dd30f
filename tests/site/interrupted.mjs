// A build that is killed, at whatever moment, leaves the site as it was or, where the kill came too
// late, the whole new one. The next build succeeds, and leaves nothing of the killed ones behind, and
// all that the user put into the site. And the result store that all of them wrote into gives the same site as a new one.
//
//   node tests/site/interrupted.mjs MJCOURSE [KILLS]
//
// A third of the KILLS are done, which the commit chooses (tests/sample.mjs).

import { spawn } from "node:child_process";
import { createHash } from "node:crypto";
import {
  existsSync,
  globSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  statSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { setTimeout as sleep } from "node:timers/promises";

import { sampleOf } from "../sample.mjs";

const mjcourse = process.argv[2];
const kills = Number(process.argv[3] ?? 50);
const lessons = 40; // enough that half of a build's time goes into writing
const span = 1.25; // kills are spread over so many times what a build takes: some come too late

const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const out = join(home, "out", "site");
const store = join(home, "store");
const temporary = join(home, "tmp");

function write(path, text) {
  mkdirSync(dirname(join(home, path)), { recursive: true });
  writeFileSync(join(home, path), text);
}

// A course that says `word` on every page; one of its lessons has a program.
function writeCourse(word) {
  const names = Array.from({ length: lessons }, (_, i) => `1.${i + 1}-lesson`);
  const level = `{folder: 1-level, title: Level, lessons: [${names.join(", ")}]}`;
  write("course/content/course.yaml", `title: ${word}\nlevels:\n  - ${level}\n`);
  const program = `#include <cstdio>\n\nint main() {\n  std::puts("${word}");\n}\n`;
  write("course/examples/say.cpp", program);
  const ball = "<body><freejoint/><geom size='1'/></body>";
  write("course/models/ball.xml", `<!--${word}--><mujoco><worldbody>${ball}</worldbody></mujoco>`);
  for (const [i, name] of names.entries()) {
    const example = i === 0 ? `\`\`\`cpp file=examples/say.cpp\n${program}\`\`\`\n` : "";
    const claims = `Twice $\\text{${word}}_{${i}}$ and \`{ball} model.nq\`.\n\n`;
    const text = `## About ${word}\n\nMuch of ${word}.\n\n`.repeat(100) + claims + example;
    write(`course/content/1-level/${name}.md`, `---\ntitle: ${word}\n---\n\n${text}`);
  }
}

function startBuild(kept = store) {
  const words = ["build", "--course", join(home, "course"), "--out", out, "--store", kept];
  const generator = spawn(mjcourse, words, {
    env: { ...process.env, TMPDIR: temporary },
    stdio: ["ignore", "ignore", "pipe"],
  });
  let said = "";
  generator.stderr.on("data", (text) => (said += text));
  const ended = new Promise((resolve) => generator.on("close", resolve));
  return { kill: () => generator.kill("SIGKILL"), ended, said: () => said };
}

// What the user has in the site. A kill may come before they are moved; then the next build does it.
const foreign = ["CNAME", ".git/HEAD", "1-level/notes.txt"];

// One hash for all names and bytes of what builds wrote.
function fingerprint() {
  const hash = createHash("sha256");
  for (const path of globSync("**", { cwd: out }).sort()) {
    if (foreign.includes(path)) continue;
    if (statSync(join(out, path)).isFile()) hash.update(path).update(readFileSync(join(out, path)));
  }
  return hash.digest("hex");
}

let failures = 0;
function expect(good, what) {
  if (good) return;
  ++failures;
  console.error(what);
}

try {
  mkdirSync(temporary);
  // The very first build takes longest: it compiles headers that all later ones find.
  writeCourse("first");
  expect((await startBuild().ended) === 0, "the first build fails");
  writeCourse("before");
  const start = performance.now();
  expect((await startBuild().ended) === 0, "the second build fails");
  const took = performance.now() - start;
  const clean = { beside: readdirSync(dirname(out)), temporary: readdirSync(temporary) };
  const before = fingerprint();
  for (const path of foreign) write(join("out/site", path), path);

  const seen = [];
  writeCourse("after");
  const sample = sampleOf(3);
  const moments = Array.from({ length: kills }, (_, i) => i).filter((i) => sample.has(`kill ${i}`));
  for (const i of moments) {
    const build = startBuild();
    // Spread over all of the build, at random within each part.
    await sleep(((i + Math.random()) / kills) * took * span);
    build.kill();
    await build.ended;
    seen.push(fingerprint());
  }

  const last = startBuild();
  expect((await last.ended) === 0, "the build after the killed ones fails");
  expect(last.said() === "", `the build after the killed ones says: ${last.said()}`);
  const after = fingerprint();
  expect((await startBuild(join(home, "new store")).ended) === 0, "a build from nothing fails");
  expect(fingerprint() === after, "the store gives another site than a new one");
  expect(after !== before, "the test is no good: both sites are the same");
  for (const [i, found] of seen.entries()) {
    const whole = found === before || found === after;
    expect(whole, `kill ${i + 1} of ${seen.length} left neither the old site nor the new one`);
    expect(i === 0 || found !== before || seen[i - 1] !== after, "the old site came back");
  }
  for (const path of foreign) {
    const kept = existsSync(join(out, path)) && readFileSync(join(out, path), "utf8") === path;
    expect(kept, `${path} is lost`);
  }
  for (const [folder, names] of [
    [dirname(out), clean.beside],
    [temporary, clean.temporary],
  ]) {
    const litter = readdirSync(folder).filter((name) => !names.includes(name));
    expect(litter.length === 0, `left behind in ${folder}: ${litter.join(", ")}`);
  }
  const early = seen.filter((found) => found === before).length;
  console.log(
    `${seen.length} kills of a build of ${took.toFixed(0)} ms, ${early} before the site was replaced`,
  );
} finally {
  rmSync(home, { recursive: true });
}
process.exitCode = failures > 0 ? 1 : 0;
