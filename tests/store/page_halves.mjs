// Tasks that run programs come in two: natively, and in the page where its compiler was built.

import { existsSync } from "node:fs";
import { dirname, join } from "node:path";

/** With the second of each of these tasks behind the first. */
export function withPageHalves(tasks, mjcourse) {
  if (!existsSync(join(dirname(dirname(mjcourse)), "assets/cpp/version"))) return tasks;
  const runsPrograms = /^compile and run |^try the exercise /;
  return tasks.flatMap((task) =>
    runsPrograms.test(task) ? [task, `${task} in the page`] : [task],
  );
}
