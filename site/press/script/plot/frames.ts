/** A plot for wide and for narrow screens. Where its author says nothing of its width, it is drawn
 * twice, since one that is shrunk to a phone cannot be read. */
import { mostPixels } from "./bounds.js";
import { draw, type Drawing, type Row } from "./drawing.js";
import { fault, type Fault } from "./fault.js";
import { isObject, type Json, type JsonObject } from "./json.js";
import { mapParts } from "./units.js";

/** As wide as a paragraph, in CSS pixels. */
const widest = 640;
const wide = { width: widest, height: 320, room: { legend: 4, ticks: 7 } };
const narrow = { width: 328, height: 280, room: { legend: 2, ticks: 4 } };

export interface Drawings {
  readonly wide: Drawing;
  /** Null where the wide one is for all. */
  readonly narrow: Drawing | null;
}

/** `id` begins the ids inside of the drawings. */
export async function drawForPage(
  spec: JsonObject,
  rows: readonly Row[],
  id: string,
  faults: Fault[],
): Promise<Drawings> {
  const drawIn = async ({ width, height, room }: typeof wide, name: string) => {
    const sized = withoutContainers(spec);
    const framed = hasOwnWidth(sized) ? sized : fitInto(sized, width, height);
    const drawing = await draw(spec, framed, rows, { id: `${id}-${name}`, room }, faults);
    if (drawing.width > width) {
      const message = `this plot is ${drawing.width} pixels wide, and the page has ${width} for it`;
      faults.push(
        fault("E-plot-size", [], message, "make its parts narrower, or its labels shorter"),
      );
    }
    if (drawing.height > mostPixels) {
      const message = `this plot is ${drawing.height} pixels high, and a page has room for ${mostPixels}`;
      faults.push(fault("E-plot-size", [], message, "make its parts lower, or fewer"));
    }
    return drawing;
  };
  const drawing = await drawIn(wide, "wide");
  // what is wrong with one is wrong with the other
  const again = faults.length === 0 && !hasOwnWidth(withoutContainers(spec));
  return { wide: drawing, narrow: again ? await drawIn(narrow, "narrow") : null };
}

/** A plot of several parts has the sum of theirs. */
function hasOwnWidth({ encoding, ...spec }: JsonObject): boolean {
  if (hasOwn(spec, "width")) return true;
  const facets = ["row", "column", "facet"].some((key) => isObject(encoding) && key in encoding);
  return facets || ["concat", "hconcat", "vconcat", "facet", "repeat"].some((key) => key in spec);
}

/** As wide as there is room, and as high, where the author says nothing of its height. */
function fitInto(spec: JsonObject, width: number, height: number): JsonObject {
  const framed = { autosize: { type: "fit", contains: "padding" }, ...spec, width };
  return hasOwn(spec, "height") ? framed : { ...framed, height };
}

/** The page is no container that has a size: such a plot, or such a layer, is as large as one that says
 * nothing of it. */
function withoutContainers(spec: JsonObject): JsonObject {
  const isContainer = ([key, value]: [string, Json]) =>
    (key === "width" || key === "height") && value === "container";
  return mapParts(spec, (part) =>
    Object.fromEntries(Object.entries(part).filter((member) => !isContainer(member))),
  );
}

/** Does a plot, or a layer of it, say its size? */
function hasOwn(spec: JsonObject, side: "width" | "height"): boolean {
  const layers = Array.isArray(spec["layer"]) ? (spec["layer"] as readonly Json[]) : [];
  return spec[side] !== undefined || layers.some((part) => isObject(part) && hasOwn(part, side));
}
