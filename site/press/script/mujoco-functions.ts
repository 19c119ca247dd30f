/**
 * MuJoCo's functions for scripts, under their own names and with C's arguments. C trusts its caller;
 * here every argument is checked first (arguments.ts), so that a short array is a message and not a
 * crash.
 */
import { ArgumentCheck, type Kind, type Structs } from "./arguments.js";
import type { Native, NativeFunction } from "./native.js";

/** Each function's arguments by C's names, in C's order. */
export const signatures: Readonly<Record<string, Readonly<Record<string, Kind>>>> = {
  mj_step: { model: "model", data: "data" },
  mj_forward: { model: "model", data: "data" },
  mj_resetData: { model: "model", data: "data" },
  mj_differentiatePos: { model: "model", qvel: "nv", dt: "number", qpos1: "nq", qpos2: "nq" },
  mj_integratePos: { model: "model", qpos: "nq", qvel: "nv", dt: "number" },
  mj_objectVelocity: {
    model: "model",
    data: "data",
    objtype: "objtype",
    objid: "objid",
    res: 6,
    flg_local: "flag",
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

type Checked = (...args: unknown[]) => number | undefined;

export function mujocoFunctions(native: Native, structs: Structs): Record<string, Checked> {
  const functions: Record<string, Checked> = {};
  for (const [name, signature] of Object.entries(signatures)) {
    const check = new ArgumentCheck(name, Object.entries(signature), native, structs);
    functions[name] = checked(check, implementation(name, native));
  }
  return functions;
}

/** What moves the simulation is watched by the native side; the rest is MuJoCo itself. */
function implementation(name: string, native: Native): NativeFunction {
  const moving: Readonly<Record<string, () => void>> = {
    mj_step: native.step,
    mj_forward: native.forward,
    mj_resetData: native.reset,
  };
  const move = moving[name];
  if (move === undefined) return native.functions[name]!;
  return () => {
    move();
    return undefined;
  };
}

function checked(check: ArgumentCheck, run: NativeFunction): Checked {
  return (...args) => {
    const given = check.all(args);
    const result = run(...given.filter((arg) => arg !== undefined));
    // plain arrays went in as copies: give them what the function wrote
    given.forEach((written, index) => {
      const arg = args[index];
      if (written instanceof Float64Array && Array.isArray(arg)) {
        arg.splice(0, arg.length, ...written);
      }
    });
    return result;
  };
}
