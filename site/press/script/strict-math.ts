/** `Math` for scripts: an unknown member is an error, and random() gives the same numbers each time. */
import { fixedMember, strictStruct } from "./strict-struct.js";

export function strictMath(): object {
  const members: PropertyDescriptorMap = {};
  for (const name of Object.getOwnPropertyNames(Math)) {
    const value: unknown = name === "random" ? seededRandom() : Reflect.get(Math, name);
    members[name] = fixedMember(value, `Math.${name}`, "it belongs to JavaScript");
  }
  return strictStruct("Math", members);
}

/** Numbers in [0, 1) by the generator mulberry32, always from the same seed. */
function seededRandom(): () => number {
  let state = 1;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}
