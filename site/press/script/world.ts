/**
 * The world that an author's script sees: `model`, `data`, lookups by name, MuJoCo's functions and
 * constants, a `Math` that repeats. Enter with openWorld(); the generator and the page both do, each
 * over its own engine, so a script means the same in both.
 */
import type { Structs } from "./arguments.js";
import { constants } from "./constants.js";
import { Fault, show } from "./fault.js";
import { structOf } from "./fields.js";
import { lookups } from "./lookups.js";
import { mujocoFunctions } from "./mujoco-functions.js";
import * as guards from "./guards.js";
import type { Native } from "./native.js";
import { strictMath } from "./strict-math.js";
import { refuseWrite } from "./strict-struct.js";

/** Names in scope and what they stand for. */
export type Scope = Readonly<Record<string, unknown>>;

/** `model` and `data` are made when first read. */
export function openWorld(native: Native): Scope {
  const structs = structsOf(native);
  return Object.freeze({
    get model() {
      return structs.model;
    },
    set model(_: unknown) {
      refuseWrite("model", "assign its fields one by one: model.opt.timestep = …");
    },
    get data() {
      return structs.data;
    },
    set data(_: unknown) {
      refuseWrite("data", "assign its fields one by one: data.ctrl[0] = …");
    },
    Math: strictMath(),
    ...lookups(native),
    step: (count: unknown = 1) => steps(native, count),
    forward: () => native.forward(),
    reset: () => native.reset(),
    ...mujocoFunctions(native, structs),
    ...constants,
    [guards.key]: guards.guardedKey,
    [guards.target]: guards.guardedTarget,
  });
}

/** Each made when first read: they have hundreds of members, of which a script reads few or none. */
function structsOf(native: Native): Structs {
  let model: Structs["model"] | undefined;
  let data: object | undefined;
  return {
    get model() {
      return (model ??= structOf("model", native.modelFields) as Structs["model"]);
    },
    get data() {
      return (data ??= structOf("data", native.dataFields));
    },
  };
}

/** One at a time, so that a time limit can end the loop. */
function steps(native: Native, count: unknown): void {
  if (typeof count !== "number" || !Number.isInteger(count) || count < 0) {
    const message = `step(${show(count)}): not a whole number of steps`;
    throw new Fault("E-script-value", message, ["step"]);
  }
  for (let i = 0; i < count; i++) native.step();
}
