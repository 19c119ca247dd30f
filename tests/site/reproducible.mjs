// The same course gives the same bytes, wherever it lies, in any time zone and language, on one
// processor as on all, by one job as by a job array, and worked out anew as well as found in the store.
// Where it is in a git repository, so is its copy: a page says when its lesson was changed.
//
//   node tests/site/reproducible.mjs MJCOURSE COURSE SITE [SHARDS]
//
// SITE is what COURSE was built into. With SHARDS, so many jobs of a Slurm check a share each, as the
// script does that `mjcourse new ci slurm` writes, and a last one builds the site. Together they work out
// a sixth of the course anew, which the commit chooses (sample.mjs). The rest comes from the store that
// SITE was built with, the user's, in which all of their results must have the same name.

import { spawnSync } from "node:child_process";
import {
  cpSync,
  existsSync,
  globSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { homedir, tmpdir } from "node:os";
import { join, resolve } from "node:path";

import { sampleOf } from "../sample.mjs";
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

// Makes the jobs do a part of the course alone; gives the numbers of their shards, of how many.
function chooseShards(script) {
  const jobs = Array.from({ length: Number(shards) }, (_, i) => i + 1);
  const parts = 6;
  const sample = sampleOf(parts);
  if (sample.all) return { chosen: jobs, all: jobs.length };
  const [first, all] = [sample.share * jobs.length, parts * jobs.length];
  const text = readFileSync(script, "utf8");
  const own = text.replace("--shard auto", `--shard $((${first} + SLURM_ARRAY_TASK_ID))/${all}`);
  if (own === text) throw new Error("the script for Slurm has no --shard auto");
  writeFileSync(script, own);
  return { chosen: jobs.map((job) => first + job), all };
}

// Puts what the user's store has beside what jobs have found; gives what is wrong with that. Two entries
// are no results and named by where the course lies: what is known of its files, by their paths, and
// which results its tasks have.
function addTheRest(moved) {
  const store = join(moved, "build/store");
  const cache = process.env.XDG_CACHE_HOME || join(homedir(), ".cache");
  const users = join(cache, "mjcourse", "store");
  const isOfItsPlace = (name) => {
    const text = readFileSync(join(store, name), "utf8");
    return text.includes(` ${moved}/`) || /^.*\n\{"content\/[^"]*":"ac\//.test(text);
  };
  const found = globSync("ac/*/*", { cwd: store }).filter((name) => !isOfItsPlace(name));
  const strange = found.filter((name) => !existsSync(join(users, name)));
  for (const part of ["ac", "cas"]) {
    cpSync(join(users, part), join(store, part), { recursive: true, force: false });
  }
  console.log(`${found.length} entries of the store are new`);
  if (found.length === 0) return "the jobs found nothing";
  // With what each is named by.
  const told = strange.map((name) => `${name}\n${asked(join(store, name))}`);
  return ["", ...told].join("\nhere alone an entry has the name ");
}

// The question that an entry of the store answers, in front of the answer.
const asked = (file) => readFileSync(file, "latin1").slice(0, 4000);

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
  const { chosen, all } = chooseShards(join(moved, "course.slurm"));
  const array = submit("--wait", `--array=1-${shards}`);
  const wrong = chosen.length < all ? addTheRest(moved) : "";
  const last = submit("--wait");
  const logs = globSync("course-*.log", { cwd: moved }).sort();
  const said = logs.map((log) => readFileSync(join(moved, log), "utf8"));
  const lines = chosen.map((shard) => `shard ${shard} of ${all}: `);
  const whole = lines.every((line) => said.some((log) => log.includes(line)));
  if (last.status === 0 && whole && wrong === "") return 0; // the last does again what failed
  console.error([array.stderr, ...said, wrong].join("\n"));
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
