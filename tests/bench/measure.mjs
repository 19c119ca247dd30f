// What a command takes: wall and CPU time with its children, and the peak of its memory.

import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

export function has(program) {
  return spawnSync("which", [program]).status === 0;
}

/** Run `command` with GNU time; gives { wall, cpu } in seconds and { memory } in MB. */
export function measure(command, args, options = {}) {
  const home = mkdtempSync(join(tmpdir(), "mjcourse-bench-"));
  const log = join(home, "time");
  execFileSync("time", ["-f", "%e %U %S %M", "-o", log, command, ...args], {
    ...options,
    stdio: ["ignore", "ignore", "inherit"],
  });
  const [wall, user, system, kilobytes] = readFileSync(log, "utf8").trim().split(" ").map(Number);
  rmSync(home, { recursive: true });
  return { wall, cpu: user + system, memory: Math.round(kilobytes / 1024) };
}

/** Of several runs, the one in the middle by its wall time. */
export function median(runs) {
  return runs.toSorted((a, b) => a.wall - b.wall)[Math.floor(runs.length / 2)];
}

export function row(name, { wall, cpu, memory }) {
  const columns = [`${wall.toFixed(2)} s wall`, `${cpu.toFixed(2)} s CPU`, `${memory} MB`];
  return `${name.padEnd(28)} ${columns.map((column) => column.padStart(12)).join("  ")}`;
}
