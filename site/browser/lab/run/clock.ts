/**
 * How many steps belong into a displayed frame, so that simulated time keeps pace with real time: no
 * more than fit into the frame, and none for the time in which nobody looked.
 */

/** Milliseconds of a frame that steps may take; the rest is for drawing. */
const budget = 10;

/** Seconds that a frame makes up for at most. */
const longestFrame = 0.1;

/** Seconds over which the measured rate is smoothed; after a longer gap it is measured anew. */
const smoothing = 0.5;

/** What a frame did. */
export interface Pace {
  readonly steps: number;
  /** There was no time for all the steps that were due. */
  readonly limited: boolean;
}

export class Clock {
  /** Simulated seconds in a second, 0.1 to 4. */
  speed = 1;

  /** Milliseconds now. */
  readonly #time: () => number;
  #last: number | undefined;
  /** Simulated seconds that are due. */
  #due = 0;
  /** Fading sums of real and simulated seconds, for the rate. */
  #real = 0;
  #simulated = 0;

  constructor(time: () => number = () => performance.now()) {
    this.#time = time;
  }

  /**
   * The frame at `now`, in milliseconds: calls `step` for each step that is due. It gives the
   * simulated seconds that passed, or undefined when the simulation goes no further.
   */
  advance(now: number, step: () => number | undefined): Pace {
    const elapsed = this.#elapsed(now);
    this.#due += this.speed * Math.min(elapsed, longestFrame);
    const end = this.#time() + budget;
    let steps = 0;
    let passed = 0;
    let limited = false;
    for (; this.#due > 0 && !limited; steps++) {
      const seconds = step();
      if (seconds === undefined) break;
      passed += seconds;
      this.#due -= seconds;
      limited = this.#time() >= end;
    }
    limited &&= this.#due > 0;
    // what was missed is not made up for: it would only make the next frame late as well
    if (limited) this.#due = 0;
    this.#measure(elapsed, passed);
    return { steps, limited };
  }

  /** The next frame is the first one again. */
  pause(): void {
    this.#last = undefined;
    this.#due = 0;
    this.#real = 0;
    this.#simulated = 0;
  }

  /** Simulated seconds in a second, as measured; undefined before there is something to measure. */
  get rate(): number | undefined {
    return this.#real < smoothing / 2 ? undefined : this.#simulated / this.#real;
  }

  /** The rate for display: "1.0×", or "0.4× — slower than asked". */
  get label(): string {
    const { rate } = this;
    const slow = rate !== undefined && rate < 0.9 * this.speed;
    return `${(rate ?? this.speed).toFixed(1)}×${slow ? " — slower than asked" : ""}`;
  }

  #elapsed(now: number): number {
    const elapsed = this.#last === undefined ? 0 : Math.max(0, now - this.#last) / 1000;
    this.#last = now;
    return elapsed;
  }

  #measure(elapsed: number, passed: number): void {
    const fade = elapsed > 2 * smoothing ? 0 : Math.exp(-elapsed / smoothing);
    this.#real = this.#real * fade + (fade === 0 ? 0 : elapsed);
    this.#simulated = this.#simulated * fade + (fade === 0 ? 0 : passed);
  }
}
