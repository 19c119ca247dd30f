/**
 * What a run leaves behind it as it goes: samples for the plots, and places to go back to. A place
 * that was sought is as it was then, and so is what goes on from there; only then is forgotten what
 * came after it the first time.
 */
import type { LabDescription } from "../lab-module.js";
import type { ControlValue } from "./controls.js";
import { History, type Place } from "./history.js";
import type { Pair, PairMoment } from "./pair.js";
import { Samples } from "./samples.js";
import type { Moment, Track } from "./track.js";

/** What else belongs to a place, besides the simulations. */
export interface Circumstances {
  /** Of each control what the reader set it to, null for what was not touched. */
  readonly settings: readonly ControlValue[];
  /** The body that the reader's hand holds, 0 for none. */
  readonly held: number;
}

export interface RunPlace extends Place, Circumstances {
  readonly moment: PairMoment;
  readonly ghostTime: number;
}

export class Timeline {
  readonly history = new History<RunPlace>();
  /** One for each plot. */
  readonly samples: readonly Samples[];
  readonly #lab: LabDescription;
  /** Has the run moved since the last place? */
  #moved = false;
  /** Was the place where it is sought, and not yet left? */
  #sought = false;

  constructor(lab: LabDescription) {
    this.#lab = lab;
    this.samples = lab.plots.map((plot) => new Samples(plot, lab.ghost?.label));
  }

  /** Another start: of what was before, nothing is kept. */
  startAnew({ ghost }: Pair): void {
    this.history.clear();
    this.#sought = false;
    for (const samples of this.samples) samples.clear();
    if (ghost) this.ghostArrived(ghost);
  }

  /** The run has come to where it is. */
  arrived(run: Track): void {
    this.#moved = true;
    this.samples.forEach((samples, plot) => samples.append(run.time, this.traces(run, plot)));
  }

  ghostArrived(ghost: Track): void {
    this.samples.forEach((samples, plot) =>
      samples.appendGhost(ghost.time, this.traces(ghost, plot)),
    );
  }

  /** The present values of a plot's traces; NaN for what gives no number. */
  traces({ scripts }: Track, plot: number): number[] {
    return this.#lab.plots[plot]!.traces.map(({ value }) => {
      const read = scripts.tryNumber(value);
      return typeof read === "number" ? read : NaN;
    });
  }

  /** Keeps where the run is, if it moved. */
  keep(pair: Pair, circumstances: Circumstances): void {
    if (!this.#moved) return;
    this.#moved = false;
    this.history.append(placeOf(pair, circumstances));
  }

  /** The same after a control. A slider that is dragged while time stands leaves one place, not
   * hundreds. */
  keepOperation(pair: Pair, circumstances: Circumstances): void {
    const { history } = this;
    const last = history.index > 0 ? history.at(history.index) : undefined;
    const again = last?.time === pair.run.time && last.moment.run.how === "forward";
    if (again) {
      history.replace(placeOf(pair, circumstances));
      this.#moved = false;
    }
    this.keep(pair, circumstances);
  }

  /** Takes the two to a place of the history, and gives that. */
  seek(index: number, pair: Pair): RunPlace {
    this.history.seek(index);
    const place = this.history.at(index)!;
    pair.goTo(place.moment);
    this.#sought = true;
    this.#moved = false;
    return place;
  }

  /** Before the run moves on from where it is. */
  goOn(pair: Pair): void {
    if (!this.#sought) return;
    this.#sought = false;
    const { time, ghostTime, held } = this.history.at(this.history.index)!;
    this.history.forgetFuture();
    for (const samples of this.samples) samples.truncate(time, ghostTime);
    // the hand that pulled then does not pull now
    if (held > 0) pair.endPush(held);
  }
}

function placeOf({ run, ghost, moment }: Pair, circumstances: Circumstances): RunPlace {
  const bytes = 256 + sizeOf(moment.run) + sizeOf(moment.ghost);
  return { ...circumstances, time: run.time, bytes, moment, ghostTime: ghost?.time ?? 0 };
}

function sizeOf(moment: Moment | undefined): number {
  return moment?.state?.byteLength ?? 0;
}
