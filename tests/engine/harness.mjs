// The engine under test, as the page has it: site/browser/engine/ bundled, over the built engine.wasm.
// MJCOURSE_ENGINE is the folder with that, MJCOURSE_NATIVE the program of native.cpp.

import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";

const site = path.resolve(import.meta.dirname, "../../site");
// The npm packages are the site's.
export const require = createRequire(path.join(site, "package.json"));

export const built = process.env.MJCOURSE_ENGINE;
export const models = path.join(import.meta.dirname, "models");

// Without its sources there is no engine; tests/engine/CMakeLists.txt knows these words.
if (!existsSync(path.join(built, "engine.wasm"))) {
  console.log("MuJoCo for the browser was not built");
  process.exit();
}

// The module site/ENTRY with all that it imports.
export async function bundleText(entry) {
  const { outputFiles } = await require("esbuild").build({
    absWorkingDir: site,
    entryPoints: [entry],
    bundle: true,
    format: "esm",
    target: "es2022",
    write: false,
  });
  return outputFiles[0].text;
}

const module = Buffer.from(await bundleText("browser/engine/engine.ts")).toString("base64");
const { loadEngine } = await import(`data:text/javascript;base64,${module}`);

// A new engine with its own memory.
export function newEngine() {
  return loadEngine({
    glue: pathToFileURL(path.join(built, "engine.mjs")).href,
    wasmBinary: readFileSync(path.join(built, "engine.wasm")),
  });
}

// The simulation of a model file and what it names beside it.
export function load(engine, file, beside = []) {
  const name = path.basename(file);
  const files = { [name]: readFileSync(file) };
  for (const other of beside) files[other] = readFileSync(path.join(path.dirname(file), other));
  return engine.load(name, files);
}

// The same state from the native library. The C library has variants of pow, sin and cos for
// processors with a fused multiply-add, whose last bits are others; WebAssembly has no such
// instruction, so they are switched off, on whatever processor the tests run.
export function nativeState(file, steps) {
  const hex = runNative(["state", `${steps}`, file], {
    GLIBC_TUNABLES: "glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2",
  });
  const bytes = Buffer.from(hex, "hex");
  return Float64Array.from({ length: bytes.length / 8 }, (_, i) => bytes.readDoubleBE(i * 8));
}

// Steps per second of the native library.
export function nativeSpeed(file, steps) {
  return Number(runNative(["speed", `${steps}`, file], {}));
}

function runNative(args, environment) {
  const env = { ...process.env, ...environment };
  return execFileSync(process.env.MJCOURSE_NATIVE, args, {
    encoding: "utf8",
    env,
  }).trim();
}
