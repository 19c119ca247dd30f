// The same course gives the same bytes, wherever it lies, in any time zone and language, on one
// processor as on all, and worked out anew as well as found in the store.
//
//   node tests/site/reproducible.mjs MJCOURSE COURSE SITE    SITE: what COURSE was built into

import { spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const [mjcourse, course, site] = process.argv.slice(2);
const elsewhere = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
try {
  for (const part of ["content", "examples", "models"]) {
    if (!existsSync(join(course, part))) continue;
    cpSync(join(course, part), join(elsewhere, "moved", part), { recursive: true });
  }
  const out = join(elsewhere, "another", "site");
  const environment = { TZ: "Asia/Kathmandu", LC_ALL: "C.UTF-8", LANGUAGE: "de", TERM: "dumb" };
  const build = [mjcourse, "build", "--course", join(elsewhere, "moved"), "--out", out];
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
