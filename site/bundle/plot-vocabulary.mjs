// What a Vega-Lite spec may say where, boiled down from the package's JSON schema, so that a misspelt
// key can be found: Vega-Lite itself passes over what it does not know.
//
// The schema is full of alternatives (a mark is a word or one of several objects). Here they are
// merged: a state stands for all that may stand at a place, and leads to the states of its keys and
// items. So what is allowed is never refused, and a word that no alternative knows is.
//
//   {"kinds": "snbaoz"         string, number, boolean, array, object, null
//    "words": […]              the only strings, where not all are allowed
//    "keys": {key: 7}          the state of each key's value
//    "rest": 7                 … of other keys' values; without it there are no others
//    "items": 7                … of a list's items
//    "meanings": {key: "…"}}   in Markdown, as Vega-Lite's authors say it, for editors

import { readFile } from "node:fs/promises";
import path from "node:path";

// Keys and words that Vega-Lite has and a plot of a lesson has not, and why.
export const elsewhere = {
  bind: "a plot of the page stands still",
  config: "all plots look alike; set this at the mark, the axis or the legend",
  data: "a plot shows one table, which stands at its top",
  datasets: "a plot shows what an example reported",
  href: "a plot is no link",
  image: "a plot shows what an example reported",
  select: "a plot of the page stands still",
  tooltip: "a plot of the page stands still; the numbers are below it",
  url: "a plot shows what an example reported",
  usermeta: "nobody reads it",
};

const kinds = {
  string: "s",
  number: "n",
  integer: "n",
  boolean: "b",
  array: "a",
  object: "o",
  null: "z",
};

export async function plotVocabulary(site) {
  const file = path.join(site, "node_modules/vega-lite/build/vega-lite-schema.json");
  const { $ref, definitions } = JSON.parse(await readFile(file, "utf8"));
  const numbers = new Map(); // the schemas that a state stands for → its number
  const states = [];
  const stateOf = (schemas) => {
    const plain = alternatives(schemas, definitions);
    const name = [...plain.keys()].sort().join("|");
    if (!numbers.has(name)) {
      numbers.set(name, states.length);
      const at = states.push(undefined) - 1; // a state may lead back to itself
      states[at] = merge([...plain.values()], stateOf);
    }
    return numbers.get(name);
  };
  stateOf([{ $ref }]);
  return { elsewhere, states };
}

// `schemas` without references and choices, each under its own text.
function alternatives(schemas, definitions, found = new Map(), followed = new Set()) {
  for (const schema of schemas) {
    if (schema.$ref) {
      const name = decodeURIComponent(schema.$ref.replace("#/definitions/", ""));
      if (followed.has(name)) continue;
      followed.add(name);
      alternatives([definitions[name]], definitions, found, followed);
    } else if (schema.anyOf) {
      alternatives(schema.anyOf, definitions, found, followed);
    } else {
      found.set(JSON.stringify(schema), schema);
    }
  }
  return found;
}

function merge(schemas, stateOf) {
  const state = { kinds: kindsOf(schemas) };
  const words = schemas.flatMap((schema) => schema.enum ?? [schema.const]);
  const free = schemas.some((schema) => !saysWords(schema) && kindsOf([schema]).includes("s"));
  if (state.kinds.includes("s") && !free) {
    const known = words.filter((word) => typeof word === "string" && !(word in elsewhere));
    state.words = [...new Set(known)].sort();
  }
  const objects = schemas.filter((schema) => kindsOf([schema]).includes("o"));
  if (objects.length > 0) {
    const keys = keysOf(objects);
    state.keys = Object.fromEntries(keys.map(([key, found]) => [key, stateOf(found)]));
    state.meanings = meaningsOf(keys);
  }
  const rest = objects.flatMap(({ properties, additionalProperties: others }) =>
    others === false || (others === undefined && properties) ? [] : [others ?? {}],
  );
  if (rest.length > 0) state.rest = stateOf(rest.map((schema) => (schema === true ? {} : schema)));
  const items = schemas.filter((schema) => kindsOf([schema]).includes("a"));
  if (items.length > 0) state.items = stateOf(items.flatMap((schema) => schema.items ?? {}));
  return state;
}

const saysWords = (schema) => schema.enum !== undefined || schema.const !== undefined;

function kindsOf(schemas) {
  const letters = schemas.flatMap(({ type, enum: values, const: value }) => {
    if (type) return [type].flat().map((name) => kinds[name]);
    const listed = values ?? (value === undefined ? [] : [value]);
    if (listed.length > 0) return listed.map((one) => kinds[one === null ? "null" : typeof one]);
    return [...new Set(Object.values(kinds))];
  });
  return [...new Set(letters)].sort().join("");
}

// [key, what may stand behind it], by name.
function keysOf(objects) {
  const schemas = new Map();
  for (const { properties = {} } of objects) {
    for (const [key, schema] of Object.entries(properties)) {
      if (key in elsewhere) continue;
      schemas.set(key, [...(schemas.get(key) ?? []), schema]);
    }
  }
  return [...schemas].sort(([a], [b]) => (a < b ? -1 : 1));
}

// What the first alternative that says anything says in its first paragraph.
function meaningsOf(keys) {
  const meanings = {};
  for (const [key, schemas] of keys) {
    const said = schemas.find(({ description }) => description);
    if (said) [meanings[key]] = said.description.split("\n\n", 1);
  }
  return meanings;
}
