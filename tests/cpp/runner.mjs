// Programs as the page runs them: the assets' cpp/run.mjs in Node. MJCOURSE_CPP is its folder,
// MJCOURSE_ENGINE that of MuJoCo for the browser.

import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";

const course = path.resolve(import.meta.dirname, "../..");
export const { MJCOURSE_CPP: cpp, MJCOURSE_ENGINE: engine } = process.env;
const run = path.join(cpp, "run.mjs");

// Where something is missing there is no compiler; tests/CMakeLists.txt knows these words.
if (!existsSync(run)) {
  console.log("the page's compiler was not built");
  process.exit();
}

// The helper header and its like, as a program's zip has them.
export const helpers = filesIn(path.join(course, "examples/include"), "include");

export class Runner {
  #child;
  #said = Buffer.alloc(0);
  #answer;
  #work; // the process is started in a folder of its own

  // `folder` has what is in MJCOURSE_CPP.
  constructor(folder = cpp, options = []) {
    this.#work = mkdtempSync(path.join(tmpdir(), "mjcourse-test-"));
    this.#child = spawn(process.execPath, [run, folder, engine, ...options], {
      stdio: ["pipe", "pipe", "inherit"],
      cwd: this.#work,
    });
    this.#child.stdout.on("data", (bytes) => {
      this.#said = Buffer.concat([this.#said, bytes]);
      const size = this.#said.length < 8 ? Infinity : Number(this.#said.readBigUInt64LE());
      if (this.#said.length < 8 + size) return;
      const answer = this.#said.toString("utf8", 8, 8 + size);
      this.#said = this.#said.subarray(8 + size);
      this.#answer(JSON.parse(answer));
    });
    this.#child.on("exit", (code) => {
      rmSync(this.#work, { recursive: true });
      this.#answer?.({ exited: code });
    });
  }

  // `files` by their names; text is a string, else bytes.
  ask(main, files, more = {}) {
    const content = (file) =>
      typeof file === "string" ? { text: file } : { base64: file.toString("base64") };
    const named = Object.entries(files).map(([name, file]) => [name, content(file)]);
    const question = { main, files: Object.fromEntries(named), models: "models", ...more };
    const bytes = Buffer.from(JSON.stringify(question));
    const size = Buffer.alloc(8);
    size.writeBigUInt64LE(BigInt(bytes.length));
    this.#child.stdin.write(Buffer.concat([size, bytes]));
    return new Promise((resolve) => (this.#answer = resolve));
  }

  close() {
    this.#child.stdin.end();
  }
}

function filesIn(folder, name) {
  const entries = readdirSync(folder, { recursive: true, withFileTypes: true });
  const files = entries.filter((entry) => entry.isFile());
  return Object.fromEntries(
    files.map((entry) => {
      const file = path.join(entry.parentPath, entry.name);
      return [path.join(name, path.relative(folder, file)), readFileSync(file, "utf8")];
    }),
  );
}
