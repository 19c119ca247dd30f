// Looks only at what was not found good before (stamps.mjs): a task is what it is called, the stamp that
// says that it was good, and the function that looks at it and gives what it complains of; "" for nothing.
//
//   await lookAt(new Stamps("format"), [{ name: "main.cpp", stamp, look: async () => "" }]);

import { execFile } from "node:child_process";
import { availableParallelism } from "node:os";

// What a tool says where it does not end with 0; else "".
export function complaintsOf(tool, words) {
  return new Promise((resolved) => {
    execFile(tool, words, { maxBuffer: Infinity }, (error, stdout, stderr) => {
      if (!error) resolved("");
      else resolved(stdout + stderr || `${error.message}\n`);
    });
  });
}

// Several at a time, in their order; the process fails where there were complaints, or no tasks.
export async function lookAt(stamps, tasks) {
  const waiting = tasks.filter(({ stamp }) => !stamps.has(stamp));
  const looked = waiting.length;
  let failed = 0;
  async function work() {
    for (let task = waiting.shift(); task; task = waiting.shift()) {
      const complaints = await task.look();
      if (complaints === "") stamps.put(task.stamp, task.name);
      else ++failed;
      process.stdout.write(complaints);
    }
  }
  await Promise.all(Array.from({ length: availableParallelism() }, work));
  console.log(`${tasks.length} checks, ${looked} done anew, complaints in ${failed}`);
  process.exitCode = failed > 0 || tasks.length === 0 ? 1 : 0;
}
