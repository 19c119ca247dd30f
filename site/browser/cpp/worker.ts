/**
 * The worker that compiles and runs its reader's C++, one program after the other; messages.ts has what
 * it is told and tells. It holds some hundred megabytes, so a page has one.
 */
import { Compiler } from "./compiler.js";
import { Downloads, NoNetwork } from "./download.js";
import type { EngineFactory } from "./engine.js";
import { isOutOfMemory } from "./exhausted.js";
import { makeHeader } from "./header.js";
import { keepHeader, keptHeader } from "./kept-header.js";
import type { FromWorker, Stage, ToWorker } from "./messages.js";
import { OutputText } from "./output-text.js";
import { unpack } from "./pack.js";

type Addresses = Extract<ToWorker, { readonly kind: "open" }>;
type Run = Extract<ToWorker, { readonly kind: "run" }>;

let compiler: Compiler | undefined;

onmessage = ({ data }: MessageEvent<ToWorker>) => {
  void (data.kind === "open" ? open(data) : run(data)).catch(fail);
};

async function open(addresses: Addresses): Promise<void> {
  const parts = await load(addresses);
  compiler = await Compiler.of(parts);

  const version = `${addresses.pack}?${new URLSearchParams({ llvm: addresses.llvm }).toString()}`;
  const kept = await keptHeader(version);
  if (!kept) tell("header", 0);
  const header = kept ?? makeHeader(parts.llvm, parts.pack);
  if (!kept) await keepHeader(version, header);
  compiler.useHeader(header);
  say({ kind: "ready" });
}

async function load({ llvm, pack, engineGlue, engineWasm }: Addresses) {
  const downloads = new Downloads((done, total) => tell("download", done, total));
  const [packStream, llvmStream] = await downloads.start([pack, llvm]);
  const packed = unpack(new Uint8Array(await new Response(packStream).arrayBuffer()));
  tell("compile-tools", 0);
  const wasm = { headers: { "Content-Type": "application/wasm" } };
  const [llvmModule, engineModule, glue] = await Promise.all([
    WebAssembly.compileStreaming(new Response(llvmStream, wasm)),
    WebAssembly.compileStreaming(fetch(engineWasm)),
    import(engineGlue) as Promise<{ readonly default: EngineFactory }>,
  ]);
  tell("compile-tools", 1);
  const engine = { factory: glue.default, module: engineModule };
  return { llvm: llvmModule, pack: packed, engine };
}

async function run({ id, program, stated }: Run): Promise<void> {
  let printed = "";
  const output = new OutputText((stream, text) => {
    if (stream === "out") printed += text;
    say({ kind: "output", id, stream, text });
  });
  const finished = await compiler!.run(program, {
    compiled: (ok, diagnostics) => say({ kind: "compiled", id, diagnostics, ok }),
    output: (stream, bytes) => output.add(stream, bytes),
  });
  output.end();
  if (!finished) return;
  const changes = stated.length > 0 ? await compiler!.compare(printed, stated) : undefined;
  const { end, offsets, records, model, seconds } = finished;
  const line = compiler!.lineOf(offsets, program);
  const placed = line === undefined ? end : { ...end, line };
  say({ kind: "ended", id, end: placed, records, model, seconds, changes });
}

function fail(error: unknown): void {
  const isNetwork = error instanceof NoNetwork;
  const why = isNetwork ? "network" : isOutOfMemory(error) ? "memory" : "unknown";
  say({ kind: "failed", why, message: String(error) });
}

function tell(stage: Stage, done: number, total = 1): void {
  say({ kind: "progress", stage, done, total });
}

function say(message: FromWorker): void {
  postMessage(message);
}
