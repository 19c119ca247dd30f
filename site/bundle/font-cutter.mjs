// A worker thread that subsets fonts, and the pool of such threads.
//
//   const pool = new FontCutterPool();
//   const woff2 = await pool.cut({ file, ranges, axis });
//   pool.close();
//
// All pieces of one font go to the same thread, which decompresses the font once.

import { readFile } from "node:fs/promises";
import { availableParallelism } from "node:os";
import { isMainThread, parentPort, Worker } from "node:worker_threads";

import subsetFont from "subset-font";

import { features } from "./font-cuts.mjs";
import { rename } from "./font-name.mjs";
import { charactersOf } from "./unicode-range.mjs";

export class FontCutterPool {
  #workers = [];
  #workerOf = new Map(); // a font's path → its thread
  #waiting = new Map(); // a piece's number → what to do with it
  #count = 0;

  cut(piece) {
    const number = ++this.#count;
    const cut = new Promise((resolve, reject) => this.#waiting.set(number, { resolve, reject }));
    this.#workerFor(piece.file).postMessage({ number, piece });
    return cut;
  }

  close() {
    for (const worker of this.#workers) worker.terminate();
    this.#workers = [];
    this.#workerOf.clear();
  }

  #workerFor(file) {
    if (!this.#workerOf.has(file)) {
      const turn = this.#workerOf.size % Math.min(4, availableParallelism());
      this.#workers[turn] ??= this.#hire();
      this.#workerOf.set(file, this.#workers[turn]);
    }
    return this.#workerOf.get(file);
  }

  #hire() {
    const worker = new Worker(new URL(import.meta.url));
    worker.on("message", ({ number, woff2, error }) => {
      const { resolve, reject } = this.#waiting.get(number);
      if (error) reject(new Error(error));
      else resolve(woff2);
    });
    return worker;
  }
}

const sources = new Map(); // a font's path → its bytes, decompressed and renamed

async function readSource(file) {
  const options = { keepAllGlyphs: true, targetFormat: "truetype" };
  return rename(await subsetFont(await readFile(file), undefined, options));
}

async function cut({ file, ranges, axis }) {
  if (!sources.has(file)) sources.set(file, readSource(file));
  // The hints are for screens of old; half of a small KaTeX font is hints.
  const options = { targetFormat: "woff2", keepFeatures: features, noHinting: true };
  if (axis) options.variationAxes = { wght: axis };
  return subsetFont(await sources.get(file), charactersOf(ranges), options);
}

if (!isMainThread) {
  parentPort.on("message", async ({ number, piece }) => {
    try {
      parentPort.postMessage({ number, woff2: await cut(piece) });
    } catch (error) {
      parentPort.postMessage({ number, error: `${piece.file}: ${error.message}` });
    }
  });
}
