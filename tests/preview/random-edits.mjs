// Whatever an author does, for however long: in the end the preview has what a build would write, and
// no memory, handle or process was lost on the way.
//
//   node tests/preview/random-edits.mjs MJCOURSE COURSE [EDITS] [SEED]

import { execFileSync, spawnSync } from "node:child_process";
import {
  cpSync,
  globSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  renameSync,
  rmSync,
  statSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";

import { preview } from "./previewed.mjs";

const [mjcourse, folder, edits = "120", seed = "1"] = process.argv.slice(2);

// Numbers that are the same in each run with one seed (mulberry32).
function dice(state) {
  return (sides) => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) % sides;
  };
}

const roll = dice(Number(seed));
const pick = (list) => list[roll(list.length)];
const pause = (ms) => new Promise((done) => setTimeout(done, ms));
const words = [
  "`",
  "$x$",
  "**",
  "> [!pitfall] A",
  "\n\n",
  "{",
  '"',
  "```",
  "![a](b.png)",
  "[[a]]",
  "é\u0000",
];

function git(previewed, ...command) {
  const identity = ["-c", "user.name=a", "-c", "user.email=a@b"];
  execFileSync("git", [...identity, ...command], { cwd: previewed.course, stdio: "pipe" });
}

// Each leaves the course as it likes; what it does comes back as a text, for the reader of a failure.
const deeds = {
  write(previewed, file) {
    const text = previewed.read(file);
    const at = roll(text.length + 1);
    previewed.write(file, `${text.slice(0, at)} ${pick(words)} ${text.slice(at)}`);
  },
  number(previewed, file) {
    previewed.write(
      file,
      previewed.read(file).replace(/\d+/g, (n) => (roll(9) === 0 ? String(roll(100)) : n)),
    );
  },
  cut(previewed, file) {
    const text = previewed.read(file);
    previewed.write(file, text.slice(0, roll(text.length + 1)));
  },
  remove(previewed, file) {
    rmSync(previewed.path(file));
  },
  rename(previewed, file) {
    renameSync(previewed.path(file), previewed.path(`${file}.other`));
  },
  removeFolder(previewed) {
    rmSync(previewed.path(pick(["content", "models", "examples"])), { recursive: true });
  },
  other(previewed) {
    git(previewed, "checkout", "-qf", "other");
  },
};

function filesOf(previewed) {
  return globSync("{content,models,examples}/**/*.*", { cwd: previewed.course }).filter((file) =>
    statSync(previewed.path(file)).isFile(),
  );
}

function restore(previewed) {
  git(previewed, "checkout", "-qf", "main");
  git(previewed, "clean", "-qfd");
}

const handles = ({ process }) => readdirSync(`/proc/${process.pid}/fd`).length;
const children = ({ process }) =>
  readFileSync(`/proc/${process.pid}/task/${process.pid}/children`, "utf8").trim();
const megabytes = ({ process }) =>
  Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${process.pid}/status`, "utf8"))[1]) / 1024;

async function compareWithBuild(previewed) {
  const out = mkdtempSync(join(tmpdir(), "built-"));
  const site = join(out, "site");
  // Of the dates that a build has from git, a preview knows nothing.
  const course = join(out, "course");
  cpSync(previewed.course, course, {
    recursive: true,
    filter: (file) => basename(file) !== ".git",
  });
  const built = spawnSync(mjcourse, ["build", "--course", course, "--out", site]);
  previewed.expect(built.status === 0, `the course does not build: ${built.stderr}`);
  for (const entry of readdirSync(site, { recursive: true, withFileTypes: true })) {
    if (!entry.isFile() || entry.name.startsWith(".")) continue;
    // A preview keeps nothing for reading without a network.
    if (/^(sw\.js|edition-\w+\.json)$/.test(entry.name)) continue;
    const file = join(entry.parentPath, entry.name);
    const path = file.slice(site.length + 1);
    const answer = await fetch(previewed.root + path);
    let bytes = Buffer.from(await answer.arrayBuffer());
    let expected = readFileSync(file);
    if (path.endsWith(".html")) {
      const text = bytes
        .toString()
        .replace(/<script src="\/\.preview\/preview\.js" data-page="\w+"><\/script>\n/, "");
      bytes = Buffer.from(text.replace(/<!--lines( \d+-\d+)?-->\n/g, ""));
      expected = Buffer.from(expected.toString().replace(/ data-offline="[^"]+"/g, ""));
    }
    previewed.expect(answer.status === 200, `${path}: ${answer.status}`);
    previewed.expect(bytes.equals(expected), `${path} is not what a build writes`);
  }
  rmSync(out, { recursive: true });
}

function setup(course) {
  const previewed = { course };
  execFileSync("git", ["init", "-qb", "main"], { cwd: course });
  git(previewed, "add", ".");
  git(previewed, "commit", "-qm", "main");
  git(previewed, "checkout", "-qb", "other");
  for (const file of globSync("content/**/*.md", { cwd: course })) {
    const text = readFileSync(join(course, file), "utf8");
    execFileSync("tee", [join(course, file)], { input: `${text}\nOf the other branch.\n` });
  }
  git(previewed, "commit", "-qam", "other");
  git(previewed, "checkout", "-q", "main");
}

await preview(
  mjcourse,
  folder,
  async (previewed) => {
    await previewed.settled();
    const [lesson] = globSync("**/*.md", { cwd: previewed.path("content") }).sort();
    const page = lesson.replace(/md$/, "html");
    const tab = await previewed.open(page);
    const before = { handles: 0, megabytes: 0 };
    for (let i = 0; i < Number(edits); i++) {
      const files = filesOf(previewed);
      const name = files.length === 0 || roll(5) === 0 ? "restore" : pick(Object.keys(deeds));
      if (name === "restore") restore(previewed);
      else deeds[name](previewed, pick(files));
      await pause(roll(3) === 0 ? 300 : 30);
      if (previewed.process.exitCode !== null || previewed.process.signalCode !== null) {
        throw new Error(`the preview died after ${name}, edit ${i} of seed ${seed}`);
      }
      if (i > Math.floor(Number(edits) / 3)) continue;
      // Script engines take memory and give it back as they please, so it is the most that counts.
      before.megabytes = Math.max(before.megabytes, megabytes(previewed));
      if (i < Math.floor(Number(edits) / 3)) continue;
      restore(previewed);
      await previewed.settled();
      before.handles = handles(previewed);
    }
    restore(previewed);
    await pause(500);
    const last = await previewed.settled(page);
    previewed.expect(last.diagnostics.length === 0, JSON.stringify(last.diagnostics[0]));
    // The browser complained of pages that were not there, and rightly.
    previewed.problems = previewed.problems.filter((problem) => !/ 404 /.test(problem));
    await tab.close();
    await compareWithBuild(previewed);
    const after = { handles: handles(previewed), megabytes: megabytes(previewed) };
    console.log(`in the first third, and at the end: ${JSON.stringify([before, after])}`);
    previewed.expect(after.handles <= before.handles + 2, "handles were lost");
    previewed.expect(after.megabytes < 1.5 * before.megabytes + 50, "memory was lost");
    previewed.expect(children(previewed).split(" ").length <= 1, "processes were left");
  },
  { setup },
);
