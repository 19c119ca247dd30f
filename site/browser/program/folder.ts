/**
 * What a reader takes along as "Zip to build" (generator/page/program_folder.h) is what the page runs,
 * too: the program, its headers and its models, and what the lesson's run of it printed.
 */
import type { Program } from "../cpp/messages.js";
import { type Files, unzip } from "./unzip.js";
import { zip } from "./zip.js";

const regionMarks = /^[ \t]*\/\/ #(?:region |endregion).*\n/gm;
const outputFile = "expected-output.txt";

export class Folder {
  readonly #name: string;
  readonly #files: Files;

  /** `name` is the program's, and the folder's: "l0_1_parabola". */
  private constructor(name: string, files: Files) {
    this.#name = name;
    this.#files = files;
  }

  /** Throws where the archive at `address` cannot be had. */
  static async fetch(address: string): Promise<Folder> {
    const response = await fetch(address);
    if (!response.ok) throw new Error(`${response.status} for ${address}`);
    const files = await unzip(await response.arrayBuffer());
    return new Folder([...files.keys()][0]!.split("/")[0]!, files);
  }

  /** The program as the lesson shows it, without the marks of its regions. */
  get text(): string {
    return this.#read(`${this.#name}.cpp`).replace(regionMarks, "");
  }

  /** What the lesson's run printed. */
  get output(): string {
    return this.#read(outputFile);
  }

  /** The text of the course's own header; "" where the program has none. */
  get helper(): string {
    return this.#read("include/mjcourse/mjcourse.hpp");
  }

  /** To be run, with the reader's text in place of the lesson's. */
  program(text: string, words: readonly string[]): Program {
    const main = `${this.#name}.cpp`;
    const begin = this.#name.length + 1;
    const files = [...this.#files].map(([path, bytes]) => [path.slice(begin), bytes] as const);
    return {
      main,
      files: { ...Object.fromEntries(files), [main]: text },
      models: "models",
      arguments: words,
    };
  }

  /** To be taken along. What it printed before is no more expected. */
  zip(text: string): Promise<Blob> {
    const files = new Map(this.#files);
    files.set(`${this.#name}/${this.#name}.cpp`, new TextEncoder().encode(text));
    files.delete(`${this.#name}/${outputFile}`);
    return zip(files);
  }

  #read(path: string): string {
    return new TextDecoder().decode(this.#files.get(`${this.#name}/${path}`));
  }
}
