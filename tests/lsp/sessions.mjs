// What `mjcourse lsp` answers to sessions of a real editor: NAME.jsonl has the messages that Neovim
// sent, one a line, as they were recorded; the course's folder is file:///COURSE in them. Between them
// stand lines {"until": {"uri", "codes"}}: the session goes on once the file has just these
// diagnostics. NAME.expected.json has what must be answered.
//
//   node tests/lsp/sessions.mjs MJCOURSE
//   UPDATE_EXPECTED=1 node tests/lsp/sessions.mjs MJCOURSE

import { globSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { Editor } from "./editor.mjs";

const mjcourse = process.argv[2];
const here = import.meta.dirname;
const update = process.env.UPDATE_EXPECTED === "1";

// Another version of ours says the same.
function withoutVersion(answer) {
  if (answer.result?.serverInfo) delete answer.result.serverInfo.version;
  return answer;
}

// Of what is offered, a line for each.
function brief(answer) {
  const { items } = answer.result ?? {};
  if (!items?.length) return answer;
  const { range } = items[0].textEdit;
  const lines = items.map(({ label, textEdit, detail, documentation }) =>
    [label, textEdit.newText, detail, documentation?.value].filter(Boolean).join(" | "),
  );
  return { result: { range, lines } };
}

async function replay(session) {
  const editor = new Editor(mjcourse, join(here, "course"), true);
  const heard = [];
  for (const line of readFileSync(session, "utf8").trim().split("\n")) {
    const message = JSON.parse(line);
    if (message.until) {
      const { uri, codes } = message.until;
      heard.push({ diagnostics: await editor.diagnostics(uri, codes) });
      continue;
    }
    editor.send(message);
    if ("id" in message) {
      const answer = brief(withoutVersion(await editor.answer(message.id)));
      heard.push({ [message.method]: answer.result ?? answer.error ?? null });
    }
  }
  return { heard, code: await editor.end() };
}

let failed = false;
for (const session of globSync(join(here, "*.jsonl")).sort()) {
  const file = session.replace(".jsonl", ".expected.json");
  const { heard, code } = await replay(session);
  const text = `${JSON.stringify({ heard, code }, null, 1)}\n`;
  if (update) {
    writeFileSync(file, text);
    continue;
  }
  const expected = readFileSync(file, "utf8");
  if (text === expected) continue;
  failed = true;
  const now = text.split("\n");
  const line = expected.split("\n").findIndex((one, i) => one !== now[i]);
  console.error(
    `${file}:${line + 1}: expected ${expected.split("\n")[line]}, and not ${now[line]}`,
  );
}
process.exitCode = failed ? 1 : 0;
