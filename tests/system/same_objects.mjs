// Debian's clang makes the same objects as the page's own compiler, of all programs of the course:
//
//   node same_objects.mjs MJCOURSE COURSE
//
// The course is checked from nothing, as what is kept is not compiled.

import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";

const [mjcourse, course] = process.argv.slice(2);
if (!existsSync(join(dirname(dirname(mjcourse)), "assets/cpp/native/probe.o"))) {
  console.log("there is no native compiler for the page's programs");
  process.exit(77);
}
const store = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
try {
  const { status } = spawnSync(
    mjcourse,
    ["check", "--course", course, "--store", store, "--store-url", "none"],
    { stdio: "inherit", env: { ...process.env, MJCOURSE_COMPARE_ALL_OBJECTS: "1" } },
  );
  process.exitCode = status ?? 1;
} finally {
  rmSync(store, { recursive: true });
}
