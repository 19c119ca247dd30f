/** The parts of a spec: single views, and what is made of them. */
import { isObject, type Json, type JsonObject } from "./json.js";

const lists = ["layer", "concat", "hconcat", "vconcat"];

/** `spec` with each part replaced by what `change` makes of it, the inner ones first. `inherited` is
 * what the layers around a part encode for it. */
export function mapParts(
  spec: JsonObject,
  change: (part: JsonObject, inherited: JsonObject) => JsonObject,
  inherited: JsonObject = {},
): JsonObject {
  const whole: Record<string, Json> = { ...spec };
  const own = isObject(spec["encoding"]) ? spec["encoding"] : {};
  const below = (part: Json) =>
    isObject(part) ? mapParts(part, change, { ...inherited, ...own }) : part;
  for (const name of lists) {
    const list = spec[name];
    if (Array.isArray(list)) whole[name] = list.map((part: Json) => below(part));
  }
  if (spec["spec"] !== undefined) whole["spec"] = below(spec["spec"]);
  return change(whole, inherited);
}

export function markOf({ mark }: JsonObject): Json | undefined {
  return isObject(mark) ? mark["type"] : mark;
}
