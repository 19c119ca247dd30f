/** Are all keys and words of a spec Vega-Lite's? It passes over those that are not. */
import vocabulary from "computed:plot-vocabulary";

import { suggest } from "../suggest.js";
import { fault, type Fault, type Path } from "./fault.js";
import { isObject, type Json, type JsonObject } from "./json.js";

const { elsewhere, states } = vocabulary;
type State = (typeof states)[number];

/** Keys that a plot has besides its spec. */
export const besideSpec = ["data", "caption", "alt"];

const kindNames: Record<string, string> = {
  s: "a string",
  n: "a number",
  b: "true or false",
  a: "a list",
  o: "an object",
  z: "null",
};

export function findUnknown(spec: Json): Fault[] {
  const faults: Fault[] = [];
  check(spec, states[0]!, [], faults);
  return faults;
}

function check(json: Json, state: State, path: Path, faults: Fault[]): void {
  const kind = kindOf(json);
  if (!state.kinds.includes(kind)) {
    const expected = Array.from(state.kinds, (letter) => kindNames[letter]!).join(" or ");
    const message = `${named(path)} is ${kindNames[kind]!}; expected ${expected}`;
    faults.push(fault("E-json-kind", path, message));
  } else if (typeof json === "string") {
    if (state.words?.includes(json) === false) faults.push(unknownWord(json, state.words, path));
  } else if (Array.isArray(json) && state.items !== undefined) {
    const items = states[state.items]!;
    json.forEach((item: Json, i) => check(item, items, [...path, i], faults));
  } else if (isObject(json)) {
    checkKeys(json, state, path, faults);
  }
}

function checkKeys(object: JsonObject, state: State, path: Path, faults: Fault[]): void {
  for (const [key, value] of Object.entries(object)) {
    const next = state.keys?.[key] ?? state.rest;
    if (next === undefined || Object.hasOwn(elsewhere, key)) {
      faults.push(unknownKey(key, state, path));
    } else {
      check(value, states[next]!, [...path, key], faults);
    }
  }
}

function unknownWord(word: string, known: readonly string[], path: Path): Fault {
  const reason = Object.hasOwn(elsewhere, word) ? elsewhere[word] : undefined;
  if (reason === undefined) {
    return fault("E-plot-word", path, `${named(path)} cannot be "${word}"`, suggest(word, known));
  }
  const message = `${named(path)} of a lesson's plot cannot be "${word}": ${reason}`;
  return fault("E-plot-word", path, message, "draw it with another");
}

function unknownKey(key: string, state: State, path: Path): Fault {
  const known = [...(path.length === 0 ? besideSpec : []), ...Object.keys(state.keys ?? {})];
  const reason = elsewhere[key];
  const place = path.length === 0 ? "a plot" : named(path);
  const message =
    reason === undefined
      ? `${place} has no key "${key}"`
      : `a plot of a lesson cannot have "${key}" here: ${reason}`;
  const cure = reason === undefined ? suggest(key, known) : "leave it out";
  return { ...fault("E-json-key", [...path, key], message, cure), key: true };
}

function kindOf(json: Json): string {
  if (json === null) return "z";
  return Array.isArray(json) ? "a" : (typeof json)[0]!;
}

/** By its own key, or for an item by that of its list. */
function named(path: Path): string {
  const key = path.filter((step) => typeof step === "string").at(-1);
  return key === undefined ? "a plot" : `"${key}"`;
}
