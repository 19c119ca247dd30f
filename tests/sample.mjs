// Which share of a costly test's work is done: one of several that the commit chooses, so that the next
// commit looks at another, and the tests' long mode (MJCOURSE_LONG) at all of them.
//
//   const sample = sampleOf(8);
//   if (sample.has(name)) …
//
// It says what it has chosen and how to have the same again: the environment's MJCOURSE_SAMPLE stands
// for the commit's hash, and `all` for the long mode. What is changed since the commit plays no part; a
// tree without git always has the same share.

import { spawnSync } from "node:child_process";
import { createHash } from "node:crypto";

const root = import.meta.dirname;
const asNumber = (text) => createHash("sha256").update(text).digest().readUInt32BE(0);

/** The commit that is checked out, as git abbreviates it; "" without git. */
export function commitOf(folder) {
  const asked = spawnSync("git", ["-C", folder, "rev-parse", "--short=12", "HEAD"], {
    encoding: "utf8",
  });
  return asked.status === 0 ? asked.stdout.trim() : "";
}

/** One of so many `shares`, which are counted from 0, or all of them. */
export function sampleOf(shares, { environment = process.env } = {}) {
  const seed = environment.MJCOURSE_SAMPLE ?? (environment.MJCOURSE_LONG ? "all" : commitOf(root));
  if (seed === "all" || shares === 1) return { all: true, has: () => true };
  const share = asNumber(seed) % shares;
  const again = seed === "" ? "of no commit" : `MJCOURSE_SAMPLE=${seed}`;
  console.log(`share ${share + 1} of ${shares} (${again}; MJCOURSE_SAMPLE=all takes all)`);
  return { all: false, share, has: (name) => asNumber(name) % shares === share };
}
