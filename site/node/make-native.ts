/**
 * Makes what Debian's clang needs to stand in for the page's compiler (native-clang.ts):
 *
 *   node make-native.mjs PROJECT CPP OUT
 *
 * CPP is the folder with llvm.wasm, cpp.pack and header.pch. OUT gets the pack's headers as files, the precompiled header
 * as this clang makes it, and a probe with its object. It stays empty where clang is missing, or makes
 * another object than the page's compiler of any source of the runtime, or of the probe.
 */
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";

import { Files } from "../browser/cpp/files.js";
import { prepareArguments, preparedHeader, runtimeArguments } from "../browser/cpp/flags.js";
import { unpack } from "../browser/cpp/pack.js";
import { Tool } from "../browser/cpp/tool.js";
import {
  isSameObject,
  NativeClang,
  probeArguments,
  probePath,
  probeSource,
} from "./native-clang.js";

const [project, cpp, out] = process.argv.slice(2) as [string, string, string];

/** Of each kind of thing that programs have. */
const probe = `#include "mjcourse/mjcourse.hpp"
#include <Eigen/Dense>
#include <cstdio>
#include <map>
int main(int count, char** words) try {
  std::map<std::string, Eigen::Vector3d> places{{words[count - 1], {1, 2, 3}}};
  for (auto& [name, place] : places) std::printf("%s %g\\n", name.c_str(), place.norm());
  static const auto model = mjcourse::load_model_xml("<mujoco/>");
  mjcourse::result("nv", model->nv);
} catch (const std::exception& error) {
  std::puts(error.what());
}
`;

const root = path.join(out, "root");
const pack = new Files(unpack(readFileSync(path.join(cpp, "cpp.pack"))));
const clang = new NativeClang(root, path.join(out, "work"));
try {
  writeHeaders();
  const header = clang.make(prepareArguments, new Map());
  if (!header) throw new Error("the headers do not compile");
  writeFileSync(path.join(root, preparedHeader), header);
  compareRuntime();
  writeProbe();
} catch (error) {
  for (const name of readdirSync(out)) rmSync(path.join(out, name), { recursive: true });
  console.log(`without a native compiler for the page's programs: ${(error as Error).message}`);
}

function writeHeaders(): void {
  const isHeader = (name: string) => !/^\/(usr\/lib|runtime)\/|\.o$/.test(name);
  for (const name of pack.paths().filter(isHeader)) {
    mkdirSync(path.dirname(path.join(root, name)), { recursive: true });
    writeFileSync(path.join(root, name), pack.bytes(name)!);
  }
}

function compareRuntime(): void {
  const folder = path.join(project, "site/browser/cpp/runtime");
  for (const name of readdirSync(folder)) {
    const source = `/source/${name}`;
    const object = `/runtime/${path.parse(name).name}.o`;
    compare(
      runtimeArguments(source, object),
      object,
      new Map([[source, readFileSync(path.join(folder, name))]]),
    );
  }
}

/** With what the pack has. */
function compare(
  args: readonly string[],
  object: string,
  sources: ReadonlyMap<string, Uint8Array> = new Map(),
): void {
  const made = clang.make(args, sources);
  if (!made || !isSameObject(made, pack.bytes(object)!)) throw new Error(`${object} differs`);
}

function writeProbe(): void {
  const text = new TextEncoder().encode(probe);
  const files = new Files(pack);
  files.put(probePath, text);
  files.put(preparedHeader, readFileSync(path.join(cpp, "header.pch")));
  files.addFolder("/object");
  const tool = new Tool(new WebAssembly.Module(readFileSync(path.join(cpp, "llvm.wasm"))));
  const { ok, text: said } = tool.run(probeArguments, files);
  if (!ok) throw new Error(`the probe does not compile: ${said}`);
  const own = files.bytes("/object/probe.o")!;
  const made = clang.make(probeArguments, probeSource(text));
  if (!made || !isSameObject(made, own)) throw new Error("the probe differs");
  writeFileSync(path.join(out, "probe.cpp"), text);
  writeFileSync(path.join(out, "probe.o"), own);
}
