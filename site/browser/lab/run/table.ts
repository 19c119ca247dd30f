/** Rows of numbers by time, as a simulation gives them: a column for time and one for each trace. */

/** With a step of 2 ms: three minutes. When they are full the older half goes. */
const mostRows = 100_000;

/** Points of a drawn curve: what a wide screen has room for. */
const mostPoints = 2000;

export class Table {
  /** Time first, then the traces; longer than `#length`. */
  readonly #columns: Float64Array[];
  #length = 0;
  /** Rows that went: with them, rows keep their number. */
  #gone = 0;

  constructor(readonly traces: number) {
    this.#columns = Array.from({ length: 1 + traces }, () => new Float64Array(1024));
  }

  get length(): number {
    return this.#length;
  }

  /** Column 0 is time. */
  column(index: number): Float64Array {
    return this.#columns[index]!.subarray(0, this.#length);
  }

  /** A row at the time of the last one takes its place. */
  append(time: number, values: readonly number[]): void {
    if (this.#length > 0 && this.#columns[0]![this.#length - 1] === time) this.#length--;
    if (this.#length === this.#columns[0]!.length) this.#makeRoom();
    const row = this.#length++;
    this.#columns[0]![row] = time;
    values.forEach((value, i) => (this.#columns[i + 1]![row] = value));
  }

  clear(): void {
    this.#length = 0;
    this.#gone = 0;
  }

  /** Forgets what came after `time`. */
  truncate(time: number): void {
    this.#length = this.firstAfter(time);
  }

  /** The first row later than `time`; `length` when there is none. */
  firstAfter(time: number): number {
    const times = this.#columns[0]!;
    let low = 0;
    let high = this.#length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (times[middle]! > time) high = middle;
      else low = middle + 1;
    }
    return low;
  }

  /**
   * The columns from row `begin` up to `end`, thinned to what can be seen. Of each few rows two
   * points remain, which have every trace's highest and lowest value: a spike stays. Which rows go
   * together depends on their number alone, so a curve does not shimmer as it moves on; and their
   * count is a power of two, so that it seldom changes.
   */
  thinned(begin: number, end: number): number[][] {
    const size = 2 ** Math.ceil(Math.log2((2 * (end - begin)) / mostPoints));
    if (size <= 2) return this.#columns.map((column) => Array.from(column.subarray(begin, end)));
    const thin: number[][] = this.#columns.map(() => []);
    for (let from = begin; from < end;) {
      const to = Math.min(end, from + size - ((this.#gone + from) % size));
      this.#columns.forEach((column, i) => {
        const [first, second] = i === 0 ? [from, to - 1] : extremes(column, from, to);
        thin[i]!.push(column[first]!);
        if (to - from > 1) thin[i]!.push(column[second]!);
      });
      from = to;
    }
    return thin;
  }

  #makeRoom(): void {
    if (this.#length < mostRows) {
      this.#columns.forEach((column, i) => {
        this.#columns[i] = new Float64Array(Math.min(mostRows, 2 * column.length));
        this.#columns[i].set(column);
      });
      return;
    }
    const half = mostRows / 2;
    for (const column of this.#columns) column.copyWithin(0, half);
    this.#gone += half;
    this.#length -= half;
  }
}

/** The rows of the lowest and of the highest value, in the order in which they come. */
function extremes(column: Float64Array, from: number, to: number): [number, number] {
  let low = from;
  let high = from;
  for (let row = from + 1; row < to; row++) {
    const value = column[row]!;
    if (value < column[low]! || Number.isNaN(column[low])) low = row;
    if (value > column[high]! || Number.isNaN(column[high])) high = row;
  }
  return low < high ? [low, high] : [high, low];
}
