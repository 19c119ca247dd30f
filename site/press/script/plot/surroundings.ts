/** What Vega takes for granted and a bare script engine has not. To be imported before it. */

/** Of what Vega clones: specs, and what Vega-Lite notes beside them, in sets among others. */
function structuredClone(value: unknown): unknown {
  if (typeof value !== "object" || value === null) return value;
  if (Array.isArray(value)) return value.map(structuredClone);
  if (value instanceof Set) return new Set(Array.from(value, structuredClone));
  if (value instanceof Map) {
    return new Map(
      Array.from(value, ([key, kept]) => [structuredClone(key), structuredClone(kept)]),
    );
  }
  return Object.fromEntries(
    Object.entries(value).map(([key, kept]) => [key, structuredClone(kept)]),
  );
}

/** Vega's interpreter names the timers, to forbid them to expressions. */
function noTimer(): never {
  throw new Error("a drawing waits for nothing");
}

Object.assign(globalThis, { structuredClone, setTimeout: noTimer, setInterval: noTimer });
