// The same course gives the same bytes, wherever it lies, in any time zone and language, on one
// processor as on all, and worked out anew as well as found in the store. Where it is in a git
// repository, so is its copy: a page says when its lesson was changed.
//
//   node tests/site/reproducible.mjs MJCOURSE COURSE SITE    SITE: what COURSE was built into

import { spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const [mjcourse, course, site] = process.argv.slice(2);
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

try {
  const [prefix, repository] = repositoryOf(course);
  if (repository !== undefined) clone(repository, join(elsewhere, "moved"));
  const moved = join(elsewhere, "moved", prefix);
  for (const part of ["content", "examples", "models"]) {
    if (!existsSync(join(course, part))) continue;
    cpSync(join(course, part), join(moved, part), { recursive: true });
  }
  const out = join(elsewhere, "another", "site");
  const environment = { TZ: "Asia/Kathmandu", LC_ALL: "C.UTF-8", LANGUAGE: "de", TERM: "dumb" };
  const build = [mjcourse, "build", "--course", moved, "--out", out];
  build.push("--store", join(elsewhere, "store"));
  const built = spawnSync("taskset", ["--cpu-list", "0", ...build], {
    env: { ...process.env, ...environment },
    stdio: ["ignore", "ignore", "inherit"],
  });
  const compared = spawnSync("diff", ["--recursive", "--brief", site, out]);
  const good = built.status === 0 && compared.status === 0;
  process.stdout.write(good ? "both sites hold the same bytes\n" : compared.stdout);
  process.exitCode = good ? 0 : 1;
} finally {
  rmSync(elsewhere, { recursive: true });
}
