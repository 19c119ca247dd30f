// clang-tidy over the generator, by the repository's .clang-tidy.
//
//   node tests/lint/tidy/run.mjs BUILD PLUGIN
//
//   BUILD    the folder with compile_commands.json
//   PLUGIN   own_code.cpp, compiled
//
// A file takes seconds, so one in which nothing was found is not looked at again before it, a
// header of ours that it includes, its flags or .clang-tidy change.

import { execFile, execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import { join, relative, resolve } from "node:path";

import { Stamps } from "../../stamps.mjs";

const tidy = "clang-tidy-16";
const root = resolve(import.meta.dirname, "../../..");
const generator = join(root, "generator");
const [build, plugin] = process.argv.slice(2).map((path) => resolve(path));
const stamps = new Stamps("tidy");
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

// What clang-tidy says about one file; "" for nothing.
function findings(file) {
  return new Promise((resolved) => {
    execFile(tidy, ["-load", plugin, "-p", build, ...flags, file], (error, stdout, stderr) => {
      resolved(error ? stdout + stderr : "");
    });
  });
}

const commands = JSON.parse(readFileSync(join(build, "compile_commands.json"), "utf8"));
const tasks = commands
  .filter(({ file }) => file.startsWith(generator))
  .map((command) => ({ file: command.file, stamp: stampOf(command) }));
const waiting = tasks.filter(({ stamp }) => !stamps.has(stamp));
const looked = waiting.length;

let failed = 0;
async function work() {
  for (let task = waiting.shift(); task; task = waiting.shift()) {
    const found = await findings(task.file);
    if (found === "") stamps.put(task.stamp, relative(root, task.file));
    else ++failed;
    process.stdout.write(found);
  }
}
await Promise.all(Array.from({ length: availableParallelism() }, work));

console.log(`${tasks.length} files, ${looked} looked at, findings in ${failed}`);
process.exitCode = failed > 0 || tasks.length === 0 ? 1 : 0;
