/**
 * One simulation on its way, which knows how it came to where it is. mj_step leaves in mjData what
 * belongs to the state before the step: positions in space, sensors, contacts. So a place is not
 * found again by its state alone. We keep the state before the last thing that was done, and do that
 * thing once more. Then all of mjData has the same bits as the first time.
 */
import type { Simulation } from "../../engine/simulation.js";
import type { Script } from "../lab-module.js";
import { keepModel, type ModelNumbers, restoreModel } from "./model-numbers.js";
import { Scripts } from "./scripts.js";
import { type Trouble, troubleOf } from "./trouble.js";

/** How to get to a place: from `state`, with `model`, by what was done last. */
export interface Moment {
  readonly how: "reset" | "forward" | "step";
  /** None before a reset, which depends on nothing but the model. */
  readonly state: Float64Array | undefined;
  readonly model: ModelNumbers;
}

export class Track {
  readonly simulation: Simulation;
  readonly scripts: Scripts;
  /** What went wrong first since the last reset; then nothing moves any more. */
  trouble: Trouble | undefined;
  /** The model as it was loaded, and as it is. */
  readonly #loaded: ModelNumbers;
  #model: ModelNumbers;
  #how: Moment["how"] = "reset";
  #before: Float64Array | undefined;

  constructor(simulation: Simulation, scripts: readonly Script[]) {
    this.simulation = simulation;
    this.scripts = new Scripts(scripts, simulation);
    this.#loaded = keepModel(simulation.world);
    this.#model = this.#loaded;
  }

  get time(): number {
    return (this.simulation.world["data"] as { time: number }).time;
  }

  get timestep(): number {
    return (this.simulation.world["model"] as { opt: { timestep: number } }).opt.timestep;
  }

  /** Does `work` unless there is trouble, and says whether it went well. */
  attempt(work: () => void): boolean {
    if (this.trouble !== undefined) return false;
    try {
      work();
    } catch (error) {
      this.trouble = troubleOf(error);
    }
    return this.trouble === undefined;
  }

  /** To the start: the model as loaded, mj_resetData, mj_forward. */
  reset(): void {
    this.scripts.restart();
    this.#begin(this.#loaded);
    this.#how = "reset";
    this.#before = undefined;
  }

  /** After scripts have worked on the data or on the model. */
  forward(): void {
    const { simulation } = this;
    this.#model = keepModel(simulation.world, this.#model);
    this.#how = "forward";
    this.#before = simulation.state;
    simulation.forward();
  }

  step(): void {
    const { simulation } = this;
    this.#how = "step";
    this.#before = simulation.state;
    simulation.step();
  }

  get moment(): Moment {
    return { how: this.#how, state: this.#before, model: this.#model };
  }

  /** To a place where it was before. */
  goTo({ how, state, model }: Moment): void {
    this.#begin(model);
    this.#how = how;
    this.#before = state;
    if (state === undefined) return;
    this.simulation.state = state;
    this.attempt(() => (how === "step" ? this.simulation.step() : this.simulation.forward()));
  }

  /** The reset comes in between because time may not run backwards but there. */
  #begin(model: ModelNumbers): void {
    this.trouble = undefined;
    restoreModel(this.simulation.world, model);
    this.#model = model;
    this.attempt(() => this.simulation.reset());
  }
}
