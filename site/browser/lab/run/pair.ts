/**
 * The simulation of a lab and that of its ghost, where it has one: the same start, the same
 * controls, the same hand. The ghost may fail alone; then it stands still and the first goes on.
 */
import type { Engine, ModelFiles } from "../../engine/engine.js";
import type { Numbers } from "../../../press/script/native.js";
import type { LabModule } from "../lab-module.js";
import { act, initialValue } from "./controls.js";
import { type Moment, Track } from "./track.js";

/** Where the two are, or were. */
export interface PairMoment {
  readonly run: Moment;
  readonly ghost: Moment | undefined;
}

export class Pair {
  readonly run: Track;
  readonly ghost: Track | undefined;
  readonly #module: LabModule;

  /** Throws a LoadError. They are not at their start yet: reset(). */
  constructor(engine: Engine, module: LabModule, files: ModelFiles) {
    const open = () => new Track(engine.load(module.lab.model.name, files), module.scripts);
    this.#module = module;
    this.run = open();
    if (module.lab.ghost === null) return;
    try {
      this.ghost = open();
    } catch (error) {
      this.run.simulation.free();
      throw error;
    }
  }

  free(): void {
    for (const track of this.#tracks) track.simulation.free();
  }

  reset(): void {
    const { controls, ghost } = this.#module.lab;
    const withValue = controls.filter((control) => initialValue(control) !== null);
    for (const track of this.#tracks) {
      track.reset();
      track.attempt(() => {
        for (const control of withValue) act(track, control, initialValue(control));
        if (withValue.length > 0) track.forward();
        if (track !== this.ghost) return;
        track.scripts.run(ghost!.run);
        track.forward();
      });
    }
  }

  /** Does `work` to both, and what follows from it. */
  operate(work: (track: Track) => void): void {
    for (const track of this.#tracks) {
      track.attempt(() => {
        work(track);
        track.forward();
      });
    }
  }

  /** One step of the first; false when it cannot. `stepped` is called after each of the ghost's. */
  step(stepped: (ghost: Track) => void): boolean {
    const { run } = this;
    if (!run.attempt(() => run.step())) return false;
    if (this.ghost) catchUp(this.ghost, run.time, stepped);
    return true;
  }

  get moment(): PairMoment {
    return { run: this.run.moment, ghost: this.ghost?.moment };
  }

  goTo({ run, ghost }: PairMoment): void {
    this.run.goTo(run);
    if (ghost) this.ghost?.goTo(ghost);
  }

  /** The ghost is pushed as the first is. */
  sharePush(body: number): void {
    if (!this.ghost) return;
    const push = pushes(this.run).slice(6 * body, 6 * body + 6);
    pushes(this.ghost).set(push, 6 * body);
  }

  endPush(body: number): void {
    for (const track of this.#tracks) pushes(track).fill(0, 6 * body, 6 * body + 6);
  }

  get #tracks(): readonly Track[] {
    return this.ghost === undefined ? [this.run] : [this.run, this.ghost];
  }
}

/** Steps until less than half a step is missing to `time`, or until time stands still. */
function catchUp(ghost: Track, time: number, stepped: (ghost: Track) => void): void {
  const until = time - ghost.timestep / 2;
  for (let before = -Infinity; ghost.time < until && ghost.time > before;) {
    before = ghost.time;
    if (!ghost.attempt(() => ghost.step())) return;
    stepped(ghost);
  }
}

/** mjData's xfrc_applied, six numbers a body. */
function pushes(track: Track): Numbers {
  return (track.simulation.world["data"] as { xfrc_applied: Numbers }).xfrc_applied;
}
