/** Where a run's output is none that the lesson states, by the build's own rules, which the engine has. */
import { type EngineBinary, startEngine } from "./engine.js";
import { Files } from "./files.js";
import type { OutputChanges, StatedOutput } from "./messages.js";

/** Of those stated, any will do; where none agrees, the first says what differs. */
export async function outputChanges(
  binary: EngineBinary,
  printed: string,
  stated: readonly StatedOutput[],
): Promise<OutputChanges> {
  const host = { args: [], files: new Files(), write: () => undefined };
  const engine = await startEngine(binary, host);
  const all = stated.map(({ text, tolerance }) => {
    const [gone = 0, ...come] = engine
      .outputChanges(text, printed, tolerance ?? -1)
      .split(" ")
      .map(Number);
    return { gone, come };
  });
  return all.find(({ gone, come }) => gone === 0 && come.length === 0) ?? all[0]!;
}
