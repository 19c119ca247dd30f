/**
 * Tries a link in a worker (trial.ts), with an engine of its own, bounded memory, and an end where it takes
 * too long: the page goes on meanwhile. Enter with tryApart(). This module is the worker as well.
 */
import type { LabLink } from "./lab-link.js";
import {
  type EngineAddress,
  fetchFiles,
  loadModule,
  openEngine,
  Unreachable,
} from "./resources.js";
import { Run } from "./run.js";
import { tryLink } from "./trial.js";

/** Absolute addresses of the lab's module and of the engine. */
export interface Tried {
  readonly module: string;
  readonly engine: EngineAddress;
  readonly link: LabLink;
}

/** `begun` once the lesson's own lab is there. */
type Told = "begun" | { readonly fault: string | undefined };

/** Milliseconds, from then on. */
const patience = 10_000;

/** Pages of 64 KiB by which the engine's memory grows, from then on. A browser may end a page with its
 * workers where one of them takes too much. */
const mostPages = 1 << 13;

/** Why the link is not for the page, as a clause; undefined where it may be done to the page’s lab. An
 * abort leaves that open. */
export function tryApart(tried: Tried, signal: AbortSignal): Promise<string | undefined> {
  const worker = new Worker(import.meta.url, { type: "module" });
  let waiting: ReturnType<typeof setTimeout> | undefined;
  const told = new Promise<string | undefined>((resolve) => {
    worker.onmessage = ({ data }: MessageEvent<Told>) => {
      const late = `it was not ready after ${patience / 1000} seconds`;
      if (data === "begun") waiting = setTimeout(() => resolve(late), patience);
      else resolve(data.fault);
    };
    worker.onerror = (event) => {
      event.preventDefault(); // the reader is told
      resolve(
        event.message ? `it broke off: ${event.message}` : "this browser cannot try it apart",
      );
    };
    signal.addEventListener("abort", () => resolve(undefined));
    worker.postMessage(tried);
  });
  return told.finally(() => {
    clearTimeout(waiting);
    worker.terminate();
  });
}

async function answer({ module, engine, link }: Tried): Promise<string | undefined> {
  try {
    const [opened, described] = await Promise.all([openEngine(engine), loadModule(module)]);
    const files = await fetchFiles(module, described.lab.model);
    const run = new Run(opened, described, files);
    boundMemory();
    postMessage("begun" satisfies Told);
    return tryLink(run, link);
  } catch (error) {
    if (error instanceof Unreachable) return error.message;
    return `it broke off: ${String(error)}`;
  }
}

/** MuJoCo then says that it could not allocate. */
function boundMemory(): void {
  const { prototype } = WebAssembly.Memory;
  const grow = Object.getOwnPropertyDescriptor(prototype, "grow")!.value as typeof prototype.grow;
  let left = mostPages;
  prototype.grow = function (this: WebAssembly.Memory, pages) {
    if (pages > left) throw new RangeError("a link may take no more memory");
    left -= pages;
    return grow.call(this, pages);
  };
}

if (typeof document === "undefined") {
  onmessage = ({ data }: MessageEvent<Tried>) => {
    void answer(data).then((fault) => postMessage({ fault } satisfies Told));
  };
}
