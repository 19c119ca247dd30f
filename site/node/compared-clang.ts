/**
 * Compiles natively, and compares some of the objects with those of the page's own compiler: a sixteenth
 * of the programs, which their text chooses, or all. Enter with ComparedClang.object(). The first object that differs
 * ends it, since then no other can be believed.
 */
import { createHash } from "node:crypto";

import type { QuickCompiler } from "../browser/cpp/compiler.js";
import type { Files } from "../browser/cpp/files.js";
import { programFolder } from "../browser/cpp/flags.js";
import type { Tool } from "../browser/cpp/tool.js";
import { isSameObject, withoutProducers, type NativeClang } from "./native-clang.js";

export class ComparedClang implements QuickCompiler {
  constructor(
    private readonly clang: NativeClang,
    private readonly comparesAll: boolean,
  ) {}

  object(
    args: readonly string[],
    object: string,
    files: Files,
    tool: Tool,
  ): Uint8Array | undefined {
    const sources = new Map(
      files
        .paths()
        .filter((name) => name.startsWith(`${programFolder}/`))
        .map((name) => [name, files.bytes(name)!]),
    );
    const made = this.clang.make(args, sources);
    if (made && this.#isCompared(sources)) {
      const { ok } = tool.run(args, files);
      const own = files.bytes(object);
      if (!ok || !own || !isSameObject(made, own)) {
        throw new Error("the native compiler makes another object than the page's own does");
      }
    }
    return made && withoutProducers(made);
  }

  #isCompared(sources: ReadonlyMap<string, Uint8Array>): boolean {
    if (this.comparesAll) return true;
    const hash = createHash("sha256");
    for (const content of sources.values()) hash.update(content);
    return hash.digest()[0]! < 16;
  }
}
