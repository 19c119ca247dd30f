/**
 * What the build asks of the page's compiler: a program to compile and run, and how that went. Enter
 * with answer().
 */
import { createHash } from "node:crypto";

import type { Compiler, Finished } from "../browser/cpp/compiler.js";
import type { Diagnostic, End, Program } from "../browser/cpp/messages.js";
import type { Stream } from "../browser/cpp/wasi.js";

export interface Question extends Omit<Program, "files"> {
  readonly files: Readonly<Record<string, { readonly text: string } | { readonly base64: string }>>;
}

export interface Answer {
  readonly ok: boolean;
  /** The SHA-256 of the linked module; null where the program does not compile. */
  readonly module: string | null;
  readonly diagnostics: readonly Diagnostic[];
  readonly out: string;
  readonly err: string;
  /** Nothing where the program does not compile. */
  readonly end: End | null;
  readonly records: string;
  readonly seconds: Finished["seconds"] | null;
}

export async function answer(compiler: Compiler, question: Question): Promise<Answer> {
  const program = { ...question, files: decoded(question.files) };
  const streams = { out: [] as Uint8Array[], err: [] as Uint8Array[] };
  let told: Pick<Answer, "ok" | "diagnostics"> = { ok: false, diagnostics: [] };
  const finished = await compiler.run(program, {
    compiled: (ok, diagnostics) => (told = { ok, diagnostics }),
    output: (stream: Stream, bytes) => streams[stream].push(bytes),
  });
  const text = (pieces: readonly Uint8Array[]) => Buffer.concat(pieces).toString("utf8");
  const { records = "", seconds = null } = finished ?? {};
  const end = finished ? placedEnd(compiler, finished, program) : null;
  const module = finished ? createHash("sha256").update(finished.code).digest("hex") : null;
  const written = { out: text(streams.out), err: text(streams.err), records };
  return { ...told, module, ...written, end, seconds };
}

/** With its line where somebody will look for that: a code is most often what the author expects. */
function placedEnd(compiler: Compiler, { end, offsets }: Finished, program: Program): End {
  if (end.how === "exit") return end;
  const line = compiler.lineOf(offsets, program);
  return line === undefined ? end : { ...end, line };
}

function decoded(files: Question["files"]): Program["files"] {
  const content = (file: Question["files"][string]) =>
    "text" in file ? file.text : Buffer.from(file.base64, "base64");
  return Object.fromEntries(Object.entries(files).map(([name, file]) => [name, content(file)]));
}
