/** Numbers of a spec that ask for more than any page has room for: a few letters would take all memory. What
 * depends on the table as well is counted while it is drawn (counting.ts). */
import { fault, type Fault, type Path } from "./fault.js";
import { isObject, walk, type Json } from "./json.js";

/** Of a facet, or of what is repeated. */
export const mostParts = 1000;
export const mostBins = 1000;
export const mostPixels = 4000;
export const mostTicks = 1000;

/** What these keys may say. */
const mostOf: Readonly<Record<string, number>> = {
  count: mostTicks,
  height: mostPixels,
  maxbins: mostBins,
  order: 20,
  step: mostPixels,
  tickCount: mostTicks,
  width: mostPixels,
};

/** What these say is more than nothing. */
const positive = new Set(["height", "maxbins", "step", "width"]);

/** Keys of which each item is a part of the plot. */
const partLists = new Set(["layer", "concat", "hconcat", "vconcat", "repeat"]);

/** What a spec alone says too much of. */
export function findExcess(spec: Json): Fault[] {
  const faults: Fault[] = [];
  walk(spec, (value, path, key, around) => {
    const number = sizeOf(value, key, path.at(-2));
    const most = mostOf[key];
    if (number !== undefined && most !== undefined && number > most) {
      const message = `"${key}" is ${number}, and a plot has room for ${most}`;
      faults.push(fault("E-plot-size", path, message, `write ${most} or less`));
    }
    if (number !== undefined && positive.has(key) && number <= 0) {
      const message = `"${key}" is ${number}, and nothing can be drawn so`;
      faults.push(fault("E-plot-size", path, message, "write a number greater than 0"));
    }
    if (partLists.has(key) && path.at(-1) === key && Array.isArray(value) && value.length === 0) {
      faults.push(fault("E-plot-empty", path, `"${key}" has no parts to draw`, "give it some"));
    }
    const repeats = path.at(-1) === "repeat" && isObject(around) && "spec" in around;
    const parts = repeats ? partsOf(value) : 0;
    if (parts > mostParts) faults.push(fault("E-plot-size", path, ...tooManyParts(parts)));
  });
  return faults;
}

/** What has a step in pixels, or as wide as its bins are. */
const stepped = new Set(["bin", "height", "width"]);

/** The number behind `key` of what stands behind `outer`, where it is bounded. */
function sizeOf(value: Json, key: string, outer: Path[number] | undefined): number | undefined {
  if (typeof value !== "number") return undefined;
  if (key === "step") return stepped.has(outer as string) ? value : undefined;
  if (key === "count") return outer === "scheme" ? value : undefined;
  return outer === "mark" ? undefined : value;
}

/** Of `["x", "y"]`, or of `{"row": ["x"], "column": ["y"]}`. */
function partsOf(repeated: Json): number {
  const lists = isObject(repeated) ? Object.values(repeated) : [repeated];
  return lists.reduce<number>((n, list) => n * (Array.isArray(list) ? list.length : 1), 1);
}

export function tooManyParts(parts: number): [message: string, cure: string] {
  const message = `this makes ${parts} parts of the plot, and ${mostParts} are the most`;
  return [message, "leave some out by a filter"];
}
