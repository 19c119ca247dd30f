// The parts of a program's panel that need no page: numbers as the generator prints them, archives,
// links, sentences, what a run reported.
//
//   node --test tests/site/cpp/parts.mjs

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import path from "node:path";
import { test } from "node:test";

const site = path.resolve(import.meta.dirname, "../../../site");
const require = createRequire(path.join(site, "package.json"));
const names = [
  ...["completion", "marked-lines", "printf", "program-link", "records", "sentences", "unzip"],
  "zip",
];
const { outputFiles } = await require("esbuild").build({
  stdin: {
    contents: [
      ...names.map((name) => `export * from "./${name}.ts";`),
      'export { CompletionContext } from "@codemirror/autocomplete";',
      'export { EditorState } from "@codemirror/state";',
    ].join("\n"),
    resolveDir: path.join(site, "browser/program"),
  },
  bundle: true,
  format: "esm",
  write: false,
});
const parts = await import(
  `data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`
);

test("a number is printed as C prints it, and nothing has no sign", () => {
  // What glibc's printf gave.
  const printed = [
    [250, "", "250"],
    [0.76925, "", "0.76925"],
    [1234567.5, "", "1.23457e+06"],
    [1e-5, "", "1e-05"],
    [100000.5, "", "100000"],
    [999999.5, "g", "1e+06"],
    [0.0001, "g", "0.0001"],
    [1e22, "d", "10000000000000000000000"],
    [0.125, ".2f", "0.12"],
    [2.5, ".0e", "2e+00"],
    [3.5, ".0e", "4e+00"],
    [0.1, ".17g", "0.10000000000000001"],
    [-1e-12, ".3f", "0.000"],
    [-2.5e-7, ".3e", "-2.500e-07"],
    [-0, "e", "0.000000e+00"],
    [5e-324, ".3g", "4.94e-324"],
  ];
  for (const [value, format, text] of printed) {
    assert.equal(parts.inText(value, format), text, `${value} as ${format}`);
  }
});

test("lines are marked, and what stands between two is one part", () => {
  const shown = (text, numbers) =>
    parts.markedParts(text, numbers).map(({ text, isMarked }) => (isMarked ? `[${text}]` : text));
  assert.deepEqual(shown("a\nb\nc\nd\ne", [2, 5]), ["a\n", "[b\n]", "c\nd\n", "[e]"]);
  assert.deepEqual(shown("a\n\nb\n", [1, 2]), ["[a\n]", "[\n]", "b\n"]);
  assert.deepEqual(shown("a\nb", [3]), ["a\nb"]);
  assert.deepEqual(shown("", [1]), []);
});

test("of a million lines the first thousand are marked, and the others are one part", () => {
  const lines = 1_000_000;
  const numbers = Array.from({ length: lines }, (_, i) => i + 1);
  const all = parts.markedParts("x\n".repeat(lines), numbers);
  assert.deepEqual(
    [all.length, all.filter(({ isMarked }) => isMarked).length, all.at(-1).text.length],
    [1001, 1000, 2 * (lines - 1000)],
  );
});

test("what was zipped is unzipped, here and by others", async () => {
  const bytes = (text) => new TextEncoder().encode(text);
  const files = new Map([
    ["a/a.cpp", bytes("int main() {}\n".repeat(100))],
    ["a/models/ü.xml", bytes("<mujoco/>")],
    ["a/none", bytes("")],
  ]);
  const archive = await (await parts.zip(files)).arrayBuffer();
  const back = await parts.unzip(archive);
  assert.deepEqual([...back.keys()], [...files.keys()]);
  for (const [name, content] of files) assert.deepEqual(back.get(name), content, name);

  const folder = mkdtempSync(path.join(tmpdir(), "mjcourse-zip-"));
  try {
    const file = path.join(folder, "a.zip");
    writeFileSync(file, new Uint8Array(archive));
    execFileSync("unzip", ["-q", file], { cwd: folder, env: { LC_ALL: "C.UTF-8" } });
    assert.equal(readFileSync(path.join(folder, "a/models/ü.xml"), "utf8"), "<mujoco/>");
  } finally {
    rmSync(folder, { recursive: true });
  }
  await assert.rejects(parts.unzip(bytes("no archive").buffer), RangeError);
});

test("a link brings the text back, and what was made up brings nothing", async () => {
  const text = "int main() { return 'ä'; }\n";
  const value = await parts.encodeText(text);
  assert.match(value, /^1[\w-]+$/);
  assert.equal(await parts.decodeText(value), text);
  const noise = Array.from({ length: 9000 }, (_, i) => Math.sin(i).toString(36).slice(-6)).join("");
  assert.equal(await parts.encodeText(noise), undefined);
  for (const wrong of ["", "1", "2abc", value.slice(0, -3), `1${"A".repeat(9000)}`, "1*"]) {
    assert.equal(await parts.decodeText(wrong), undefined, wrong.slice(0, 10));
  }
});

test("results are read, and what no text quotes is passed over", () => {
  const lines = [
    '{"result": "depth", "value": 0.5}',
    '{"result": "word", "value": "deep"}',
    '{"result": "list", "value": [1, 2]}',
    '{"result": "infinite", "value": null}',
    '{"table": "fall", "value": [["t", [1]]]}',
    '{"result": "cut", "val',
    "null",
    "",
  ];
  assert.deepEqual(
    [...parts.readResults(lines.join("\n"))],
    [
      ["depth", 0.5],
      ["word", "deep"],
      ["infinite", "not finite"],
    ],
  );
});

test("a table says why nothing can be drawn of it", () => {
  const table = (...columns) =>
    parts.readTables(JSON.stringify({ table: "t", value: columns })).get("t");
  assert.deepEqual(table(["a", [1, 2]]), [["a", [1, 2]]]);
  assert.equal(table(["a", [1]], ["b", []]), "its columns differ in length");
  assert.equal(table(["a", []]), "it has no row");
  assert.equal(table(["a", [1, null]]), "“a” is not finite in row 2");
});

test("each end has its sentence", () => {
  const said = (end, expected = 0) => parts.sentenceOf(end, expected);
  assert.equal(said({ how: "exit", code: 0 }), "It ran to the end.");
  assert.equal(said({ how: "exit", code: 3 }), "It ended with exit code 3.");
  assert.equal(said({ how: "exit", code: 3 }, 3), "It ended with exit code 3, as in the lesson.");
  assert.equal(said({ how: "exit", code: 0 }, 3), "It ended with exit code 0.");
  assert.equal(said({ how: "error", message: "stack in use" }), "MuJoCo ended it: stack in use.");
  assert.equal(
    said({ how: "trap", message: "division by zero", line: 7 }),
    "It crashed (line 7): division by zero.",
  );
});

test("lines that are not the lesson's are counted, and else those of the lesson that are missing", () => {
  const said = (gone, ...come) => parts.comparisonSentence({ gone, come });
  assert.equal(said(0), "It printed what the lesson’s printed.");
  assert.equal(said(1, 4), "1 line of its output is not the lesson’s.");
  assert.equal(said(2, 4, 5), "2 lines of its output are not the lesson’s.");
  assert.equal(
    said(4, 4, 5),
    "2 lines of its output are not the lesson’s. 2 lines of the lesson’s output are missing.",
  );
  assert.equal(said(1), "1 line of the lesson’s output is missing.");
  assert.equal(said(2), "2 lines of the lesson’s output are missing.");
});

const apiNames = [
  ["mjData", "type", "", ""],
  ["mjData.qpos", "property", "mjtNum* qpos;", "position"],
  ["mjModel", "type", "", ""],
  ["mjModel.nq", "property", "int nq", "number of generalized coordinates"],
  ["mjModel.opt", "property", "mjOption opt", "physics options"],
  ["mjOption.timestep", "property", "mjtNum timestep", "timestep"],
  ["mj_step", "function", "void mj_step(const mjModel* m, mjData* d)", "Advance simulation."],
];
const helper = `// Ends well.
// Always.
inline int ends(const mjModel* model,
                double seconds) {
`;

// What is offered where the text has a bar.
async function offered(text) {
  const pos = text.indexOf("|");
  const state = parts.EditorState.create({ doc: text.replace("|", "") });
  const load = () => Promise.resolve(apiNames);
  const found = await parts.completionOf(
    load,
    helper,
  )(new parts.CompletionContext(state, pos, false));
  return found === null ? null : found.options.map(({ label }) => label).join();
}

test("fields are offered of what the variable is, others by what they begin with", async () => {
  const words = "ends,mjData,mjModel,mj_step";
  assert.equal(await offered("int main() { mj_|"), words);
  assert.equal(await offered("int main() { mj|"), null, "two letters say too little");
  assert.equal(await offered("mjModel* m = f(); m->|"), "nq,opt");
  assert.equal(await offered("const Model model = load(); model->opt.|"), "timestep");
  assert.equal(await offered("const Data data = make(); data->q|"), "qpos");
  assert.equal(await offered("unknown->|"), null);
});

test("a function of the course's header is offered with its parameters and its comment", async () => {
  const state = parts.EditorState.create({ doc: "ends" });
  const source = parts.completionOf(() => Promise.resolve([]), helper);
  const { options } = await source(new parts.CompletionContext(state, 4, false));
  const expected = {
    label: "ends",
    type: "function",
    detail: "(const mjModel* model, double seconds)",
    info: "Ends well. Always.",
  };
  assert.deepEqual(options, [expected]);
});
