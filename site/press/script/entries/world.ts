/**
 * The world inside the generator, where each world has a JavaScript realm of its own: its names
 * become globals, and every other global that scripts could reach goes.
 */
import { fieldsOf, type Table } from "../field-table.js";
import { fixBuiltins } from "../fixed-builtins.js";
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

/** What the generator gives: a Native with tables in the place of fields. */
interface Tables extends Omit<Native, "modelFields" | "dataFields"> {
  readonly modelTable: Table;
  readonly dataTable: Table;
}

/** Makes the names of the world over `native` the only globals; gives what the generator calls. */
function enterWorld(native: Tables): object {
  const { modelTable, dataTable, ...rest } = native;
  const fields = { modelFields: fieldsOf(modelTable), dataFields: fieldsOf(dataTable) };
  const scope = openWorld({ ...rest, ...fields });
  const realm = globalThis as Record<string, unknown>;
  fixBuiltins(realm, allowed);
  for (const name of Object.getOwnPropertyNames(realm)) {
    if (!allowed.has(name)) Reflect.deleteProperty(realm, name);
  }
  Object.defineProperties(realm, Object.getOwnPropertyDescriptors(scope));
  const next = (halves: Iterator<unknown>) => halves.next();
  return { asNumber, asTruth, asJson, next, names: Object.keys(scope).join("\n") };
}

Object.assign(globalThis, { enterWorld });
