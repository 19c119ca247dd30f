/** Vega, whose transforms and functions say what they are about to make before they do: a few letters of a
 * spec can ask for more rows, bins or parts than any machine has. */
import { accessorName, expressionFunction, timeInterval, transforms } from "vega";

import {
  addPart,
  addRows,
  checkBins,
  checkTicks,
  exceed,
  placeOf,
  placeOfCall,
  type Bins,
} from "./counting.js";

type Row = Readonly<Record<string, unknown>>;
type Accessor = (row: Row) => unknown;

/** Of those transforms that are bounded. */
interface Parameters {
  readonly field?: Accessor;
  readonly fields: readonly Accessor[];
  readonly groupby?: readonly Accessor[];
  readonly key: Accessor;
  readonly keyvals?: readonly unknown[];
  readonly probs?: readonly number[];
  readonly step?: number;
  readonly steps?: number;
  readonly minsteps?: number;
  readonly maxsteps?: number;
  readonly bins?: Partial<Bins> | readonly number[];
  readonly domain?: readonly number[];
  readonly scale?: { readonly domain?: () => readonly unknown[] };
  readonly count?: number | string | Interval;
}

/** Of the ticks of a time. */
interface Interval {
  readonly interval: string;
  readonly step?: number;
}

interface Pulse {
  readonly SOURCE: number;
  materialize(flags: number): { readonly source?: readonly Row[] };
}

interface Operator {
  readonly value: object;
}

interface Prototype {
  transform: (this: Operator, parameters: Parameters, pulse: Pulse) => unknown;
  _bins: (this: Operator, parameters: Parameters) => Bins;
  subflow: (this: Operator, key: string, ...others: unknown[]) => unknown;
}

function prototypeOf(transform: string): Prototype {
  return (transforms[transform] as unknown as { prototype: Prototype }).prototype;
}

function bound(
  transform: string,
  key: string,
  makes: (parameters: Parameters, source: readonly Row[]) => number,
): void {
  const prototype = prototypeOf(transform);
  const original = prototype.transform;
  prototype.transform = function (parameters, pulse) {
    const { source = [] } = pulse.materialize(pulse.SOURCE);
    const { field } = parameters;
    addRows(makes(parameters, source), () => placeOf([key], field && accessorName(field as never)));
    return original.call(this, parameters, pulse);
  };
}

function groupsIn(source: readonly Row[], groupby: readonly Accessor[] = []): number {
  return new Set(source.map((row) => groupby.map((of) => of(row)).join())).size;
}

bound("kde", "density", ({ groupby, steps, minsteps = 25, maxsteps = 200 }, source) => {
  return groupsIn(source, groupby) * (steps ?? Math.max(minsteps, maxsteps));
});

bound("quantile", "quantile", ({ groupby, probs, step = 0.01 }, source) => {
  return groupsIn(source, groupby) * (probs?.length ?? 1 / step);
});

bound("impute", "impute", ({ groupby, key, keyvals = [] }, source) => {
  return groupsIn(source, groupby) * new Set([...keyvals, ...source.map(key)]).size;
});

bound("fold", "fold", ({ fields }, source) => fields.length * source.length);

bound("flatten", "flatten", ({ fields }, source) => {
  const lengthOf = (row: Row) =>
    fields.map((of) => (of(row) as { length?: number } | null)?.length ?? 0);
  return source.reduce((sum, row) => sum + Math.max(...lengthOf(row)), 0);
});

const bin = prototypeOf("bin");
const { _bins: binsOf } = bin;
bin._bins = function (parameters) {
  const bins = binsOf.call(this, parameters);
  checkBins(bins, () => placeOf(["bin"], accessorName(parameters.field as never)));
  return bins;
};

const scale = prototypeOf("scale");
const { transform: scaleOf } = scale;
scale.transform = function (parameters, pulse) {
  const { bins, domain } = parameters;
  if (bins !== undefined && domain !== undefined && !Array.isArray(bins)) {
    const own = { start: domain[0]!, stop: domain.at(-1)! };
    checkBins({ ...own, ...(bins as Bins) }, () => placeOf(["bins"]));
  }
  return scaleOf.call(this, parameters, pulse);
};

// How many ticks an axis or a legend gets that asks for a number of them or for one each so many
// days.
for (const guide of ["axisticks", "legendentries"]) {
  const prototype = prototypeOf(guide);
  const original = prototype.transform;
  prototype.transform = function (parameters, pulse) {
    const { count, scale } = parameters;
    const domain = scale?.domain?.() ?? [];
    if (typeof count === "number") checkTicks(count);
    const between = typeof count === "number" ? undefined : lengthOf(count);
    const all = Math.abs(Number(domain.at(-1)) - Number(domain[0]));
    if (between !== undefined) checkTicks(all / between);
    return original.call(this, parameters, pulse);
  };
}

/** About how many milliseconds lie between two ticks; nothing where Vega chooses. */
function lengthOf(count: Interval | string | undefined): number | undefined {
  const { interval = "", step = 1 } =
    typeof count === "string" ? { interval: count } : (count ?? {});
  const one = timeInterval(interval)?.offset(new Date(0), 1);
  return one && step * one.getTime();
}

// A subflow is a part of the plot, or a line of it.
const facet = prototypeOf("facet");
const { subflow } = facet;
facet.subflow = function (key, ...others) {
  if (!Object.hasOwn(this.value, key)) addPart();
  return subflow.call(this, key, ...others);
};

/** Of a text that is padded. */
const longest = 1000;
const pad = expressionFunction("pad") as (...words: unknown[]) => string;
expressionFunction("pad", (text: unknown, length: number, ...others: unknown[]) => {
  if (length > longest) {
    const message = `this pads a text to ${length} characters, and ${longest} are the most`;
    exceed(placeOfCall("pad"), message, `write ${longest} or less`);
  }
  return pad(text, length, ...others);
});

const sequence = expressionFunction("sequence") as (...numbers: number[]) => number[];
expressionFunction("sequence", (...numbers: number[]) => {
  const [start, stop] = numbers.length > 1 ? (numbers as [number, number]) : [0, numbers[0] ?? 0];
  addRows(Math.max(0, (stop - start) / (numbers[2] ?? 1)), () => placeOfCall("sequence"));
  return sequence(...numbers);
});
