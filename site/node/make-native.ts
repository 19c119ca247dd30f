/**
 * Makes what Debian's clang needs to stand in for the page's compiler (native-clang.ts):
 *
 *   node make-native.mjs CPP OUT
 *
 * CPP is the folder with llvm.wasm, cpp.pack and header.pch. OUT gets the pack's headers as files, the
 * precompiled header as this clang makes it, and a probe with its object. It stays empty where clang is missing, or
 * makes another object of the probe than the page's compiler.
 */
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";

import { Files } from "../browser/cpp/files.js";
import { prepareArguments, preparedHeader } from "../browser/cpp/flags.js";
import { unpack } from "../browser/cpp/pack.js";
import { Tool } from "../browser/cpp/tool.js";
import {
  isSameObject,
  NativeClang,
  probeArguments,
  probePath,
  probeSource,
} from "./native-clang.js";

const [cpp, out] = process.argv.slice(2) as [string, string];

/** With something of each kind that programs have. */
const probe = `#include "mjcourse/mjcourse.hpp"
#include <Eigen/Dense>
#include <cstdio>
#include <map>
#include <memory>
#include <thread>
struct Shape { virtual ~Shape() = default; virtual double area() const = 0; };
template <typename T> struct Square final : Shape {
  explicit Square(T side) : side(side) {}
  double area() const override { return static_cast<double>(side * side); }
  T side;
};
int main(int count, char** words) try {
  std::map<std::string, Eigen::Vector3d> places{{words[count - 1], {1, 2, 3}}};
  for (auto& [name, place] : places) std::printf("%s %g\\n", name.c_str(), place.norm());
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(4, 4);
  const Eigen::VectorXd x = a.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(4));
  const std::unique_ptr<Shape> shape = std::make_unique<Square<float>>(2.5f);
  std::thread([&] { std::printf("%g %s\\n", x.sum(), std::format("{:.3f}", shape->area()).c_str()); }).join();
  static const auto model = mjcourse::load_model_xml("<mujoco/>");
  const auto data = mjcourse::make_data(model);
  for (int i = 0; i < 3; ++i) mj_step(model, data);
  mjcourse::result("time", data->time);
  if (mju_round(data->time) > 7) throw std::runtime_error("late");
} catch (const std::exception& error) {
  std::puts(error.what());
}
`;

const root = path.join(out, "root");
const pack = new Files(unpack(readFileSync(path.join(cpp, "cpp.pack"))));
const clang = new NativeClang(root, path.join(out, "work"));
try {
  writeHeaders();
  const header = clang.make(prepareArguments, new Map(), 1 << 19);
  if (!header) throw new Error("the headers do not compile");
  writeFileSync(path.join(root, preparedHeader), header);
  writeProbe();
} catch (error) {
  for (const name of readdirSync(out)) rmSync(path.join(out, name), { recursive: true });
  console.log(`without a native compiler for the page's programs: ${(error as Error).message}`);
}

function writeHeaders(): void {
  const isHeader = (name: string) => !/^\/usr\/lib\/|\.o$/.test(name);
  for (const name of pack.paths().filter(isHeader)) {
    mkdirSync(path.dirname(path.join(root, name)), { recursive: true });
    writeFileSync(path.join(root, name), pack.bytes(name)!);
  }
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
