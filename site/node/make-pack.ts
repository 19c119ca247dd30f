/**
 * Makes the pack: all that a program is compiled of and linked with in the page, besides its own files.
 * And the precompiled header, which the build itself takes.
 *
 *   node make-pack.mjs PROJECT LLVM RESOURCES OUT      writes OUT/cpp.pack and OUT/header.pch
 *
 * LLVM is the compiler as bundle/cpp.mjs leaves it, RESOURCES the archive of its headers and libraries.
 * To these come Eigen, MuJoCo's headers and the helper header, and what our clang itself compiles here:
 * the runtime (browser/cpp/runtime/), the two sources of libc++abi that throw and catch, which the
 * package lacks and emscripten has, and what the precompiled header defines.
 */
import { readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import path from "node:path";

import { Files } from "../browser/cpp/files.js";
import {
  packFolder,
  prepareArguments,
  preparedHeader,
  preparedObject,
  prepareObjectArguments,
  preparedSource,
  runtimeArguments,
  uncheckedHeaders,
  uncheckedHeadersText,
} from "../browser/cpp/flags.js";
import { Tool } from "../browser/cpp/tool.js";
import { filesOfTar } from "./tar.js";

const [project, llvm, resources, out] = process.argv.slice(2) as [string, string, string, string];
const eigenSolvers = '#include "/runtime/eigen.hpp"\n';
const abi = "/usr/share/emscripten/system/lib/libcxxabi";

const tool = new Tool(new WebAssembly.Module(readFileSync(llvm)));
const files = new Files();
addSystem();
addFolder("/usr/include/eigen3/Eigen", `${packFolder}/eigen3/Eigen`);
addFolder("/usr/include/mujoco", `${packFolder}/mujoco`);
for (const name of ["mjcourse.hpp", "handlers.cpp"]) {
  const content = readFileSync(path.join(project, "examples/include/mjcourse", name));
  files.put(`${packFolder}/mjcourse/${name}`, content);
}
files.put(preparedSource, headerToPrepare());
files.put(uncheckedHeaders, uncheckedHeadersText);
compileRuntime();
writeFileSync(path.join(out, "cpp.pack"), packed(files.paths().filter(isPacked).sort()));
writeFileSync(path.join(out, "header.pch"), files.bytes(preparedHeader)!);

/** clang's own headers for other processors stay out, and a second C++ library for older standards. */
function addSystem(): void {
  const ofCompiler = /^include\/(__)?(std|float|limits|iso646|inttypes|tgmath|unwind|wasm)\w*\.h$/;
  const ofLibraries = /^include\/(c\+\+\/v1|wasm32-wasip1)\/(?!__cxx03\/)/;
  const libraries = /\/(crt1-command\.o|libc\+\+(abi)?\.a|libc\.a|libclang_rt\.builtins\.a)$/;
  const wanted = [ofCompiler, ofLibraries, /^lib\/wasm32-(unknown-)?wasip1\/[^/]+$/];
  for (const [name, content] of filesOfTar(readFileSync(resources))) {
    const isWanted = wanted.some((pattern) => pattern.test(name));
    if (isWanted && (!name.startsWith("lib/") || libraries.test(name))) {
      files.put(`/usr/${name}`, content);
    }
  }
}

function addFolder(from: string, to: string): void {
  for (const name of readdirSync(from)) {
    const source = path.join(from, name);
    if (statSync(source).isDirectory()) addFolder(source, `${to}/${name}`);
    else files.put(`${to}/${name}`, readFileSync(source));
  }
}

/** What programs of lessons include. A program that formats would compile std::format for ten seconds.
 * Of what they do with Eigen, there are the solvers (browser/cpp/runtime/eigen.hpp): all of it would make
 * the header twice as large, and each program slower. */
function headerToPrepare(): string {
  const standard = [
    ...["algorithm", "array", "chrono", "cmath", "complex", "cstdio", "cstdlib", "cstring"],
    ...["filesystem", "format", "fstream", "functional", "iomanip", "iostream", "iterator"],
    ...["limits", "map", "memory", "numbers", "numeric", "optional", "random", "ranges", "set"],
    ...["span", "sstream", "stdexcept", "string", "string_view", "thread", "type_traits"],
    ...["utility", "vector", "mjcourse/mjcourse.hpp", "mujoco/mjxmacro.h"],
  ];
  const format = `inline std::string mjcourse_formatted() { return std::format("{} {:.3f}", 1, 2.0); }\n`;
  return standard.map((name) => `#include <${name}>\n`).join("") + format + eigenSolvers;
}

function compileRuntime(): void {
  addFolder(path.join(project, "site/browser/cpp/runtime"), "/runtime");
  addFolder(abi, "/abi");
  for (const source of files.paths().filter((one) => /^\/runtime\/.*\.c(pp)?$/.test(one))) {
    compile(source);
  }
  const building = [
    ...["-I", "/abi/include", "-I", "/abi/src", "-w", "-DNDEBUG", "-D_LIBCPP_INLINE_VISIBILITY="],
    ...["-D_LIBCXXABI_BUILDING_LIBRARY", "-D_LIBCPP_BUILDING_LIBRARY"],
    ...["-D__USING_WASM_EXCEPTIONS__", "-D_LIBCXXABI_HAS_NO_THREADS"],
  ];
  compile("/abi/src/cxa_exception.cpp", building);
  compile("/abi/src/cxa_personality.cpp", building);
  compile(`${packFolder}/mjcourse/handlers.cpp`);
  run(prepareArguments);
  run(prepareObjectArguments);
}

/** To /runtime/NAME.o. */
function compile(source: string, more: readonly string[] = []): void {
  run(runtimeArguments(source, `/runtime/${path.parse(source).name}.o`, more));
}

function run(args: readonly string[]): void {
  const { ok, text } = tool.run(args, files);
  if (!ok) throw new Error(text);
}

/** The reader's browser makes the precompiled header sooner than it would have it from a network. */
function isPacked(name: string): boolean {
  if (name === preparedHeader || name.startsWith("/abi/")) return false;
  return name === preparedObject || !/^\/runtime\/.*\.c(pp)?$/.test(name);
}

/** As browser/cpp/pack.ts reads it. */
function packed(names: readonly string[]): Uint8Array {
  const contents = names.map((name) => files.bytes(name)!);
  const index = names.map((name, i) => [name, contents[i]!.length]);
  return Buffer.concat([Buffer.from(`${JSON.stringify(index)}\n`), ...contents]);
}
