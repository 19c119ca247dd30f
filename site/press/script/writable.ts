/**
 * What a script may write of `model` and `data`. MuJoCo trusts whole numbers: most of them are places in
 * its memory or sizes of it, and one that is wrong makes it read or write anywhere. So a whole number is
 * written where MuJoCo bears it at run time, within bounds, and all others are read.
 */
import type { Field } from "./native.js";

/** The least and the largest value. */
export type Bounds = readonly [least: number, most: number];

const group: Bounds = [0, 2 ** 31 - 1];
const bits: Bounds = [-(2 ** 31), 2 ** 31 - 1];
/** Nothing interrupts a step. */
const iterations: Bounds = [0, 1000];

const wholeNumbers: Readonly<Record<string, Bounds>> = {
  "opt.integrator": [0, 2],
  "opt.collision": [0, 2],
  "opt.cone": [0, 1],
  "opt.jacobian": [0, 2],
  "opt.solver": [0, 2],
  "opt.iterations": iterations,
  "opt.noslip_iterations": iterations,
  "opt.mpr_iterations": iterations,
  "opt.disableflags": bits,
  "opt.enableflags": bits,
  geom_contype: bits,
  geom_conaffinity: bits,
  geom_priority: bits,
  geom_group: group,
  site_group: group,
  jnt_group: group,
  tendon_group: group,
  actuator_group: group,
  skin_group: group,
};

/** What the numbers of `field` may be: undefined where that is any, null where none may be written. */
export function boundsOf(field: Field): Bounds | null | undefined {
  if (!field.integer) return undefined;
  const name = field.owner === "" ? field.name : `${field.owner}.${field.name}`;
  return wholeNumbers[name] ?? null;
}
