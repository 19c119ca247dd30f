/**
 * A lab as its reader drives it, without a page: reset, steps, controls, readings, a ghost, a past to
 * go back to. Enter with new Run(); it is at its start then. What it does is what the build's
 * rehearsal does, in the same order, so that the same numbers come out, bit for bit:
 *
 *   reset    the model as loaded, mj_resetData, mj_forward; then the controls that have a value, in
 *            order, and mj_forward if there was one
 *   control  its script, mj_forward; the same for the ghost
 *   step     mj_step; the ghost as far as it has to, to be less than half a step of its own behind
 *
 * Scripts and MuJoCo may fail: then `trouble` says so and nothing moves until the next reset, seek or
 * recompile. Only a model that does not load makes the constructor throw (LoadError).
 */
import { isNear } from "../../client/quiz/near.js";
import type { Engine, ModelFiles } from "../../engine/engine.js";
import { LoadError } from "../../engine/errors.js";
import type { Hold, Scene } from "../../engine/scene.js";
import type { Simulation } from "../../engine/simulation.js";
import type { LabDescription, LabModule, ScriptIndex } from "../lab-module.js";
import { act, type ControlValue, fitting, initialValue } from "./controls.js";
import { fixed } from "./fixed.js";
import type { History } from "./history.js";
import { Pair } from "./pair.js";
import type { Samples } from "./samples.js";
import { type Circumstances, type RunPlace, Timeline } from "./timeline.js";
import type { Moment, Track } from "./track.js";
import { isOutOfMemory, ScriptTrouble, type Trouble, whyNoEdit } from "./trouble.js";
import { type Look, Visualization } from "./visualization.js";

export type { ControlValue } from "./controls.js";

/** The second run. */
export interface GhostRun {
  readonly simulation: Simulation;
  readonly scene: Scene;
  readonly time: number;
  /** It may fail alone: then it stands still and the first run goes on. */
  readonly trouble: Trouble | undefined;
}

/** What a link needs to bring another reader here. Of the model it has what controls with a value
 * did to it, not what buttons did. */
export interface RunState {
  /** For each control what the reader set it to, null for what was not touched. */
  readonly settings: readonly ControlValue[];
  readonly run: Omit<Moment, "model">;
  readonly ghost: Omit<Moment, "model"> | undefined;
}

export class Run {
  readonly lab: LabDescription;
  readonly #engine: Engine;
  readonly #module: LabModule;
  readonly #timeline: Timeline;
  #files: ModelFiles;
  #pair: Pair;
  #visualization: Visualization | undefined;
  /** What the next visualization begins with. */
  #look: Look;
  #settings: readonly ControlValue[] = [];
  #goalReached = false;
  /** Steps until the prediction is measured, 0 when none is going on. */
  #stepsToMeasure = 0;
  #measured: number | undefined;

  constructor(engine: Engine, module: LabModule, files: ModelFiles) {
    this.lab = module.lab;
    this.#engine = engine;
    this.#module = module;
    this.#timeline = new Timeline(module.lab);
    this.#look = module.lab;
    this.#files = files;
    this.#pair = new Pair(engine, module, files);
    this.reset();
  }

  /** Gives all memory back; the run is not to be used again. */
  free(): void {
    this.#pair.free();
  }

  // Where it is.

  /** Where it has been since the reset: seek() goes back there. */
  get history(): History<RunPlace> {
    return this.#timeline.history;
  }

  /** What the plots show, in their order. */
  get samples(): readonly Samples[] {
    return this.#timeline.samples;
  }

  get simulation(): Simulation {
    return this.#pair.run.simulation;
  }

  /** Simulated seconds. */
  get time(): number {
    return this.#pair.run.time;
  }

  get timestep(): number {
    return this.#pair.run.timestep;
  }

  /** The first thing that went wrong since the last reset, seek or recompile. */
  get trouble(): Trouble | undefined {
    return this.#pair.run.trouble;
  }

  /** The scenes, the camera, the overlays and the reader's hand. Take it anew for each frame:
   * recompile() may open another one. */
  get visualization(): Visualization {
    return this.#visualization ?? this.#openVisualization();
  }

  get scene(): Scene {
    return this.visualization.scene;
  }

  get ghost(): GhostRun | undefined {
    const { ghost } = this.#pair;
    if (ghost === undefined) return undefined;
    const { simulation, time, trouble } = ghost;
    return { simulation, scene: this.visualization.ghost!, time, trouble };
  }

  /**
   * The present value of each control. A slider shows what it is bound to, whatever wrote there; null
   * for a button, a select without a choice, a slider that cannot be read.
   */
  get settings(): readonly ControlValue[] {
    return this.lab.controls.map((control, i) => {
      if (control.type === "slider") return this.#number(control.read) ?? null;
      if (control.type === "toggle") return this.#settings[i] ?? control.value;
      return this.#settings[i] ?? initialValue(control);
    });
  }

  // Readings.

  /** The readout as the build prints it, "–" where it gives no number. */
  printed(index: number): string {
    const { value, digits } = this.lab.readouts[index]!;
    const number = this.#number(value);
    return number === undefined ? "–" : fixed(number, digits);
  }

  /** Why the first readout or trace that gives no number gives none. */
  get readingTrouble(): ScriptTrouble | undefined {
    const { scripts } = this.#pair.run;
    for (const { value } of [...this.lab.readouts, ...this.lab.plots.flatMap((p) => p.traces)]) {
      const read = scripts.tryNumber(value);
      if (read instanceof ScriptTrouble) return read;
    }
    return undefined;
  }

  // What moves it.

  reset(): void {
    this.#settings = this.lab.controls.map(() => null);
    this.#stepsToMeasure = 0;
    this.#measured = undefined;
    this.#pair.reset();
    this.#timeline.startAnew(this.#pair);
    this.#arrived();
    this.keep();
  }

  /** Steps, fewer when there is trouble or when a prediction is measured; gives how many. */
  step(count = 1): number {
    if (this.trouble === undefined) this.#timeline.goOn(this.#pair);
    for (let done = 0; done < count; done++) {
      if (!this.#step()) return done;
      if (this.#stepsToMeasure > 0 && --this.#stepsToMeasure === 0) {
        this.#measure();
        return done + 1;
      }
    }
    return count;
  }

  /** The reader uses a control: see ControlValue. */
  operate(index: number, value: ControlValue): void {
    if (this.trouble !== undefined) return;
    this.#stepsToMeasure = 0;
    this.#timeline.goOn(this.#pair);
    const control = this.lab.controls[index]!;
    this.#settings = this.#settings.with(index, value);
    this.#operate((track) => act(track, control, value));
  }

  /** Keeps where it is for the history: once for each displayed frame. */
  keep(): void {
    if (this.trouble === undefined) this.#timeline.keep(this.#pair, this.#circumstances);
  }

  /** To a place of the history, with the bits it had then. What came after it stays, until the run
   * moves on from there. */
  seek(index: number): void {
    this.#stepsToMeasure = 0;
    this.#settings = this.#timeline.seek(index, this.#pair).settings;
  }

  /** The reader's hand takes the body that visualization.select() found, or lets go of it. */
  hold(hold: Hold): void {
    const { held } = this.visualization;
    this.visualization.hold(hold);
    // once without a hand: its force is gone then
    if (held > 0 && this.visualization.held === 0) this.#pull(held);
  }

  // A link.

  get state(): RunState {
    const { run, ghost } = this.#pair.moment;
    return {
      settings: this.#settings,
      run: { how: run.how, state: run.state },
      ghost: ghost && { how: ghost.how, state: ghost.state },
    };
  }

  /** To the state of a link; what does not fit this lab is left out. */
  restore({ settings, run, ghost }: Partial<RunState>): void {
    this.reset();
    this.lab.controls.forEach((control, i) => {
      const value = fitting(control, settings?.[i] ?? null);
      if (value !== null) this.operate(i, value);
    });
    this.#timeline.startAnew(this.#pair);
    if (run) restoreMoment(this.#pair.run, run);
    if (ghost && this.#pair.ghost) restoreMoment(this.#pair.ghost, ghost);
    this.#arrived();
    this.keep();
  }

  // What the reader is asked.

  /** Starts the experiment of the prediction: step() then stops where `measured` is known. */
  predict(): void {
    const { run, seconds } = this.lab.predict!;
    this.reset();
    if (run !== null) this.#operate((track) => track.scripts.run(run));
    this.#stepsToMeasure = Math.round(seconds / this.timestep);
    if (this.#stepsToMeasure === 0) this.#measure();
  }

  get predicting(): boolean {
    return this.#stepsToMeasure > 0 && this.trouble === undefined;
  }

  /** What the experiment gave; undefined until it is over. */
  get measured(): number | undefined {
    return this.#measured;
  }

  /** Once reached it stays so, over resets and edited models: it is the reader who reached it. */
  get goalReached(): boolean {
    return this.#goalReached;
  }

  /** May the tasks be answered? */
  get tasksOpen(): boolean {
    return this.lab.goal === null || this.#goalReached;
  }

  /** Is the reader's number right for the model as it is? Undefined when the model does not tell. */
  judgeTask(index: number, given: number): boolean | undefined {
    const task = this.lab.editable!.tasks[index]!;
    const right = this.#number(task.value);
    return right === undefined ? undefined : isNear(given, right, task.tolerance);
  }

  // The edited model.

  /** Of the model, as it is edited. */
  get files(): ModelFiles {
    return this.#files;
  }

  /** The MJCF of the model's main file. */
  get mjcf(): string {
    return this.#files[this.lab.model.name] as string;
  }

  /** Starts anew with `mjcf` as the model's main file. Where that does not load it says why, and
   * all is as it was; only where the page has no memory for it the former model starts anew. */
  recompile(mjcf: string): LoadError | undefined {
    const former = this.#files;
    const { name } = this.lab.model;
    try {
      this.#startWith({ ...former, [name]: mjcf });
      return undefined;
    } catch (error) {
      if (this.simulation.freed || this.#files !== former) this.#startWith(former);
      return whyNoEdit(error, name);
    }
  }

  // How it is done.

  #startWith(files: ModelFiles): void {
    const pair = this.#load(files);
    this.#leave();
    this.#pair = pair;
    this.#files = files;
    this.reset();
    this.#openVisualization();
  }

  /** Beside the present model, or in its place where the page has no memory for both. */
  #load(files: ModelFiles): Pair {
    const load = () => new Pair(this.#engine, this.#module, files);
    try {
      return load();
    } catch (error) {
      if (!isOutOfMemory(error)) throw error;
      this.#leave();
      return load();
    }
  }

  /** Frees the present model; the next one is looked at as it was. */
  #leave(): void {
    if (this.#visualization !== undefined) {
      const { camera, overlays } = this.#visualization;
      this.#look = { camera, overlays };
      this.#visualization = undefined;
    }
    this.free();
  }

  #openVisualization(): Visualization {
    this.#visualization = new Visualization(
      this.simulation,
      this.#pair.ghost?.simulation,
      this.#look,
    );
    return this.#visualization;
  }

  #step(): boolean {
    const held = this.#visualization?.held ?? 0;
    if (held > 0) this.#pull(held);
    const stepped = this.#pair.step((ghost) => this.#timeline.ghostArrived(ghost));
    if (stepped) this.#arrived();
    return stepped;
  }

  #pull(body: number): void {
    this.visualization.pull();
    this.#pair.sharePush(body);
  }

  /** What `work` does to the simulations, and what follows from it. */
  #operate(work: (track: Track) => void): void {
    const { time } = this;
    this.#pair.operate(work);
    // a keyframe is another start
    if (this.time < time) this.#timeline.startAnew(this.#pair);
    if (this.#pair.ghost) this.#timeline.ghostArrived(this.#pair.ghost);
    this.#arrived();
    if (this.trouble === undefined) this.#timeline.keepOperation(this.#pair, this.#circumstances);
  }

  /** It is somewhere else than before. */
  #arrived(): void {
    if (this.trouble !== undefined) return;
    this.#timeline.arrived(this.#pair.run);
    const { goal } = this.lab;
    if (goal !== null && !this.#goalReached) this.#goalReached = this.#truth(goal.done);
  }

  #measure(): void {
    this.#measured = this.#number(this.lab.predict!.value);
  }

  get #circumstances(): Circumstances {
    return { settings: this.#settings, held: this.#visualization?.held ?? 0 };
  }

  #number(script: ScriptIndex): number | undefined {
    const read = this.#pair.run.scripts.tryNumber(script);
    return typeof read === "number" ? read : undefined;
  }

  /** A goal that speaks of what an edited model does not have is not reached. */
  #truth(script: ScriptIndex): boolean {
    try {
      return this.#pair.run.scripts.truth(script);
    } catch (error) {
      if (error instanceof ScriptTrouble) return false;
      throw error;
    }
  }
}

function restoreMoment(track: Track, { how, state }: Omit<Moment, "model">): void {
  if (state?.length !== track.simulation.state.length) return;
  track.goTo({ how, state, model: track.moment.model });
}
