/** Does what an author says of a scale's ends let Vega tell one value from another? Where it does not, Vega
 * draws all of them at one place, and says nothing. */
import { fault, type Fault } from "./fault.js";
import { isObject, walk, type Json } from "./json.js";

/** These have ends; the domain of others is a list. */
const lists = new Set(["band", "bin-ordinal", "ordinal", "point", "quantile", "threshold"]);

export function findUnfitDomains(spec: Json): Fault[] {
  const faults: Fault[] = [];
  walk(spec, (value, path, key, around) => {
    if (key !== "scale" || !isObject(value) || !isObject(around)) return;
    const { domain, type } = value;
    const temporal = around["type"] === "temporal";
    if (!temporal && around["type"] !== "quantitative") return;
    if (!Array.isArray(domain) || lists.has(type as string)) return;
    if (hasEnds(domain as readonly Json[], temporal)) return;
    const [message, example] = temporal
      ? ["the domain of a time goes from one date to another", '["2024-01-01", "2025-01-01"]']
      : ["the domain of a quantity goes from one number to another", "[0, 1]"];
    const cure = `write \`"domain": ${example}\`, or leave it out`;
    faults.push(fault("E-plot-spec", [...path, "domain"], message, cure));
  });
  return faults;
}

function hasEnds(domain: readonly Json[], temporal: boolean): boolean {
  const isEnd = (end: Json) =>
    typeof end === "number" ||
    isObject(end) ||
    (temporal && typeof end === "string" && !Number.isNaN(Date.parse(end)));
  return domain.every(isEnd) && new Set(domain.map((end) => JSON.stringify(end))).size > 1;
}
