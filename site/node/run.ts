/**
 * Compiles and runs programs as the page does, for the build, which proves that they print there what
 * they print natively.
 *
 *   node run.mjs --prepare CPP OUT        makes the precompiled header
 *   node run.mjs CPP ENGINE PREPARED      answers questions on its standard streams, one by one
 *
 * CPP is the folder of this file with llvm.wasm and cpp.pack, ENGINE that of MuJoCo for the browser. A
 * question and an answer are JSON behind their size as 8 bytes, as
 * generator/process/process_supervisor.h has them. The process stays between questions, since clang is
 * machine code then.
 */
import { readFileSync, readSync, writeFileSync, writeSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

import { Compiler, type Finished } from "../browser/cpp/compiler.js";
import type { EngineBinary, EngineFactory } from "../browser/cpp/engine.js";
import type { Diagnostic, End, Program } from "../browser/cpp/messages.js";
import type { Files } from "../browser/cpp/files.js";
import { makeHeader } from "../browser/cpp/header.js";
import { unpack } from "../browser/cpp/pack.js";

interface Question extends Omit<Program, "files"> {
  readonly files: Readonly<Record<string, { readonly text: string } | { readonly base64: string }>>;
}

interface Answer {
  readonly ok: boolean;
  readonly diagnostics: readonly Diagnostic[];
  readonly out: string;
  readonly err: string;
  /** Nothing where the program does not compile. */
  readonly end: End | null;
  readonly records: string;
  readonly seconds: {
    readonly compile: number;
    readonly link: number;
    readonly run: number;
  } | null;
}

const [first, second, third] = process.argv.slice(2) as [string, string, string];
if (first === "--prepare") prepare(second, third);
else await serve(first, second, third);

function prepare(cpp: string, out: string): void {
  writeFileSync(out, makeHeader(llvmIn(cpp), packIn(cpp)));
}

async function serve(cpp: string, engine: string, prepared: string): Promise<void> {
  const compiler = await Compiler.of({
    llvm: llvmIn(cpp),
    engine: await engineIn(engine),
    pack: packIn(cpp),
  });
  compiler.useHeader(readFileSync(prepared));
  for (let question = read(); question !== undefined; question = read()) {
    const { files, ...program } = JSON.parse(question) as Question;
    write(JSON.stringify(await answer(compiler, { ...program, files: decoded(files) })));
  }
}

async function answer(compiler: Compiler, program: Program): Promise<Answer> {
  const streams = { out: [] as Uint8Array[], err: [] as Uint8Array[] };
  let told: Pick<Answer, "ok" | "diagnostics"> = { ok: false, diagnostics: [] };
  const finished = await compiler.run(program, {
    compiled: (ok, diagnostics) => (told = { ok, diagnostics }),
    output: (stream, bytes) => streams[stream].push(bytes),
  });
  const text = (pieces: readonly Uint8Array[]) => Buffer.concat(pieces).toString("utf8");
  const { records = "", seconds = null } = finished ?? {};
  const end = finished ? placedEnd(compiler, finished, program) : null;
  return { ...told, out: text(streams.out), err: text(streams.err), end, records, seconds };
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

function llvmIn(cpp: string): WebAssembly.Module {
  return new WebAssembly.Module(readFileSync(path.join(cpp, "llvm.wasm")));
}

function packIn(cpp: string): Files {
  return unpack(readFileSync(path.join(cpp, "cpp.pack")));
}

async function engineIn(folder: string): Promise<EngineBinary> {
  const glue = pathToFileURL(path.resolve(folder, "engine.mjs")).href;
  const { default: factory } = (await import(glue)) as { readonly default: EngineFactory };
  return {
    factory,
    module: new WebAssembly.Module(readFileSync(path.join(folder, "engine.wasm"))),
  };
}

/** Nothing at the end of the stream. */
function read(): string | undefined {
  const size = bytes(8);
  return size && bytes(Number(size.readBigUInt64LE()))?.toString("utf8");
}

function bytes(count: number): Buffer | undefined {
  const buffer = Buffer.alloc(count);
  for (let at = 0; at < count;) {
    const read = readSync(0, buffer, at, count - at, null);
    if (read === 0) return undefined;
    at += read;
  }
  return buffer;
}

function write(text: string): void {
  const content = Buffer.from(text);
  const size = Buffer.alloc(8);
  size.writeBigUInt64LE(BigInt(content.length));
  const all = Buffer.concat([size, content]);
  for (let at = 0; at < all.length;) at += writeSync(1, all, at);
}
