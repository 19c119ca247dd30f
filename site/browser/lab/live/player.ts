/**
 * Plays a run in the page. It works in frames that are asked for only when something changed, so a
 * lab at rest costs nothing. It stands still while nobody can see it, and goes on when it is seen
 * again if the reader had it playing.
 */
import { askFrame } from "../page/frames.js";
import { Presence } from "../page/presence.js";
import { Playback } from "../run/playback.js";
import type { ControlValue, Run } from "../run/run.js";

/** Milliseconds between two texts of what moves: faster than anybody reads. */
const refreshTime = 1000 / 30;

/** What follows the run. */
export interface Follower {
  /** In each frame in which something changed, while the view can be seen. */
  draw(): void;
  /** The same for numbers and curves, but at most thirty times a second while it plays. */
  refresh(): void;
}

export class Player {
  readonly run: Run;
  readonly #playback: Playback;
  readonly #presence: Presence;
  readonly #view: Element;
  readonly #follower: Follower;
  /** The reader had it playing. */
  #wanted = false;
  #isClosed = false;
  #lastRefresh = 0;

  constructor(run: Run, view: Element, follower: Follower) {
    this.run = run;
    this.#playback = new Playback(run);
    this.#follower = follower;
    this.#view = view;
    this.#presence = new Presence(() => {
      // A hidden window has no frames in which to notice.
      if (!this.#presence.seen) this.#playback.pause();
      this.changed();
    });
  }

  /** It plays while one of these, parts of the lab, can be seen. */
  playWhileSeen(...parts: readonly Element[]): void {
    this.#presence.watch(this.#view, ...parts);
  }

  /** Whether it moves now. */
  get playing(): boolean {
    return this.#wanted && this.#presence.seen;
  }

  get speed(): number {
    return this.#playback.speed;
  }
  set speed(speed: number) {
    this.#playback.speed = speed;
    this.changed();
  }

  /** The measured speed in words. */
  get rate(): string {
    return this.#playback.rate;
  }

  play(): void {
    this.#wanted = this.run.trouble === undefined;
    this.changed();
  }

  pause(): void {
    this.#wanted = false;
    this.#playback.pause();
    this.changed();
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  step(count: number): void {
    this.pause();
    this.run.step(count);
    this.run.keep();
  }

  reset(): void {
    this.pause();
    this.run.reset();
  }

  seek(index: number): void {
    this.pause();
    this.run.seek(index);
  }

  operate(index: number, value: ControlValue): void {
    this.run.operate(index, value);
    this.changed();
  }

  /** Something is to be drawn anew. */
  changed(): void {
    askFrame(this.#frame);
  }

  /** Nothing is drawn any more. */
  close(): void {
    this.#isClosed = true;
    this.#presence.close();
  }

  readonly #frame = (now: number): void => {
    if (this.#isClosed) return;
    const { playing } = this;
    if (playing) this.#playback.play();
    else this.#playback.pause();
    this.#playback.advance(now);
    // It stops by itself: on trouble, and when a prediction was measured.
    if (playing && !this.#playback.playing) this.#wanted = false;
    if (this.#presence.sees(this.#view)) this.#follower.draw();
    const rested = playing !== this.playing || !playing;
    if (rested || now - this.#lastRefresh > refreshTime - 4) {
      this.#lastRefresh = now;
      this.#follower.refresh();
    }
    if (this.playing) this.changed();
  };
}
