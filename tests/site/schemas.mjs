// The schemas that a site brings along say what the generator says of the JSON in fences: they allow
// what it takes, in the real course and in all that the tests have; and what it refuses of a key, of
// its kind or its range, they refuse, as far as one value shows it.
//
//   node tests/site/schemas.mjs SITE

import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join, relative } from "node:path";
import { test } from "node:test";

const root = join(import.meta.dirname, "../..");
const site = process.argv[2];
const require = createRequire(join(root, "site/package.json"));
const Ajv = require("ajv");

const names = ["lab", "quiz", "figure", "plot"];
const ajv = new Ajv({ allErrors: true });
const schemas = new Map(
  names.map((name) => {
    const text = readFileSync(join(site, "schemas", `${name}.schema.json`), "utf8");
    return [name, ajv.compile(JSON.parse(text))];
  }),
);

// What the generator refuses of a single value. Of others, it holds several together.
const ofOneValue = new Set([
  "E-json-key",
  "E-json-kind",
  "E-json-missing",
  "E-json-range",
  "E-lab-control",
  "E-lab-plot",
  "E-plot-word",
]);

// Refused for what a schema cannot say: message → why.
const beyondSchemas = [
  [/is empty$/, "a key that may be left out must not be empty"],
  [/"ymax" is the upper end/, "ymin and ymax together"],
  [/"value" is the index of an option/, "value and options together"],
  [/^this solution has no "before"/, "insert and before together"],
];

/** The fences of a Markdown text: kind, the lines it is in, its JSON where it is any. */
function fencesOf(markdown) {
  const lines = markdown.split("\n");
  const fences = [];
  for (let first = 0; first < lines.length; ++first) {
    const opened = /^([ >]*)(`{3,})(lab simlab|quiz|figure|plot)\b/.exec(lines[first]);
    if (!opened) continue;
    const [, prefix, marks, kind] = opened;
    const inside = (line) =>
      line.startsWith(prefix) ? line.slice(prefix.length) : line.trimStart();
    let last = first + 1;
    while (last < lines.length && !inside(lines[last]).startsWith(marks)) ++last;
    const body = lines
      .slice(first + 1, last)
      .map(inside)
      .join("\n");
    fences.push({ kind: kind.split(" ")[0], first: first + 1, last: last + 1, body });
    first = last;
  }
  return fences;
}

function parsed(body) {
  try {
    return JSON.parse(body);
  } catch {
    return undefined;
  }
}

function coursesBelow(folder) {
  return readdirSync(folder, { recursive: true })
    .filter((name) => name.endsWith("course.yaml"))
    .map((name) => join(folder, name, "../.."));
}

/** Each mistake that mjcourse is expected to tell: of which file and line, id, message. */
function mistakesOf(course) {
  const expected = join(course, "expected.txt");
  const text = existsSync(expected) ? readFileSync(expected, "utf8") : "";
  const form = /^(\S+):(\d+):\d+: error: (.*) \[(E-[a-z0-9-]+)\]$/gm;
  return [...text.matchAll(form)].map(([, file, line, message, id]) => ({
    file,
    line: Number(line),
    message,
    id,
  }));
}

let allowed = 0;
let refused = 0;

function look(course) {
  const mistakes = mistakesOf(course);
  const lessons = readdirSync(join(course, "content"), { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && entry.name.endsWith(".md"))
    .map((entry) => relative(course, join(entry.parentPath, entry.name)));
  for (const lesson of lessons) {
    for (const fence of fencesOf(readFileSync(join(course, lesson), "utf8"))) {
      const value = parsed(fence.body);
      if (value === undefined) continue;
      const said = mistakes.filter(
        ({ file, line }) => file === lesson && line >= fence.first && line <= fence.last,
      );
      const place = `${relative(root, join(course, lesson))}:${fence.first}`;
      const valid = schemas.get(fence.kind)(value);
      const errors = JSON.stringify(schemas.get(fence.kind).errors);
      const reasons = said.filter(
        ({ id, message }) =>
          ofOneValue.has(id) && !beyondSchemas.some(([known]) => known.test(message)),
      );
      if (said.length === 0) {
        assert.ok(valid, `${place} is right, and its schema says ${errors}`);
        ++allowed;
      } else if (reasons.length > 0) {
        assert.ok(!valid, `${place}: its schema allows what is refused: ${reasons[0].message}`);
        ++refused;
      }
    }
  }
}

test("schemas allow what the generator takes, and refuse what it refuses", () => {
  look(root);
  for (const course of coursesBelow(join(root, "tests"))) look(course);
  assert.ok(allowed > 50, `only ${allowed} fences are right`);
  assert.ok(refused > 15, `only ${refused} fences are wrong`);
});

test("schemas say of each key what it means", () => {
  const missing = [];
  function walk(schema, path) {
    for (const [key, value] of Object.entries(schema.properties ?? {})) {
      if (!value.description) missing.push(`${path}.${key}`);
      walk(value, `${path}.${key}`);
    }
    for (const inner of [schema.items, ...(schema.oneOf ?? []), ...(schema.anyOf ?? [])]) {
      if (inner) walk(inner, path);
    }
  }
  for (const name of names) walk(schemas.get(name).schema, name);
  assert.deepEqual(missing, []);
});
