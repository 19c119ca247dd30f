/** What Vega takes for granted and a bare script engine has not. To be imported before it. */
import type { Json } from "./json.js";

/** Of what Vega clones: specs, which are JSON. */
function structuredClone(json: Json): Json {
  if (Array.isArray(json)) return json.map((item: Json) => structuredClone(item));
  if (typeof json !== "object" || json === null) return json;
  return Object.fromEntries(
    Object.entries(json).map(([key, value]) => [key, structuredClone(value)]),
  );
}

Object.assign(globalThis, { structuredClone });
