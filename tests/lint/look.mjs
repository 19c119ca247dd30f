// Looks only at what was not found good before (stamps.mjs): a task is what it is called, the stamp that
// says that it was good, and the function that looks at it and gives what it complains of; "" for nothing.
//
//   await lookAt(new Stamps("format"), [{ name: "main.cpp", stamp, look: async () => "" }]);

import { execFile } from "node:child_process";
import { renameSync, writeFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import { join } from "node:path";

// What a tool says where it does not end with 0; else "".
export function complaintsOf(tool, words) {
  return new Promise((resolved) => {
    execFile(tool, words, { maxBuffer: Infinity }, (error, stdout, stderr) => {
      if (!error) resolved("");
      else resolved(stdout + stderr || `${error.message}\n`);
    });
  });
}

// Tells tests/run.mjs, where that runs us, how many of `all` are done and, where that is known, how many
// seconds the rest will take: as a file of its folder.
function tell(name, done, all, pace) {
  const folder = process.env.MJCOURSE_PROGRESS;
  if (!folder) return;
  const file = join(folder, name);
  const seconds = pace === undefined ? "" : ` ${pace * (all - done)}`;
  writeFileSync(`${file}.new`, `${done} ${all}${seconds}\n`);
  renameSync(`${file}.new`, file);
}

// Several at a time, in their order; the process fails where there were complaints, or no tasks.
export async function lookAt(stamps, tasks) {
  const waiting = tasks.filter(({ stamp }) => !stamps.has(stamp));
  const looked = waiting.length;
  const jobs = availableParallelism();
  const begin = performance.now();
  let done = 0;
  let failed = 0;
  tell(stamps.name, done, looked, stamps.pace);
  async function work() {
    for (let task = waiting.shift(); task; task = waiting.shift()) {
      const complaints = await task.look();
      if (complaints === "") stamps.put(task.stamp, task.name);
      else ++failed;
      process.stdout.write(complaints);
      ++done;
      // Of those that are being looked at, half is done.
      const pace = (performance.now() - begin) / 1000 / (done + (jobs - 1) / 2);
      tell(stamps.name, done, looked, pace);
      if (done === looked && done > jobs) stamps.pace = pace;
    }
  }
  await Promise.all(Array.from({ length: jobs }, work));
  console.log(`${tasks.length} checks, ${looked} done anew, complaints in ${failed}`);
  process.exitCode = failed > 0 || tasks.length === 0 ? 1 : 0;
}
