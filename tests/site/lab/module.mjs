// What the generator tells the page of a lab has the shape that site/browser/lab/lab-module.ts gives
// it, to the last key; and the labs that are looked at have every part that a lab can have.
//
//   node tests/site/lab/module.mjs SITE…

import { globSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

import { misfits } from "../misfits.mjs";

const labs = [];
for (const file of process.argv.slice(2).flatMap((site) => globSync(`${site}/labs/*.js`))) {
  labs.push((await import(pathToFileURL(resolve(file)))).lab);
}

const problems = misfits(
  JSON.stringify(labs, null, 1),
  "LabDescription[]",
  "site/browser/lab/lab-module.ts",
);

// What stands at `path` in any of `values`: null and empty lists count for nothing.
const parts = new Map();
function look(value, path) {
  if (Array.isArray(value)) {
    if (!parts.has(path)) parts.set(path, false);
    for (const each of value) look(each, `${path}[${each?.type ?? ""}]`);
  } else if (value !== null && typeof value === "object" && !/texts|assets/.test(path)) {
    parts.set(path, true);
    for (const [key, each] of Object.entries(value)) look(each, `${path}.${key}`);
  } else {
    parts.set(path, (parts.get(path) ?? false) || value !== null);
  }
}
for (const lab of labs) look(lab, "lab");
const types = ["button", "slider", "toggle", "select", "keyframe"];
for (const type of types) {
  if (!parts.has(`lab.controls[${type}]`)) problems.push(`no lab has a ${type}`);
}
for (const [path, seen] of parts) {
  const list = parts.has(`${path}[]`) || path === "lab.controls";
  if (!seen && !list) problems.push(`no lab has ${path}`);
}

for (const problem of problems) console.error(problem);
console.log(`${labs.length} labs, ${problems.length} problems`);
process.exitCode = labs.length > 0 && problems.length === 0 ? 0 : 1;
