// What a page and the site's worker (browser/worker/worker.ts) say to each other. Each message of a page
// is answered, on a port of its own.

/** What became of a file that was to be kept. */
export type Keeping = "kept" | "changed" | "no room" | "no network";

/** Paths are below the site's root. */
export interface Inventory {
  /** How many bytes each file of this edition has. */
  readonly files: Readonly<Record<string, number>>;
  /** Those that are kept only when they are asked for by themselves. */
  readonly asked: readonly string[];
  readonly kept: readonly string[];
}

export interface Answers {
  inventory: Inventory;
  keep: Keeping;
  "has all": boolean;
  forget: boolean;
  "take over": boolean;
}

export interface Message {
  readonly kind: keyof Answers;
  /** Of what is to be kept. */
  readonly path?: string;
}

export function ask<Kind extends keyof Answers>(
  worker: ServiceWorker,
  kind: Kind,
  path?: string,
): Promise<Answers[Kind]> {
  const { port1, port2 } = new MessageChannel();
  const message: Message = path === undefined ? { kind } : { kind, path };
  return new Promise((resolve) => {
    port1.onmessage = ({ data }: MessageEvent<Answers[Kind]>) => resolve(data);
    worker.postMessage(message, [port2]);
  });
}
