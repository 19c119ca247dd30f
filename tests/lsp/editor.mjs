// An editor without a screen: starts `mjcourse lsp` on a copy of a course, and talks to it.

import { execFileSync, spawn } from "node:child_process";
import { cpSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

// What a session calls the course's folder.
const anyCourse = "file:///COURSE";
const patience = 60_000;

export class Editor {
  #child;
  #left = Buffer.alloc(0);
  #answers = new Map(); // by id
  #diagnostics = new Map(); // by URI, as they were told last
  #waiting = new Set();
  #ended;
  messages = []; // all that the server said, in order

  // `checked`: the course was, before the editor opened it, and what was found is known.
  constructor(mjcourse, course, checked = false) {
    this.folder = mkdtempSync(join(tmpdir(), "mjcourse-lsp-"));
    this.root = join(this.folder, "a course");
    cpSync(course, this.root, { recursive: true });
    const store = join(this.folder, "store");
    if (checked) execFileSync(mjcourse, ["check", "--course", this.root, "--store", store]);
    this.#child = spawn(mjcourse, ["lsp", "--store", store], { cwd: this.folder });
    this.#child.stdout.on("data", (bytes) => this.#take(bytes));
    this.#child.stderr.pipe(process.stderr);
    this.#ended = new Promise((ended) => this.#child.on("exit", (code) => ended(code)));
  }

  #take(bytes) {
    this.#left = Buffer.concat([this.#left, bytes]);
    for (;;) {
      const head = this.#left.indexOf("\r\n\r\n");
      if (head < 0) break;
      const length = Number(
        /Content-Length: (\d+)/.exec(this.#left.toString("latin1", 0, head))[1],
      );
      if (this.#left.length < head + 4 + length) break;
      const body = this.#left.toString("utf8", head + 4, head + 4 + length);
      this.#left = this.#left.subarray(head + 4 + length);
      this.#hear(JSON.parse(body.replaceAll(pathToFileURL(this.root).href, anyCourse)));
    }
    for (const look of this.#waiting) look();
  }

  #hear(message) {
    this.messages.push(message);
    if ("id" in message) this.#answers.set(message.id, message);
    if (message.method === "textDocument/publishDiagnostics") {
      this.#diagnostics.set(message.params.uri, message.params.diagnostics);
    }
  }

  // Resolves with what `find` gives once that is something.
  #find(find, what) {
    return new Promise((found, failed) => {
      const late = setTimeout(() => {
        this.#waiting.delete(look);
        failed(new Error(`nothing came of ${what}`));
      }, patience);
      const look = () => {
        const value = find();
        if (value === undefined) return;
        clearTimeout(late);
        this.#waiting.delete(look);
        found(value);
      };
      this.#waiting.add(look);
      look();
    });
  }

  // Bytes as they are.
  write(bytes) {
    this.#child.stdin.write(bytes);
  }

  send(message) {
    const text = JSON.stringify(message).replaceAll(anyCourse, pathToFileURL(this.root).href);
    this.write(`Content-Length: ${Buffer.byteLength(text)}\r\n\r\n${text}`);
  }

  answer(id) {
    return this.#find(() => this.#answers.get(id), `the question ${id}`);
  }

  ask(id, method, params) {
    this.send({ jsonrpc: "2.0", id, method, params });
    return this.answer(id);
  }

  // Waits until the file has diagnostics with just these codes.
  diagnostics(uri, codes) {
    return this.#find(() => {
      const all = this.#diagnostics.get(uri);
      const now = all?.map((one) => one.code);
      return JSON.stringify(now) === JSON.stringify(codes) ? all : undefined;
    }, `waiting for [${codes}] in ${uri}`);
  }

  // The server's exit code.
  async end() {
    this.#child.stdin.end();
    const code = await this.#ended;
    rmSync(this.folder, { recursive: true });
    return code;
  }
}
