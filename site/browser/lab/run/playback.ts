/** A run that plays: enter with advance() at each displayed frame. */
import { Clock, type Pace } from "./clock.js";
import type { Run } from "./run.js";

export class Playback {
  readonly #run: Run;
  readonly #clock: Clock;
  #playing = false;

  constructor(run: Run, clock = new Clock()) {
    this.#run = run;
    this.#clock = clock;
    this.speed = run.lab.speed;
  }

  get playing(): boolean {
    return this.#playing;
  }

  /** Simulated seconds in a second, 0.1 to 4. */
  get speed(): number {
    return this.#clock.speed;
  }
  set speed(speed: number) {
    this.#clock.speed = speed;
  }

  /** The measured speed for display: "1.0×", or "0.4× — slower than asked". */
  get rate(): string {
    return this.#clock.label;
  }

  play(): void {
    if (this.#playing || this.#run.trouble !== undefined) return;
    this.#clock.pause();
    this.#playing = true;
  }

  pause(): void {
    this.#playing = false;
  }

  /** The frame that is displayed at `now`, in milliseconds. It pauses by itself when there is
   * trouble, and when a prediction has been measured. */
  advance(now: number): Pace {
    if (!this.#playing) return { steps: 0, limited: false };
    const pace = this.#clock.advance(now, () => this.#step());
    this.#run.keep();
    return pace;
  }

  /** The simulated seconds that passed; undefined when it goes no further. */
  #step(): number | undefined {
    const run = this.#run;
    if (!this.#playing) return undefined;
    const { time, predicting } = run;
    const moved = run.step() === 1;
    if (!moved || (predicting && !run.predicting)) this.pause();
    return moved ? run.time - time : undefined;
  }
}
