/** What a spec gets beyond its author's words, where he said nothing else: series are told apart by
 * more than their colour, and logarithmic axes have few lines. */
import { isObject, type JsonObject } from "./json.js";
import { dashes, shapes } from "./look.js";
import { mapParts, markOf } from "./units.js";

/** Long enough to show a line's dashes. */
const lineInLegend = { symbolType: "stroke", symbolSize: 700 };

const logTicks = 3;

export function refine(spec: JsonObject): JsonObject {
  let points = false;
  mapParts(spec, (part) => {
    points ||= markOf(part) === "point";
    return part;
  });
  return mapParts(spec, (part, inherited) => tellApart(withFewTicks(part), inherited, points));
}

/** Points get shapes; lines get dashes, but not those that have points on them. */
function tellApart(part: JsonObject, inherited: JsonObject, points: boolean): JsonObject {
  const dashed = markOf(part) === "line" && !points;
  if (!dashed && markOf(part) !== "point") return part;
  const channel = dashed ? "strokeDash" : "shape";
  const own = isObject(part["encoding"]) ? part["encoding"] : {};
  const all: JsonObject = { ...inherited, ...own };
  const colour = all["color"];
  const tells = isObject(colour) && (colour["type"] === "nominal" || colour["type"] === "ordinal");
  if (!tells || all[channel] !== undefined) return part;
  const { scale, legend: wish, ...others } = colour;
  const domain =
    isObject(scale) && scale["domain"] !== undefined ? { domain: scale["domain"] } : {};
  const range = dashed ? dashes : shapes;
  const legend =
    wish === null ? null : { ...(dashed ? lineInLegend : {}), ...(isObject(wish) ? wish : {}) };
  const encoding = {
    ...own,
    color: { ...colour, legend },
    // shapes have no order, and Vega-Lite doubts those that are to show one
    [channel]: { ...others, type: "nominal", legend, scale: { ...domain, range } },
  };
  return { ...part, encoding };
}

/** Powers of ten alone, where there are three or more. */
function withFewTicks(part: JsonObject): JsonObject {
  const { encoding } = part;
  if (!isObject(encoding)) return part;
  const few = Object.entries(encoding).map(([channel, definition]) => {
    const scale = isObject(definition) ? definition["scale"] : undefined;
    const log = (channel === "x" || channel === "y") && isObject(scale) && scale["type"] === "log";
    if (!log || !isObject(definition) || definition["axis"] === null) return [channel, definition];
    const axis = isObject(definition["axis"]) ? definition["axis"] : {};
    return [channel, { ...definition, axis: { tickCount: logTicks, ...axis } }];
  });
  return { ...part, encoding: Object.fromEntries(few) as JsonObject };
}
