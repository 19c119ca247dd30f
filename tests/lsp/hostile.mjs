// What no editor should send does not end `mjcourse lsp`, nor keep it from its next answer.
//
//   node tests/lsp/hostile.mjs MJCOURSE

import assert from "node:assert/strict";
import { cpSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { Editor } from "./editor.mjs";

const mjcourse = process.argv[2];
const course = join(import.meta.dirname, "course");
const lesson = "file:///COURSE/content/1-first/1.1-everything.md";
const framed = (text) => `Content-Length: ${Buffer.byteLength(text)}\r\n\r\n${text}`;

async function badMessages() {
  const editor = new Editor(mjcourse, course);
  const early = await editor.ask(1, "textDocument/hover", {});
  assert.equal(early.error.code, -32002);
  for (const text of [
    "{",
    "[]",
    "[1]",
    "1",
    "null",
    '"x"',
    '{"id":',
    '{"a":"\\ud800"}',
    "\u0000",
  ]) {
    editor.write(framed(text));
  }
  editor.write("Content-Type: nothing\r\n\r\n");
  editor.write(framed('{"jsonrpc":"2.0","id":"two","method":"initialize","params":{"rootUri":7}}'));
  const begun = await editor.answer("two");
  assert.equal(begun.result.capabilities.positionEncoding, "utf-16");
  const again = await editor.ask(3, "initialize", {});
  assert.equal(again.error.code, -32600);
  const unknown = await editor.ask(4, "textDocument/juggle", {});
  assert.deepEqual(unknown.error, {
    code: -32601,
    message: "there is no method textDocument/juggle",
  });
  const wrong = await editor.ask(5, "textDocument/hover", { textDocument: [] });
  assert.equal(wrong.error.code, -32602);
  editor.send({ method: "textDocument/didChange", params: { textDocument: { uri: 5 } } });
  editor.send({ method: "$/unknown" });
  editor.send({ id: 6, result: null });
  const refused = editor.messages.filter(({ error }) => [-32700, -32600].includes(error?.code));
  assert.equal(refused.length, 10);
  const over = await editor.ask(7, "shutdown");
  assert.equal(over.result, null);
  const late = await editor.ask(8, "textDocument/hover", {});
  assert.equal(late.error.code, -32600);
  editor.send({ method: "exit" });
  assert.equal(await editor.end(), 0);
}

async function badPlaces() {
  const editor = new Editor(mjcourse, course);
  const capabilities = { general: { positionEncodings: ["utf-8", "utf-16"] } };
  const begun = await editor.ask(1, "initialize", { rootUri: "file:///COURSE", capabilities });
  assert.equal(begun.result.capabilities.positionEncoding, "utf-8");
  const nowhere = { position: { line: 0, character: 0 } };
  for (const uri of [
    "file:///etc/passwd",
    "untitled:1",
    "file:///COURSE/../x.md",
    "",
    "file:///%",
  ]) {
    editor.send({ method: "textDocument/didOpen", params: { textDocument: { uri, text: "x" } } });
    const { result } = await editor.ask(uri, "textDocument/hover", {
      textDocument: { uri },
      ...nowhere,
    });
    assert.equal(result, null, uri);
  }
  for (const position of [
    { line: 1e9, character: 1e9 },
    { line: -5, character: -1 },
    { line: 6, character: 1e15 },
  ]) {
    for (const kind of ["hover", "definition", "completion"]) {
      const id = `${kind} ${JSON.stringify(position)}`;
      const answer = await editor.ask(id, `textDocument/${kind}`, {
        textDocument: { uri: lesson },
        position,
      });
      assert.equal(answer.error, undefined, id);
    }
  }
  // Actions of another kind alone, and of no kind that could be one.
  const start = nowhere.position;
  for (const [only, actions] of [
    [["source"], null],
    [7, []],
  ]) {
    const { result } = await editor.ask(`only ${only}`, "textDocument/codeAction", {
      textDocument: { uri: lesson },
      range: { start, end: start },
      context: { only },
    });
    assert.deepEqual(result, actions);
  }
  // Whatever is typed, at each of its steps.
  const text =
    '```lab simlab\n{"model": "sw", "controls": [{"type": "sl\n`{swing} model.\n[[a [b](1.2#\n';
  editor.send({ method: "textDocument/didOpen", params: { textDocument: { uri: lesson, text } } });
  for (const [line, typed] of text.split("\n").entries()) {
    for (let character = 0; character <= typed.length; ++character) {
      for (const kind of ["hover", "definition", "completion"]) {
        const answer = await editor.ask(`${kind} ${line}:${character}`, `textDocument/${kind}`, {
          textDocument: { uri: lesson },
          position: { line, character },
        });
        assert.equal(answer.error, undefined, `${kind} ${line}:${character}`);
      }
    }
  }
  // It went away without a word.
  assert.equal(await editor.end(), 1);
}

// A hover is Markdown. What a course says in it loads no picture, leads nowhere and forges no verdict.
async function badWords() {
  const picture = "![x](https://evil.example/v.png)";
  const because = `[run](command:x) <img src=x> **Proved** \\u001b${picture}`;
  const value = '`{swing} (() => "' + picture + '")()`';
  const question = `{"kind": "numeric", "q": "What?", "answer": 1, "verify": [{"because": "${because}"}]}`;
  const text = `---\ntitle: Words\n---\n\n## A part\n\nIt is ${value}.\n\n\`\`\`quiz\n{"id": "w", "questions": [\n${question}\n]}\n\`\`\`\n`;
  const folder = mkdtempSync(join(tmpdir(), "mjcourse-words-"));
  cpSync(course, folder, { recursive: true });
  writeFileSync(join(folder, "content/1-first/1.1-everything.md"), text);
  const editor = new Editor(mjcourse, folder, true);
  rmSync(folder, { recursive: true });
  await editor.ask(1, "initialize", { rootUri: "file:///COURSE", capabilities: {} });
  editor.send({ method: "textDocument/didOpen", params: { textDocument: { uri: lesson, text } } });
  await editor.diagnostics(lesson, []);
  const hover = async (line) => {
    const { result } = await editor.ask(`words ${line}`, "textDocument/hover", {
      textDocument: { uri: lesson },
      position: { line, character: 20 },
    });
    return result.contents;
  };
  assert.deepEqual(await hover(6), {
    kind: "markdown",
    value: `**\`${picture}\`**: \`(() => "${picture}")() of swing.xml\``,
  });
  assert.deepEqual(await hover(10), {
    kind: "markdown",
    value: String.raw`Asserted: \[run\]\(command\:x\) &lt;img src\=x\> \*\*Proved\*\* \\x1b\!\[x\]\(https\:\/\/evil\.example\/v\.png\)`,
  });
  await editor.end();
}

await badMessages();
await badPlaces();
await badWords();
