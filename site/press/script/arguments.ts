/** The arguments of a MuJoCo function, checked as C would not. */
import { constants } from "./constants.js";
import { cureOfNumber, Fault, show } from "./fault.js";
import type { Native } from "./native.js";
import { viewOf } from "./strict-array.js";

/** What an argument must be: the struct, an array of so many numbers, a number, a kind's constant,
 * the id of an object of the kind before it, or a truth value. */
export type Kind = "model" | "data" | ArrayKind | NumberKind;
type ArrayKind = "nq" | "nv" | 3 | 4 | 6;
type NumberKind = "number" | "objtype" | "objid" | "flag";

/** The scripts' own `model` and `data`. */
export interface Structs {
  readonly model: { readonly nq: number; readonly nv: number };
  readonly data: object;
}

/** As C takes it; undefined for the model and the data, which the native side adds. */
type Given = number | Float64Array | undefined;

/** The kinds of objects that have a velocity. */
const moving: readonly number[] = [
  constants.mjOBJ_BODY,
  constants.mjOBJ_XBODY,
  constants.mjOBJ_GEOM,
  constants.mjOBJ_SITE,
  constants.mjOBJ_CAMERA,
];

export class ArgumentCheck {
  constructor(
    private readonly name: string,
    private readonly parameters: readonly [name: string, kind: Kind][],
    private readonly native: Native,
    private readonly structs: Structs,
  ) {}

  /** Throws a Fault at the first argument that is wrong. */
  all(args: readonly unknown[]): Given[] {
    const { parameters } = this;
    if (args.length !== parameters.length) {
      const wanted = `${parameters.length} (${parameters.map(([name]) => name).join(", ")})`;
      throw this.wrong(`wants ${wanted} arguments, not ${args.length}`);
    }
    const given: Given[] = [];
    parameters.forEach(([parameter, kind], index) => {
      given.push(this.one(parameter, kind, args[index], given[index - 1]));
    });
    return given;
  }

  private one(parameter: string, kind: Kind, arg: unknown, before: Given): Given {
    if (kind === "model" || kind === "data") {
      if (arg === this.structs[kind]) return undefined;
      throw this.wrong(`its ${parameter} must be \`${kind}\`, not ${show(arg)}`);
    }
    if (typeof kind === "number" || kind === "nq" || kind === "nv") {
      return this.array(parameter, kind, arg);
    }
    return this.number(parameter, kind, arg, before);
  }

  /** MuJoCo's own memory where `arg` is a field, else a copy. */
  private array(parameter: string, kind: ArrayKind, arg: unknown): Float64Array {
    const view = viewOf(arg) ?? (Array.isArray(arg) ? (arg as unknown[]) : undefined);
    if (view === undefined) throw this.wrong(`${parameter} must be an array, not ${show(arg)}`);
    const length = typeof kind === "number" ? kind : this.structs.model[kind];
    if (view.length !== length) {
      const expected = typeof kind === "number" ? `${length}` : `${kind} = ${length}`;
      throw this.outside(`${parameter} has ${view.length} numbers, expected ${expected}`);
    }
    for (let i = 0; i < length; i++) {
      if (Number.isFinite(view[i])) continue;
      throw this.wrong(`${parameter}[${i}] is ${show(view[i])}, not a finite number`, view[i]);
    }
    return view instanceof Float64Array ? view : Float64Array.from(view as ArrayLike<number>);
  }

  private number(parameter: string, kind: NumberKind, arg: unknown, before: Given): number {
    if (kind === "flag" && typeof arg === "boolean") return Number(arg);
    const value = viewOf(arg)?.length === 1 ? Number(arg) : arg;
    if (typeof value !== "number" || !Number.isFinite(value)) {
      throw this.wrong(`${parameter} must be a finite number, not ${show(value)}`, value);
    }
    if (kind !== "number" && !Number.isInteger(value)) {
      throw this.wrong(`${parameter} must be a whole number, not ${value}`);
    }
    if (kind === "objtype" && !moving.includes(value)) {
      throw this.wrong(`${parameter} must be mjOBJ_BODY, _XBODY, _GEOM, _SITE or _CAMERA`);
    }
    if (kind === "objid") this.checkId(parameter, value, Number(before));
    return value;
  }

  /** C reads the row of an object unasked. */
  private checkId(parameter: string, id: number, type: number): void {
    const count = this.native.names[type]!.length;
    if (id >= 0 && id < count) return;
    const range = count === 0 ? "there is none" : `out of range 0..${count - 1}`;
    throw this.outside(`${parameter} is ${id}: ${range}`);
  }

  private wrong(what: string, value?: unknown): Fault {
    return new Fault("E-script-value", `${this.name}: ${what}`, [this.name], cureOfNumber(value));
  }

  private outside(what: string): Fault {
    return new Fault("E-script-range", `${this.name}: ${what}`, [this.name]);
  }
}
