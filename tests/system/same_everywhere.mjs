// `check`, the preview and the editor say the same of the same course: every mistake, with its file,
// line, column and id. Looked at are the first tiny course of each folder, and all of those whose
// mistakes lie beside lessons; or those whose names hold one of the words that are given.
//
//   node tests/system/same_everywhere.mjs MJCOURSE [WORD ...]

import { execFile, spawn } from "node:child_process";
import { existsSync, globSync, mkdtempSync, rmSync } from "node:fs";
import { availableParallelism, tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const mjcourse = resolve(process.argv[2]);
const wanted = process.argv.slice(3);
const courses = join(import.meta.dirname, "../courses");
const patience = 180_000; // ms, on a busy machine

// Not those that mean harm, which tests/system/hostile.mjs keeps watch over, nor those that are checked with
// further arguments.
const cases = globSync("*/*/content/course.yaml", { cwd: courses })
  .map((file) => file.replace("/content/course.yaml", ""))
  .filter((name) => !name.startsWith("hostile/"))
  .filter((name) => !existsSync(join(courses, name, "arguments")))
  .sort()
  .filter((name, i, all) => {
    if (wanted.length > 0) return wanted.some((word) => name.includes(word));
    const [folder] = name.split("/");
    return folder === "course" || !all[i - 1]?.startsWith(`${folder}/`);
  });

const said = ({ place, id }) => `${place.file}:${place.line}:${place.column} ${id}`;
const sorted = (lines) => lines.sort().join("\n");

async function untilTrue(look, what) {
  const end = Date.now() + patience;
  for (let last; ;) {
    const found = await look();
    if (found.good) return found;
    last = found;
    if (Date.now() > end) throw new Error(`${what}:\n${last.said}`);
    await new Promise((waited) => setTimeout(waited, 50));
  }
}

// Until it has ended, and writes nothing more into the store.
function ended(child) {
  if (child.exitCode !== null || child.signalCode !== null) return undefined;
  return new Promise((done) => child.on("exit", done));
}

function checked(course, store) {
  return new Promise((found) => {
    const check = ["check", "--format", "json", "--course", course, "--store", store];
    execFile(mjcourse, check, { maxBuffer: 1 << 26 }, (_, stdout) => {
      const { diagnostics } = JSON.parse(stdout);
      found(diagnostics.map(said));
    });
  });
}

async function previewed(course, store) {
  const child = spawn(mjcourse, ["preview", "--course", course, "--store", store]);
  try {
    let printed = "";
    const root = await new Promise((found, failed) => {
      child.stdout.on("data", (text) => {
        const address = /preview: (\S+)/.exec((printed += text));
        if (address) found(address[1]);
      });
      child.on("exit", (code) => failed(new Error(`preview ended with ${code}: ${printed}`)));
    });
    child.removeAllListeners("exit");
    const { state } = await untilTrue(async () => {
      const answer = await fetch(`${root}.preview/state?page=index.html&known=`);
      const now = await answer.json();
      return { good: !now.running && now.version > 0, state: now, said: "it does not settle" };
    }, "the preview");
    return state.diagnostics.map(said);
  } finally {
    child.kill("SIGINT");
    await ended(child);
  }
}

// The editor is told once it is known, and again as more is known: it is waited for `expected`.
async function edited(course, store, expected) {
  const child = spawn(mjcourse, ["lsp", "--store", store], { cwd: course });
  const told = new Map();
  let left = Buffer.alloc(0);
  child.stdout.on("data", (bytes) => {
    left = Buffer.concat([left, bytes]);
    for (;;) {
      const head = left.indexOf("\r\n\r\n");
      const length = Number(/Content-Length: (\d+)/.exec(left.toString("latin1", 0, head))?.[1]);
      if (head < 0 || left.length < head + 4 + length) return;
      const message = JSON.parse(left.toString("utf8", head + 4, head + 4 + length));
      left = left.subarray(head + 4 + length);
      if (message.method !== "textDocument/publishDiagnostics") continue;
      const file = fileURLToPath(message.params.uri).slice(course.length + 1);
      told.set(
        file,
        message.params.diagnostics.map(({ code }) => `${file} ${code}`),
      );
    }
  });
  const send = (message) => {
    const text = JSON.stringify({ jsonrpc: "2.0", ...message });
    child.stdin.write(`Content-Length: ${Buffer.byteLength(text)}\r\n\r\n${text}`);
  };
  try {
    const rootUri = pathToFileURL(course).href;
    send({ id: 1, method: "initialize", params: { processId: null, rootUri, capabilities: {} } });
    send({ method: "initialized", params: {} });
    await untilTrue(() => {
      const all = sorted([...told.values()].flat());
      return { good: all === expected, said: all };
    }, "the editor says");
  } finally {
    child.stdin.end();
    await ended(child);
  }
}

const problems = [];
async function hold(name, store) {
  const course = join(courses, name);
  const expected = await checked(course, store);
  const shown = sorted(await previewed(course, store));
  if (shown !== sorted(expected)) problems.push(`${name}: the preview says\n${shown}`);
  // Where a line begins an editor counts otherwise (LSP): its tests are tests/lsp.
  const files = expected.map((one) => one.replace(/:\d+:\d+ /, " "));
  try {
    await edited(course, store, sorted(files));
  } catch (error) {
    problems.push(`${name}: ${error.message}`);
  }
}

const store = mkdtempSync(join(tmpdir(), "mjcourse-store-"));
const queue = [...cases];
const work = async () => {
  for (let name; (name = queue.shift()) !== undefined;) await hold(name, store);
};
await Promise.all(Array.from({ length: availableParallelism() }, work));
rmSync(store, { recursive: true });
for (const problem of problems) console.error(problem);
console.log(`${cases.length} courses, ${problems.length} of which three do not say the same`);
process.exitCode = problems.length > 0 || cases.length === 0 ? 1 : 0;
