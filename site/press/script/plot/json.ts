/** JSON as it is walked through here. */
import type { Path } from "./fault.js";

export type Json = string | number | boolean | null | readonly Json[] | JsonObject;
export interface JsonObject {
  readonly [key: string]: Json;
}

export function isObject(json: Json | undefined): json is JsonObject {
  return typeof json === "object" && json !== null && !Array.isArray(json);
}

/** Calls `visit` for each value, from the outside in, with the key under which it stands, that of its
 * list for an item, and with what it stands in. */
export function walk(
  json: Json,
  visit: (value: Json, path: Path, key: string, around: Json) => void,
  path: Path = [],
  key = "",
  around: Json = null,
): void {
  visit(json, path, key, around);
  if (Array.isArray(json)) {
    json.forEach((item: Json, i) => walk(item, visit, [...path, i], key, json));
  } else if (isObject(json)) {
    for (const [name, value] of Object.entries(json)) {
      walk(value, visit, [...path, name], name, json);
    }
  }
}

/** The strings of a string or a list. */
export function stringsOf(json: Json | undefined): string[] {
  const items = Array.isArray(json) ? (json as readonly Json[]) : [json];
  return items.filter((item) => typeof item === "string");
}
