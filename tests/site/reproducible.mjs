// The same course gives the same bytes, wherever it lies, in any time zone and language, on one
// processor as on all, by one job as by a job array, and worked out anew as well as found in the store.
// Where it is in a git repository, so is its copy: a page says when its lesson was changed.
//
//   node tests/site/reproducible.mjs MJCOURSE COURSE SITE [SHARDS]
//
// SITE is what COURSE was built into. With SHARDS, so many jobs of a Slurm check a share each, as the
// script does that `mjcourse new ci slurm` writes, and a last one builds the site.

import { spawnSync } from "node:child_process";
import {
  cpSync,
  existsSync,
  globSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

import { startSlurm } from "../system/slurm.mjs";

const [mjcourse, course, site, shards] = process.argv.slice(2);
const elsewhere = mkdtempSync(join(tmpdir(), "mjcourse-test-"));

// Where in the repository the course lies, and the repository; nothing where there is none.
function repositoryOf(folder) {
  const words = ["-C", folder, "rev-parse", "--show-prefix", "--show-toplevel"];
  const asked = spawnSync("git", words, { encoding: "utf8" });
  return asked.status === 0 ? asked.stdout.split("\n") : ["", undefined];
}

// A clone without its files, whose index is that of the last commit.
function clone(repository, to) {
  spawnSync("git", ["clone", "--quiet", "--no-checkout", repository, to], { stdio: "inherit" });
  spawnSync("git", ["-C", to, "reset", "--quiet"], { stdio: "inherit" });
}

// Gives the exit code.
function build(moved, out, environment) {
  const words = ["build", "--course", moved, "--out", out, "--store", join(elsewhere, "store")];
  return spawnSync("taskset", ["--cpu-list", "0", mjcourse, ...words], {
    env: environment,
    stdio: ["ignore", "ignore", "inherit"],
  }).status;
}

// A job has one processor, and several run at the same time.
function buildByJobs(moved, environment) {
  const written = spawnSync(mjcourse, ["new", "ci", "slurm", "--course", moved]);
  if (written.status !== 0) throw new Error(String(written.stderr));
  const submit = (...words) =>
    spawnSync("sbatch", ["--cpus-per-task=1", ...words, "course.slurm"], {
      cwd: moved,
      env: { ...environment, MJCOURSE: resolve(mjcourse) },
      encoding: "utf8",
    });
  const array = submit("--parsable", `--array=1-${shards}`);
  if (array.status !== 0) throw new Error(array.stderr);
  const last = submit("--wait", `--dependency=afterany:${array.stdout.trim()}`);
  const logs = globSync("course-*.log", { cwd: moved }).sort();
  const said = logs.map((log) => readFileSync(join(moved, log), "utf8"));
  const lines = Array.from({ length: Number(shards) }, (_, i) => `shard ${i + 1} of ${shards}: `);
  const whole = lines.every((line) => said.some((log) => log.includes(line)));
  if (last.status === 0 && whole) return 0;
  console.error(said.join("\n"));
  return 1;
}

let slurm;
try {
  const [prefix, repository] = repositoryOf(course);
  if (repository !== undefined) clone(repository, join(elsewhere, "moved"));
  const moved = join(elsewhere, "moved", prefix);
  for (const part of ["content", "examples", "models"]) {
    if (!existsSync(join(course, part))) continue;
    cpSync(join(course, part), join(moved, part), { recursive: true });
  }
  if (shards !== undefined) {
    mkdirSync(join(elsewhere, "slurm"));
    slurm = await startSlurm(join(elsewhere, "slurm"));
    if (slurm.why) {
      console.log(slurm.why);
      process.exit(77);
    }
  }
  const out = shards === undefined ? join(elsewhere, "another", "site") : join(moved, "build/site");
  const environment = {
    ...(slurm?.environment ?? process.env),
    ...{ TZ: "Asia/Kathmandu", LC_ALL: "C.UTF-8", LANGUAGE: "de", TERM: "dumb" },
  };
  const status =
    shards === undefined ? build(moved, out, environment) : buildByJobs(moved, environment);
  const compared = spawnSync("diff", ["--recursive", "--brief", site, out]);
  const good = status === 0 && compared.status === 0;
  process.stdout.write(good ? "both sites hold the same bytes\n" : compared.stdout);
  process.exitCode = good ? 0 : 1;
} finally {
  await slurm?.stop?.();
  rmSync(elsewhere, { recursive: true });
}
