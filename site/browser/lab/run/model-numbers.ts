/**
 * The numbers of a model, kept and put back. mj_resetData does not touch the model, but scripts do:
 * a slider of gravity, a button that locks a joint. So that a reset is the same start each time, and
 * a place in the past is found again with the gravity of then, the model is kept with the state.
 */
import type { Numbers } from "../../../press/script/native.js";
import { viewOf } from "../../../press/script/strict-array.js";
import type { Scope } from "../../../press/script/world.js";

/** Each field's numbers by its name in scripts, as "opt.gravity". Never changed once made. */
export type ModelNumbers = ReadonlyMap<string, Numbers | number>;

/** Megabytes that only drawing reads. */
const notKept = new Set(["tex_rgb"]);

/** What the model of `world` has now. It shares with `before` what is as it was then, and is
 * `before` itself when nothing changed. */
export function keepModel(world: Scope, before?: ModelNumbers): ModelNumbers {
  const kept = new Map<string, Numbers | number>();
  let changed = before === undefined;
  for (const { name, value } of fields(world["model"] as Struct)) {
    const old = before?.get(name);
    const same = old !== undefined && equal(old, value);
    changed ||= !same;
    kept.set(name, same ? old : copy(value));
  }
  return changed || before === undefined ? kept : before;
}

export function restoreModel(world: Scope, kept: ModelNumbers): void {
  for (const { name, member, owner, value } of fields(world["model"] as Struct)) {
    const old = kept.get(name)!;
    if (equal(old, value)) continue;
    if (typeof value === "number") owner[member] = old;
    else value.set(old as Numbers);
  }
}

interface Struct {
  [member: string]: number | Numbers | Struct;
}

interface ModelField {
  readonly name: string;
  readonly owner: Struct;
  readonly member: string;
  /** MuJoCo's own memory, where it is an array. */
  readonly value: Numbers | number;
}

function* fields(owner: Struct, prefix = ""): Generator<ModelField> {
  for (const [member, found] of Object.entries(owner)) {
    const name = prefix + member;
    if (notKept.has(name)) continue;
    const value = typeof found === "number" ? found : viewOf(found);
    if (value === undefined) yield* fields(found as Struct, `${name}.`);
    else yield { name, owner, member, value };
  }
}

function equal(a: Numbers | number, b: Numbers | number): boolean {
  if (typeof a === "number" || typeof b === "number") return Object.is(a, b);
  return a.every((value, i) => Object.is(value, b[i]));
}

function copy(value: Numbers | number): Numbers | number {
  return typeof value === "number" ? value : value.slice();
}
