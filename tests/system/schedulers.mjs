// What `init --ci` and `new ci` write for a CI or a scheduler: its commands, run as that would run them,
// check a course in two shares, and then leave nothing to do.
//
//   node --test tests/system/schedulers.mjs     the generator is named by the environment: MJCOURSE

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, symlinkSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, test } from "node:test";

const mjcourse = resolve(process.env.MJCOURSE ?? "build/release/generator/mjcourse");
const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
after(() => rmSync(home, { recursive: true }));
symlinkSync(mjcourse, join(home, "mjcourse"));
const results = join(home, "results");

function run(folder, command, environment) {
  const { status, stdout, stderr } = spawnSync("bash", ["-c", command], {
    cwd: join(home, folder),
    encoding: "utf8",
    env: { ...process.env, PATH: `${home}:${process.env.PATH}`, ...environment },
  });
  return { status, said: stdout + stderr };
}

function begin(kind) {
  const { status, said } = run("", `mjcourse init ${kind} --ci=${kind}`, {});
  assert.equal(status, 0, said);
  return said;
}
const read = (kind, path) => readFileSync(join(home, kind, path), "utf8");

// The commands of a file that begin with mjcourse: those that check a share, and those that come last.
function commandsIn(text, before) {
  const all = [...text.matchAll(before)].map(([, command]) => `mjcourse ${command}`);
  return {
    shard: all.find((one) => one.includes("--shard")),
    last: all.filter((one) => !one.includes("--shard")),
  };
}

function expectWhole(kind, { shard, last }, jobOf, fill = (command) => command) {
  let tasks = 0;
  for (const number of [1, 2]) {
    const { status, said } = run(kind, fill(shard, number), jobOf(number));
    assert.equal(status, 0, said);
    const [, own, all] = new RegExp(
      `^shard ${number} of 2: (\\d+) of (\\d+) tasks?, by division`,
      "m",
    ).exec(said);
    assert.ok(Number(own) > 0 && Number(own) < Number(all), said);
    tasks += Number(own) / Number(all);
  }
  assert.ok(Math.abs(tasks - 1) < 1e-9, `the shards have ${tasks} of the tasks`);
  assert.ok(last.length > 0);
  for (const command of last) {
    const { status, said } = run(kind, `${fill(command, 0)} --timings`, jobOf(undefined));
    assert.equal(status, 0, said);
    assert.match(said, /^ +[\d.]+ ms {2}\d+ results kept from before$/m);
    assert.doesNotMatch(said, /ms {2}(?:compile and run|rehearse|draw a figure)/);
  }
}

test("GitHub", () => {
  assert.match(begin("github"), /^wrote \.github\/workflows\/course\.yml\n/);
  const text = read("github", ".github/workflows/course.yml");
  const fill = (command, number) =>
    command
      .replace("${{ matrix.number }}/${{ strategy.job-total }}", `${number}/2`)
      .replaceAll("$STORE", results);
  expectWhole("github", commandsIn(text, /run: mjcourse (.*)/g), () => ({}), fill);
});

test("GitLab", () => {
  assert.match(begin("gitlab"), /^wrote \.gitlab-ci\.yml\n/);
  const job = (number) => (number ? { CI_NODE_INDEX: `${number}`, CI_NODE_TOTAL: "2" } : {});
  const fill = (command) => command.replaceAll("build/store", results);
  const text = read("gitlab", ".gitlab-ci.yml");
  assert.match(text, /parallel: 2/);
  expectWhole("gitlab", commandsIn(text, /- mjcourse (.*)/g), job, fill);
});

test("Kubernetes", () => {
  assert.match(begin("kubernetes"), /^wrote course-job\.yaml\n/);
  const text = read("kubernetes", "course-job.yaml");
  const job = (number) =>
    number ? { JOB_COMPLETION_INDEX: `${number - 1}`, MJCOURSE_SHARDS: "2" } : {};
  const words = /args: \[(.*)\]/.exec(text)[1].replaceAll(",", "").replace("/course", ".");
  const store = `--store ${results}`;
  const commands = { shard: `mjcourse ${words} ${store}`, last: [`mjcourse build ${store}`] };
  expectWhole("kubernetes", commands, job);
});

// Slurm itself runs its script in tests/site/reproducible.mjs.
test("new ci adds to a course, and replaces nothing", () => {
  const { status, said } = run("github", "mjcourse new ci slurm", {});
  assert.equal(status, 0);
  assert.equal(
    said,
    "wrote course.slurm\nthe first lines of course.slurm say what has to be set up\n",
  );
  const again = run("github", "mjcourse new ci github", {});
  assert.equal(again.status, 1);
  assert.match(again.said, /^mjcourse: .*\.github\/workflows\/course\.yml/);
  const unknown = run("github", "mjcourse new ci gitlap", {});
  assert.equal(unknown.status, 2);
  assert.equal(
    unknown.said,
    "mjcourse: there is no file for `gitlap`\n  cure: did you mean `gitlab`?\n",
  );
  const wrong = run("", "mjcourse init more --ci jenkins", {});
  assert.equal(wrong.status, 2);
  assert.match(wrong.said, /--ci takes github, gitlab, slurm or kubernetes, not jenkins/);
});
