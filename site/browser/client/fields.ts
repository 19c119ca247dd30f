// What is read from storage or from a file may be anything: this looks at one field of it.

/** Whether `value` is an object that is no list, with fields of any kind. */
export function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** Whether each of the fields named is of that type; a number is a finite one, as no other lasts in JSON. */
export function hasAll(
  value: Record<string, unknown>,
  type: "boolean" | "string" | "number",
  names: readonly string[],
): boolean {
  return names.every(
    (name) => typeof value[name] === type && (type !== "number" || Number.isFinite(value[name])),
  );
}
