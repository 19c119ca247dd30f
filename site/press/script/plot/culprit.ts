/** Which part of a spec Vega fails at, where all it says of it is that something of its own is undefined. */
import type { Path } from "./fault.js";
import { isObject, type Json, type JsonObject } from "./json.js";

/** Each is a drawing. */
const mostTrials = 100;

/** Without these, nothing of a part is drawn that could fail, so they are blamed last. */
const needed = new Set<string | number>(["mark", "encoding", "field", "type"]);

/** The smallest part of `spec` without which `fails` is no longer so; an empty path where none is alone to
 * blame. */
export async function findCulprit(
  spec: JsonObject,
  fails: (spec: JsonObject) => Promise<boolean>,
): Promise<Path> {
  let trials = 0;
  let path: Path = [];
  const isToBlame = async (part: Path) =>
    trials++ < mostTrials && !(await fails(without(spec, part)));
  const partsOf = (whole: Path) => stepsInto(spec, whole).map((step) => [...whole, step]);
  let parts = partsOf(path);
  while (parts.length > 0) {
    const blamed = await firstOf(parts, isToBlame);
    // a part that must not be missing may have one that is to blame
    parts = blamed === undefined ? parts.flatMap(partsOf) : partsOf(blamed);
    path = blamed ?? path;
  }
  return path;
}

async function firstOf(
  parts: readonly Path[],
  isSo: (part: Path) => Promise<boolean>,
): Promise<Path | undefined> {
  for (const part of parts) {
    if (await isSo(part)) return part;
  }
  return undefined;
}

function stepsInto(spec: Json, path: Path): readonly (string | number)[] {
  const value = path.reduce<Json>((at, step) => (at as Record<string | number, Json>)[step]!, spec);
  if (Array.isArray(value)) return value.map((_, i) => i);
  const keys = isObject(value) ? Object.keys(value) : [];
  return [...keys.filter((key) => !needed.has(key)), ...keys.filter((key) => needed.has(key))];
}

/** `spec` without what stands at `path`. */
function without<Value extends Json>(spec: Value, [step, ...rest]: Path): Value {
  if (Array.isArray(spec)) {
    const items = spec as readonly Json[];
    const changed = (item: Json) => (rest.length === 0 ? [] : [without(item, rest)]);
    return items.flatMap((item, i) => (i === step ? changed(item) : [item])) as Json as Value;
  }
  const { [step!]: value, ...others } = spec as JsonObject;
  return (rest.length === 0 ? others : { ...others, [step!]: without(value!, rest) }) as Value;
}
