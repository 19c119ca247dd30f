/**
 * MuJoCo's functions for scripts, under their own names and with C's arguments. C trusts its caller;
 * here every argument is checked first, so that a short array is a message and not a crash.
 */
import { constants } from "./constants.js";
import { Fault, show } from "./fault.js";
import type { Native, NativeFunction } from "./native.js";
import { viewOf } from "./strict-array.js";

/** An argument: the struct, an array of so many numbers, a number, or the id of an object. */
type Kind = "model" | "data" | "nq" | "nv" | 3 | 4 | 6 | "number" | "objtype" | "objid" | "flag";

/** Arguments by C's names, in C's order. */
const signatures: Readonly<Record<string, Readonly<Record<string, Kind>>>> = {
  mj_differentiatePos: {
    ...{ model: "model", qvel: "nv", dt: "number" },
    ...{ qpos1: "nq", qpos2: "nq" },
  },
  mj_integratePos: { model: "model", qpos: "nq", qvel: "nv", dt: "number" },
  mj_objectVelocity: {
    ...{ model: "model", data: "data", objtype: "objtype", objid: "objid" },
    ...{ res: 6, flg_local: "flag" },
  },
  mj_energyPos: { model: "model", data: "data" },
  mj_energyVel: { model: "model", data: "data" },
  mj_mulM: { model: "model", data: "data", res: "nv", vec: "nv" },
  mju_rotVecQuat: { res: 3, vec: 3, quat: 4 },
  mju_negQuat: { res: 4, quat: 4 },
  mju_mulQuat: { res: 4, quat1: 4, quat2: 4 },
  mju_quatIntegrate: { quat: 4, vel: 3, scale: "number" },
  mju_subQuat: { res: 3, qa: 4, qb: 4 },
  mju_quat2Vel: { res: 3, quat: 4, dt: "number" },
  mju_axisAngle2Quat: { res: 4, axis: 3, angle: "number" },
  mju_normalize4: { res: 4 },
};

/** What the functions are checked against. */
interface Structs {
  readonly model: { readonly nq: number; readonly nv: number };
  readonly data: object;
}

type Checked = (...args: unknown[]) => number | undefined;

export function mujocoFunctions(native: Native, structs: Structs): Record<string, Checked> {
  const functions: Record<string, Checked> = {};
  for (const [name, parameters] of Object.entries(signatures)) {
    functions[name] = checked(name, Object.entries(parameters), native, structs);
  }
  const whole = { model: "model", data: "data" } as const;
  const onStructs = { mj_step: "step", mj_forward: "forward", mj_resetData: "reset" } as const;
  for (const [name, method] of Object.entries(onStructs)) {
    const run: NativeFunction = () => void native[method]();
    functions[name] = checked(name, Object.entries(whole), native, structs, run);
  }
  return functions;
}

function checked(
  name: string,
  parameters: readonly [string, Kind][],
  native: Native,
  structs: Structs,
  run: NativeFunction = native.functions[name]!,
): Checked {
  const fail = (what: string, id: "E-script-value" | "E-script-range" = "E-script-value") =>
    new Fault(id, `${name}: ${what}`, [name]);
  return (...args) => {
    if (args.length !== parameters.length) {
      const wanted = parameters.map(([parameter]) => parameter).join(", ");
      throw fail(`takes ${parameters.length} arguments (${wanted}), not ${args.length}`);
    }
    const given: (number | Float64Array)[] = [];
    parameters.forEach(([parameter, kind], index) => {
      const arg = args[index];
      if (kind === "model" || kind === "data") {
        if (arg !== structs[kind]) throw fail(`argument ${index + 1} must be \`${kind}\``);
      } else if (typeof kind === "number" || kind === "nq" || kind === "nv") {
        given.push(numbers(arg, parameter, kind, structs, fail));
      } else {
        given.push(whole(arg, parameter, kind, native, given, fail));
      }
    });
    const result = run(...given);
    writeBack(args, parameters, given);
    return result;
  };
}

type Fail = (what: string, id?: "E-script-value" | "E-script-range") => Fault;

/** The argument as a Float64Array: MuJoCo's own memory where it is a field, else a copy. */
function numbers(
  arg: unknown,
  parameter: string,
  kind: 3 | 4 | 6 | "nq" | "nv",
  structs: Structs,
  fail: Fail,
): Float64Array {
  const view = viewOf(arg) ?? (Array.isArray(arg) ? (arg as unknown[]) : undefined);
  if (view === undefined) throw fail(`${parameter} must be an array, not ${show(arg)}`);
  const expected = typeof kind === "number" ? kind : structs.model[kind];
  if (view.length !== expected) {
    const size = typeof kind === "number" ? `${expected}` : `${kind} = ${expected}`;
    throw fail(`${parameter} has ${view.length} numbers, expected ${size}`, "E-script-range");
  }
  for (let i = 0; i < view.length; i++) {
    if (Number.isFinite(view[i])) continue;
    throw fail(`${parameter}[${i}] is ${show(view[i])}, not a finite number`);
  }
  return view instanceof Float64Array ? view : Float64Array.from(view as ArrayLike<number>);
}

/** A number; an object's id must exist, for C reads its row unasked. */
function whole(
  arg: unknown,
  parameter: string,
  kind: "number" | "objtype" | "objid" | "flag",
  native: Native,
  given: readonly (number | Float64Array)[],
  fail: Fail,
): number {
  const value = viewOf(arg)?.length === 1 ? Number(arg) : arg;
  if (kind === "flag" && typeof value === "boolean") return value ? 1 : 0;
  if (typeof value !== "number" || !Number.isFinite(value)) {
    throw fail(`${parameter} must be a finite number, not ${show(value)}`);
  }
  if (kind !== "number" && !Number.isInteger(value)) {
    throw fail(`${parameter} must be a whole number, not ${value}`);
  }
  if (kind === "objtype" && !moving.includes(value)) {
    throw fail(`${parameter} must be mjOBJ_BODY, _XBODY, _GEOM, _SITE or _CAMERA, not ${value}`);
  }
  if (kind === "objid") {
    // the object's type is the argument before
    const count = native.names[given[given.length - 1] as number]!.length;
    if (value < 0 || value >= count) {
      throw fail(`${parameter} is ${value}, out of range 0..${count - 1}`, "E-script-range");
    }
  }
  return value;
}

/** The kinds of objects that have a velocity. */
const moving: readonly number[] = [
  constants.mjOBJ_BODY,
  constants.mjOBJ_XBODY,
  constants.mjOBJ_GEOM,
  constants.mjOBJ_SITE,
  constants.mjOBJ_CAMERA,
];

/** Plain arrays went in as copies: give them what the function wrote. */
function writeBack(
  args: readonly unknown[],
  parameters: readonly [string, Kind][],
  given: readonly (number | Float64Array)[],
): void {
  let next = 0;
  parameters.forEach(([, kind], index) => {
    if (kind === "model" || kind === "data") return;
    const result = given[next++]!;
    const arg = args[index];
    if (typeof result !== "number" && Array.isArray(arg)) arg.splice(0, arg.length, ...result);
  });
}
