// Keeps the whole course, or the compiler, file by file: in front of the reader, who can stop it.

import { ask, type Inventory, type Keeping } from "./messages.js";

const atOnce = 4;
const reasons: Readonly<Record<Exclude<Keeping, "kept">, string>> = {
  "no room": "this browser refuses to keep more, or has no room",
  "no network": "the network cannot be reached",
  changed: "a newer version of the course has come meanwhile",
};

/** Of the course as it is read. */
export function missing({ files, asked, kept }: Inventory): string[] {
  const known = new Set([...kept, ...asked]);
  return Object.keys(files).filter((path) => !known.has(path));
}

/** Of what is asked for by itself: the compiler of C++. */
export function missingAsked({ asked, kept }: Inventory): string[] {
  return asked.filter((path) => !kept.includes(path));
}

export function sizeOf({ files }: Inventory, paths: readonly string[]): number {
  return paths.reduce((sum, path) => sum + (files[path] ?? 0), 0);
}

/** `tell` is given what share has come. Gives why it ended before all was kept; "" for all. */
export async function keepWhole(
  worker: ServiceWorker,
  signal: AbortSignal,
  tell: (share: number) => void,
): Promise<string> {
  const inventory = await ask(worker, "inventory");
  const reason = await keepFiles(worker, inventory, missing(inventory), signal, tell);
  if (reason === "") await ask(worker, "has all");
  return reason;
}

/** The same of the files at `paths`. */
export async function keepFiles(
  worker: ServiceWorker,
  inventory: Inventory,
  paths: readonly string[],
  signal: AbortSignal,
  tell: (share: number) => void,
): Promise<string> {
  const waiting = [...paths];
  const whole = sizeOf(inventory, waiting);
  let done = 0;
  let reason = "";
  const work = async () => {
    for (let path = waiting.pop(); path !== undefined; path = waiting.pop()) {
      const became = await ask(worker, "keep", path);
      if (became !== "kept") reason = reasons[became];
      else if (signal.aborted) reason = "you stopped it";
      if (reason) return;
      done += inventory.files[path] ?? 0;
      tell(done / whole);
    }
  };
  await Promise.all(Array.from({ length: atOnce }, work));
  return reason;
}
