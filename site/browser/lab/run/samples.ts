/**
 * What a plot shows: its traces at every step, those of the ghost beside them. A ghost steps at its
 * own times, so its rows are another table, and the two are merged by time where they are needed.
 */
import type { Plot } from "../lab-module.js";
import { Table } from "./table.js";

/** Curves over one column of times. Undefined: this curve has no point at that time, and goes on;
 * null: its expression gave no number, and it has a gap. */
export interface Curves {
  readonly times: readonly number[];
  /** The plot's traces, then the same of the ghost if there is one. */
  readonly traces: readonly (readonly (number | null | undefined)[])[];
}

/** A trace in words; undefined where it gave no number. */
export interface TraceSummary {
  readonly label: string;
  readonly latest: number | undefined;
  readonly lowest: number | undefined;
  readonly highest: number | undefined;
}

export class Samples {
  readonly labels: readonly string[];
  readonly #window: number;
  readonly #run: Table;
  readonly #ghost: Table | undefined;

  /** `ghost` is the ghost's label, where there is one. */
  constructor(plot: Plot, ghost?: string) {
    const labels = plot.traces.map((trace) => trace.label);
    const ghosts = ghost === undefined ? [] : labels.map((label) => `${label} (${ghost})`);
    this.labels = [...labels, ...ghosts];
    this.#window = plot.window;
    this.#run = new Table(labels.length);
    this.#ghost = ghost === undefined ? undefined : new Table(labels.length);
  }

  /** NaN for what gave no number. */
  append(time: number, values: readonly number[]): void {
    this.#run.append(time, values);
  }

  appendGhost(time: number, values: readonly number[]): void {
    this.#ghost?.append(time, values);
  }

  clear(): void {
    for (const table of this.#tables) table.clear();
  }

  /** Forgets what came after `time`, and of the ghost what came after `ghostTime`. */
  truncate(time: number, ghostTime: number): void {
    this.#run.truncate(time);
    this.#ghost?.truncate(ghostTime);
  }

  /** The curves of the plot's window that ends at `end` (the latest sample), thinned. */
  curves(end = Infinity): Curves {
    return merge(this.#tables.map((table) => this.#inWindow(table, end)));
  }

  /** The window that ends at `end` in words. */
  summary(end = Infinity): readonly TraceSummary[] {
    const columns = this.#tables.flatMap((table) => this.#inWindow(table, end).slice(1));
    return columns.map((column, i) => {
      const numbers = column.filter((value) => !Number.isNaN(value));
      if (numbers.length === 0) return { label: this.labels[i]!, ...nothing };
      const [lowest, highest] = [minimum(numbers), -minimum(numbers.map((value) => -value))];
      return { label: this.labels[i]!, latest: numbers.at(-1), lowest, highest };
    });
  }

  /** All samples since the reset, as RFC 4180 has it. */
  csv(): string {
    const { times, traces } = merge(
      this.#tables.map((table) =>
        Array.from({ length: 1 + table.traces }, (_, i) => Array.from(table.column(i))),
      ),
    );
    const rows = times.map((time, i) => [time, ...traces.map((trace) => trace[i] ?? "")]);
    return [["time (s)", ...this.labels], ...rows]
      .map((row) => `${row.map(cell).join(",")}\r\n`)
      .join("");
  }

  get #tables(): Table[] {
    return this.#ghost === undefined ? [this.#run] : [this.#run, this.#ghost];
  }

  /** With the row before it, so that the curve enters at the edge. */
  #inWindow(table: Table, end: number): number[][] {
    const last = table.firstAfter(end);
    const latest = last === 0 ? 0 : table.column(0)[last - 1]!;
    const first = table.firstAfter(latest - this.#window);
    return table.thinned(Math.max(0, first - 1), last);
  }
}

const nothing = { latest: undefined, lowest: undefined, highest: undefined };

function minimum(numbers: readonly number[]): number {
  return numbers.reduce((least, value) => Math.min(least, value));
}

/** Tables, each with its times first, as one over all their times. */
function merge(tables: readonly (readonly number[][])[]): Curves {
  const [[times, ...traces], other] = tables as [number[][], number[][] | undefined];
  if (other === undefined) return { times: times!, traces: traces.map((trace) => trace.map(gap)) };
  const all = [...new Set([...times!, ...other[0]!])].sort((a, b) => a - b);
  const spread = tables.flatMap(([own, ...columns]) => {
    const rows = new Map(own!.map((time, row) => [time, row]));
    const rowAt = all.map((time) => rows.get(time));
    return columns.map((column) =>
      rowAt.map((row) => (row === undefined ? undefined : gap(column[row]!))),
    );
  });
  return { times: all, traces: spread };
}

function gap(value: number): number | null {
  return Number.isNaN(value) ? null : value;
}

function cell(value: string | number): string {
  const text = String(value);
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
