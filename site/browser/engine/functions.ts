/** MuJoCo's functions for scripts, as press/script/native.ts describes them. */
import type { Pointer } from "./glue.js";
import type { Memory } from "./memory.js";
import { signatures } from "../../press/script/mujoco-functions.js";
import type { Kind } from "../../press/script/arguments.js";
import type { NativeFunction } from "../../press/script/native.js";

export function nativeFunctions(
  memory: Memory,
  model: Pointer,
  data: Pointer,
): Readonly<Record<string, NativeFunction>> {
  const functions: Record<string, NativeFunction> = {};
  for (const [name, signature] of Object.entries(signatures)) {
    functions[name] = bind(memory, name, Object.values(signature), { model, data });
  }
  return functions;
}

function bind(
  memory: Memory,
  name: string,
  kinds: readonly Kind[],
  structs: Readonly<Record<"model" | "data", Pointer>>,
): NativeFunction {
  return (...args) => {
    const arrays = args.filter((arg) => typeof arg !== "number");
    return withArrays(memory, arrays, (addresses) => {
      const remaining = [...args];
      const c = kinds.map((kind) => {
        if (kind === "model" || kind === "data") return structs[kind];
        const arg = remaining.shift()!;
        return typeof arg === "number" ? arg : addresses.get(arg)!;
      });
      return memory.call(name, ...c);
    });
  };
}

/** Gives `use` an address for each array: its own where it is MuJoCo's, else that of a copy, from
 * which what C wrote is taken back. */
function withArrays<T>(
  memory: Memory,
  arrays: readonly Float64Array[],
  use: (addresses: ReadonlyMap<Float64Array, Pointer>) => T,
): T {
  const addresses = new Map<Float64Array, Pointer>();
  const foreign = new Set(arrays.filter((array) => array.buffer !== memory.buffer));
  for (const array of arrays) addresses.set(array, array.byteOffset);
  if (foreign.size === 0) return use(addresses);

  const total = [...foreign].reduce((sum, array) => sum + array.byteLength, 0);
  return memory.withRoom(total, (room) => {
    let next = room;
    for (const array of foreign) {
      new Float64Array(memory.buffer, next, array.length).set(array);
      addresses.set(array, next);
      next += array.byteLength;
    }
    const result = use(addresses);
    for (const array of foreign) {
      array.set(new Float64Array(memory.buffer, addresses.get(array), array.length));
    }
    return result;
  });
}
