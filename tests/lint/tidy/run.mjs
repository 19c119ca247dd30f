// clang-tidy over the generator, by the repository's .clang-tidy.
//
//   node tests/lint/tidy/run.mjs BUILD PLUGIN
//
//   BUILD    the folder with compile_commands.json
//   PLUGIN   own_code.cpp, compiled
//
// A file takes seconds, so one in which nothing was found is not looked at again before it, a
// header of ours that it includes, its flags or .clang-tidy change.

import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { join, relative, resolve } from "node:path";

import { Stamps } from "../../stamps.mjs";
import { complaintsOf, lookAt } from "../look.mjs";

const tidy = "clang-tidy-16";
const root = resolve(import.meta.dirname, "../../..");
const generator = join(root, "generator");
const [build, plugin] = process.argv.slice(2).map((path) => resolve(path));
// The flags are g++'s, and may name warnings that clang does not know.
const flags = ["--quiet", "--extra-arg=-Wno-unknown-warning-option"];

// Adds to `closure` the file and all headers of ours that it includes, and those that they do.
function addIncludes(file, closure) {
  if (closure.has(file)) return closure;
  const text = readFileSync(file, "utf8");
  closure.set(file, text);
  for (const [, name] of text.matchAll(/^ *# *include *"([^"]+)"/gm)) {
    const header = join(generator, name);
    if (existsSync(header)) addIncludes(header, closure);
  }
  return closure;
}

const tool =
  execFileSync(tidy, ["--version"], { encoding: "utf8" }) +
  flags.join(" ") +
  readFileSync(join(import.meta.dirname, "own_code.cpp"), "utf8") +
  readFileSync(join(root, ".clang-tidy"), "utf8");

function stampOf({ file, command }) {
  const texts = [...addIncludes(file, new Map())].sort().map(([, text]) => text);
  return Stamps.of(tool, command.replaceAll(root, "."), ...texts);
}

const commands = JSON.parse(readFileSync(join(build, "compile_commands.json"), "utf8"));
const tasks = commands
  .filter(({ file }) => file.startsWith(generator))
  .map((command) => ({
    name: relative(root, command.file),
    stamp: stampOf(command),
    look: () => complaintsOf(tidy, ["-load", plugin, "-p", build, ...flags, command.file]),
  }));
await lookAt(new Stamps("tidy"), tasks);
