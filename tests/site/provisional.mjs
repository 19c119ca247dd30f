// The site that a first build writes before its programs have run as its pages run them: it says so, also
// after the build was interrupted, and no longer once all is proved.
//
//   node tests/site/provisional.mjs MJCOURSE

import { spawn, spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";

const mjcourse = process.argv[2];
const programs = 12; // with fewer, nobody would wait for long

const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const course = join(home, "course");
const site = join(course, "build/site");
const words = ["build", "--course", course, "--store", join(home, "store"), "--store-url", "none"];

function write(path, text) {
  mkdirSync(dirname(join(course, path)), { recursive: true });
  writeFileSync(join(course, path), text);
}

// Its last program has another size in the page, where `wrong`.
function writeCourse(wrong) {
  write(
    "content/course.yaml",
    "title: T\nlevels:\n  - {folder: 1-a, title: A, lessons: [1.1-b]}\n",
  );
  const fences = Array.from({ length: programs }, (_, i) => {
    const size = wrong && i === programs - 1 ? "sizeof(long)" : i;
    const program = `#include <cstdio>\n\nint main() {\n  std::printf("%d\\n", int(${size}));\n}\n`;
    write(`examples/p${i}.cpp`, program);
    return `\`\`\`cpp file=examples/p${i}.cpp\n${program}\`\`\`\n`;
  });
  write("content/1-a/1.1-b.md", `---\ntitle: B\n---\n\n${fences.join("\n")}`);
}

const previewed =
  `mjcourse: ${site}/index.html can be read; it is written again once its programs have run as its` +
  " pages run them\n";
const lacking = "the site lacks what programs are in its pages: fix the errors first\n";

const problems = [];
const expect = (good, what) => good || problems.push(what);

// Whether the site says of itself that it is not proved whole.
function saysSo() {
  const home = readFileSync(join(site, "index.html"), "utf8");
  const lesson = readFileSync(join(site, "1-a/1.1-b.html"), "utf8");
  const pages = [home, lesson].map((html) => html.includes("<strong>Provisional.</strong>"));
  return [...pages, existsSync(join(site, "assets/provisional.txt"))].join();
}

function build() {
  const { status, stdout, stderr } = spawnSync(mjcourse, words, { encoding: "utf8" });
  return { status, stdout, stderr };
}

// Kills a build as soon as the site can be read.
async function interrupt() {
  const child = spawn(mjcourse, words, { stdio: ["ignore", "ignore", "pipe"] });
  const ended = new Promise((done) => child.on("close", done));
  let said = "";
  child.stderr.on("data", (text) => {
    said += text;
    if (said.includes("can be read")) child.kill("SIGKILL");
  });
  await ended;
  return said;
}

if (!existsSync(join(dirname(mjcourse), "../assets/cpp/run.mjs"))) {
  console.log("the page's compiler was not built");
  process.exit(77);
}
try {
  writeCourse(true);
  expect((await interrupt()) === previewed, "the first build says nothing of the site");
  expect(saysSo() === "true,true,true", `after a kill, the site says: ${saysSo()}`);

  const wrong = build();
  expect(wrong.status === 1, `with a mistake, the build ends with ${wrong.status}`);
  expect(wrong.stderr.startsWith(previewed), `with a mistake, it says ${wrong.stderr}`);
  expect(wrong.stderr.includes("E-page-output"), `the mistake is not told: ${wrong.stderr}`);
  expect(wrong.stdout.endsWith(lacking), `with a mistake, the build says ${wrong.stdout}`);
  expect(saysSo() === "true,true,true", `with a mistake, the site says: ${saysSo()}`);

  writeCourse(false);
  const right = build();
  expect(right.status === 0, `without a mistake: ${right.status}, ${right.stderr}`);
  expect(saysSo() === "false,false,false", `the site that was proved says: ${saysSo()}`);

  writeCourse(true);
  const kept = build();
  expect(kept.status === 1 && !kept.stderr.includes("can be read"), "a proved site is replaced");
  expect(
    kept.stdout.endsWith("no site was written: fix the errors first\n"),
    `a proved site that stays is told as ${kept.stdout}`,
  );
  expect(saysSo() === "false,false,false", `the proved site that stays says: ${saysSo()}`);
} finally {
  rmSync(home, { recursive: true });
}
for (const problem of problems) console.error(problem);
console.log(`${problems.length} problems`);
process.exitCode = problems.length > 0 ? 1 : 0;
