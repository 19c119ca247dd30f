/**
 * What a reader takes along as "Zip to build" (generator/page/program_folder.h) is what the page runs,
 * too: the program, its headers and its models, and what the lesson's run of it printed.
 */
import type { Program } from "../cpp/messages.js";
import type { ModelFiles } from "../engine/engine.js";
import { type Files, unzip } from "./unzip.js";
import { zip } from "./zip.js";

const regionMarks = /^[ \t]*\/\/ #(?:region |endregion).*\n/gm;
const outputFile = "expected-output.txt";

/** Of regions: in an exercise they say what its reader writes. */
type Marks = "shown" | "hidden";

export class Folder {
  readonly #name: string;
  readonly #files: Files;
  /** A lesson ran it. */
  readonly isOfLesson: boolean;
  readonly #marks: Marks;

  /** `name` is the program's, and the folder's: "l0_1_parabola". */
  private constructor(name: string, files: Files, isOfLesson: boolean, marks: Marks) {
    this.#name = name;
    this.#files = files;
    this.isOfLesson = isOfLesson;
    this.#marks = marks;
  }

  /** Of a program that the page has made, with the files of its models. */
  static made(name: string, text: string, models: ModelFiles): Folder {
    const bytes = (content: string | Uint8Array) =>
      typeof content === "string" ? new TextEncoder().encode(content) : new Uint8Array(content);
    const main = [`${name}/${name}.cpp`, bytes(text)] as const;
    const others = Object.entries(models).map(
      ([file, content]) => [`${name}/models/${file}`, bytes(content)] as const,
    );
    return new Folder(name, new Map([main, ...others]), false, "hidden");
  }

  /** Throws where the archive at `address` cannot be had. */
  static async fetch(address: string, marks: Marks): Promise<Folder> {
    const response = await fetch(address);
    if (!response.ok) throw new Error(`${response.status} for ${address}`);
    const files = await unzip(await response.arrayBuffer());
    return new Folder([...files.keys()][0]!.split("/")[0]!, files, true, marks);
  }

  /** The program as the lesson shows it. */
  get text(): string {
    const text = this.#read(`${this.#name}.cpp`);
    return this.#marks === "shown" ? text : text.replace(regionMarks, "");
  }

  /** What the lesson's run printed. */
  get output(): string {
    return this.#read(outputFile);
  }

  /** The text of the course's own header; "" where the program has none. */
  get helper(): string {
    return this.#read("include/mjcourse/mjcourse.hpp");
  }

  /** The files of its models, by the names by which one names another. */
  get models(): Readonly<Record<string, Uint8Array>> {
    const folder = `${this.#name}/models/`;
    const files = [...this.#files].filter(([path]) => path.startsWith(folder));
    return Object.fromEntries(files.map(([path, bytes]) => [path.slice(folder.length), bytes]));
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
