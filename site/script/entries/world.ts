/**
 * The world inside the generator, where each world has a JavaScript realm of its own: its names
 * become globals, and every other global that scripts could reach goes.
 */
import type { Native } from "../native.js";
import { asJson, asNumber, asTruth } from "../result.js";
import { openWorld } from "../world.js";

/** What scripts may use besides the world's names, and what the world itself is made with. */
const allowed = new Set([
  ...["Array", "Boolean", "Error", "Infinity", "JSON", "Map", "NaN", "Number", "Object", "Set"],
  ...["String", "isFinite", "isNaN", "parseFloat", "parseInt", "undefined"],
  ...["ArrayBuffer", "DataView", "Float64Array", "Float32Array", "Int32Array", "Uint8Array"],
  ...["Proxy", "Reflect", "Symbol", "WeakMap"],
]);

/** Makes the names of the world over `native` the only globals; gives what the generator calls. */
function enterWorld(native: Native): object {
  const scope = openWorld(native);
  const realm = globalThis as Record<string, unknown>;
  for (const name of Object.getOwnPropertyNames(realm)) {
    if (!allowed.has(name)) Reflect.deleteProperty(realm, name);
  }
  for (const [name, value] of Object.entries(scope)) {
    Object.defineProperty(realm, name, { value, enumerable: true });
  }
  const next = (halves: Iterator<unknown>) => halves.next();
  return { asNumber, asTruth, asJson, next, names: Object.keys(scope).join("\n") };
}

Object.assign(globalThis, { enterWorld });
