/**
 * Places of a run that the reader can go back to, one for each displayed frame. Memory is bounded:
 * when it is full, every second place goes.
 */

export interface Place {
  /** Simulated seconds. */
  readonly time: number;
  /** Of memory, about. */
  readonly bytes: number;
}

export class History<P extends Place> {
  #places: P[] = [];
  #bytes = 0;
  #index = -1;
  readonly #most: number;

  /** `most` is in bytes. */
  constructor(most = 16 * 1024 * 1024) {
    this.#most = most;
  }

  get length(): number {
    return this.#places.length;
  }

  /** Where the run is: the last place, or the one that was sought; -1 when there is none. */
  get index(): number {
    return this.#index;
  }

  /** Is there something after where the run is? */
  get isPast(): boolean {
    return this.#index < this.#places.length - 1;
  }

  /** Undefined outside of 0…length - 1. */
  at(index: number): P | undefined {
    return this.#places[index];
  }

  get last(): P | undefined {
    return this.#places.at(-1);
  }

  /** The place nearest to `time`, -1 when there is none. */
  nearest(time: number): number {
    const later = this.#places.findIndex((place) => place.time > time);
    if (later <= 0) return later === 0 ? 0 : this.#places.length - 1;
    const [before, after] = [this.#places[later - 1]!, this.#places[later]!];
    return after.time - time < time - before.time ? later : later - 1;
  }

  clear(): void {
    this.#places = [];
    this.#bytes = 0;
    this.#index = -1;
  }

  /** Adds a place after the present one; what was after that is forgotten. */
  append(place: P): void {
    this.forgetFuture();
    this.#places.push(place);
    this.#bytes += place.bytes;
    if (this.#bytes > this.#most) this.#thinOut();
    this.#index = this.#places.length - 1;
  }

  /** `place` instead of the present one; what was after that is forgotten. */
  replace(place: P): void {
    this.#keep((_, index) => index < this.#index);
    this.append(place);
  }

  seek(index: number): void {
    if (this.#places[index] === undefined) throw new RangeError(`there is no place ${index}`);
    this.#index = index;
  }

  forgetFuture(): void {
    if (this.isPast) this.#keep((_, index) => index <= this.#index);
  }

  /** The first place and the last stay. */
  #thinOut(): void {
    const last = this.#places.length - 1;
    this.#keep((_, index) => index % 2 === 0 || index === last);
  }

  #keep(stays: (place: P, index: number) => boolean): void {
    this.#places = this.#places.filter(stays);
    this.#bytes = this.#places.reduce((sum, { bytes }) => sum + bytes, 0);
    this.#index = Math.min(this.#index, this.#places.length - 1);
  }
}
