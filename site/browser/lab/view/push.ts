/** A push at a body, as a reader without a mouse gives it: a force along an axis of the world for a
 * tenth of a simulated second. */
import { constants } from "../../../press/script/constants.js";
import type { Run } from "../run/run.js";

const seconds = 0.1;

export interface Body {
  readonly id: number;
  readonly name: string;
}

/** The bodies that can move. */
export function movableBodies({ simulation }: Run): readonly Body[] {
  const { body_weldid: welded } = simulation.world["model"] as { body_weldid: Int32Array };
  return simulation
    .namesOf(constants.mjOBJ_BODY)
    .map((name, id) => ({ id, name: name === "" ? `body ${id}` : name }))
    .filter(({ id }) => welded[id] !== 0);
}

/** `force` in newtons, in the world's frame. */
export function push(run: Run, body: number, force: readonly [number, number, number]): void {
  setForce(run, body, force);
  run.step(Math.max(1, Math.round(seconds / run.timestep)));
  setForce(run, body, [0, 0, 0]);
  // A place of the past is the state before a step: this one has no force in it any more.
  run.step(1);
  run.keep();
}

function setForce(run: Run, body: number, force: readonly [number, number, number]): void {
  for (const { world } of [run.simulation, ...(run.ghost ? [run.ghost.simulation] : [])]) {
    const { xfrc_applied } = world["data"] as { xfrc_applied: Record<number, number> };
    force.forEach((component, axis) => (xfrc_applied[6 * body + axis] = component));
  }
}
