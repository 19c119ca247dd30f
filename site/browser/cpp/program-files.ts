/**
 * A program's files as the compiler and the running program see them.
 *
 * Headers are looked for beside the program, in its folder `include`, and then in the pack. A header
 * that the pack has too is left out, so that it is the one of the precompiled header; where a course
 * has changed it, the precompiled header would define all of it twice, and the program is compiled
 * without.
 */
import { Files, folderOf } from "./files.js";
import { modelsFolder, packFolder, programFolder } from "./flags.js";
import type { Program } from "./messages.js";

export interface CompiledFiles {
  readonly files: Files;
  /** Paths of what is compiled. */
  readonly sources: readonly string[];
  readonly include: string;
  /** Whether the precompiled header says what the program's own would say. */
  readonly takesPrepared: boolean;
  /** Whether the program has handlers of its own for MuJoCo's errors. */
  readonly hasHandlers: boolean;
}

export function filesToCompile(program: Program, pack: Files): CompiledFiles {
  const main = `${programFolder}/${program.main}`;
  const include = `${folderOf(main)}/include`;
  const files = new Files(pack);
  const sources = [main];
  let takesPrepared = !definesBeforeIncludes(asText(program.files[program.main] ?? ""));
  let hasHandlers = false;

  for (const [name, content] of Object.entries(program.files)) {
    const path = `${programFolder}/${name}`;
    const inPack = path.startsWith(`${include}/`)
      ? pack.bytes(packFolder + path.slice(include.length))
      : undefined;
    if (inPack && isSame(inPack, content)) continue;
    if (inPack && name.endsWith(".hpp")) takesPrepared = false;
    if (inPack && name.endsWith(".cpp")) hasHandlers = true;
    if (name.endsWith(".cpp") && path !== main) sources.push(path);
    files.put(path, content);
  }
  return { files, sources, include, takesPrepared, hasHandlers };
}

/** Those of a run: its models, and an empty folder to work in. */
export function filesToRun(program: Program): Files {
  const files = new Files();
  const models = `${program.models}/`;
  for (const [name, content] of Object.entries(program.files)) {
    if (name.startsWith(models)) files.put(`${modelsFolder}/${name.slice(models.length)}`, content);
  }
  return files;
}

/** A macro may change what a header says. */
const definesBeforeIncludes = (text: string) => /^\s*#\s*define\b[^]*^\s*#\s*include\b/m.test(text);

export const asText = (content: string | Uint8Array) =>
  typeof content === "string" ? content : new TextDecoder().decode(content);

function isSame(bytes: Uint8Array, content: string | Uint8Array): boolean {
  return new TextDecoder().decode(bytes) === asText(content);
}
