/** Is what a spec came to fit to be shown? */
import type { Spec, View } from "vega";

import { fault, type Fault, type Path } from "./fault.js";
import { stringsOf, walk, type Json, type JsonObject } from "./json.js";
import { colours } from "./look.js";

/** Numbers that the spec makes out of the table and nobody can draw. */
export function unfitNumbers(view: View, spec: JsonObject): Fault[] {
  const names = namesIn(spec);
  for (const rows of setsOf(view)) {
    for (const [index, row] of rows.entries()) {
      if ("mark" in row && "datum" in row) continue; // what was drawn for a row
      for (const [name, path] of names) {
        const value = row[name];
        const good = typeof value === "number" ? Number.isFinite(value) : value !== null;
        if (good && (value !== undefined || !(name in row))) continue;
        const message = `"${name}" is ${String(value)} in row ${index + 1} of what is drawn`;
        return [fault("E-plot-finite", path, message, "leave such rows out by a filter before")];
      }
    }
  }
  return [];
}

/** The columns that a spec shows: where it makes them, else where it shows them first. Those that are
 * made for a filter or an expression alone, nobody draws. */
function namesIn(spec: JsonObject): Map<string, Path> {
  const shown = new Map<string, Path>();
  const made = new Map<string, Path>();
  walk(spec, (value: Json, path, key) => {
    for (const name of stringsOf(value)) {
      if (key === "as") made.set(name, path);
      const asked = path.includes("filter") || path.includes("test");
      if (key === "field" && !asked && !shown.has(name)) shown.set(name, path);
    }
  });
  return new Map(Array.from(shown, ([name, path]) => [name, made.get(name) ?? path]));
}

export function noRows(view: View, compiled: Spec): Fault[] {
  const outliers = setsOfOutliers(compiled);
  const sets = Object.keys(insideOf(view).data).filter((name) => !outliers.has(name));
  if (sets.every((name) => rowsOf(view, name).length > 0)) return [];
  const message = "what this plot filters leaves no row to draw";
  return [fault("E-plot-empty", [], message, "look at its filters")];
}

/** Vega-Lite's own filter of a boxplot: what lies outside of the whiskers, which nothing may. */
const outsideOfWhiskers = /^\(datum\[[^\]]*\] < datum\['lower_box_/;

/** What holds a boxplot's outliers, what is made of them, and what is drawn for them. */
export function setsOfOutliers({ data = [], marks = [] }: Spec): Set<string> {
  const found = new Set<string>();
  for (const set of data) {
    const own = set.transform?.some(
      (one) => one.type === "filter" && outsideOfWhiskers.test(one.expr),
    );
    const sources = "source" in set ? [set.source].flat() : [];
    if (own === true || sources.some((name) => found.has(name))) found.add(set.name);
  }
  for (const { name, from } of marks) {
    const drawn = from !== undefined && "data" in from ? from.data : undefined;
    if (name !== undefined && drawn !== undefined && found.has(drawn)) found.add(name);
  }
  return found;
}

function rowsOf(view: View, name: string): readonly Record<string, unknown>[] {
  return (view.data(name) as Record<string, unknown>[] | undefined) ?? [];
}

/** The rows of the table and of what became of it. */
function setsOf(view: View): readonly (readonly Record<string, unknown>[])[] {
  return Object.keys(insideOf(view).data).map((name) => rowsOf(view, name));
}

export function tooManySeries(view: View): Fault[] {
  for (const name of Object.keys(insideOf(view).scales)) {
    const scale = view.scale(name) as { range?: () => unknown[]; domain?: () => unknown[] };
    const series = scale.domain?.().length ?? 0;
    if (scale.range?.()[0] !== colours[0] || series <= colours.length) continue;
    return [
      fault(
        "E-plot-series",
        [],
        `this plot has ${series} series, and colours for ${colours.length}`,
        'leave some out, or give each a part of its own by "facet"',
      ),
    ];
  }
  return [];
}

/** More than this is no drawing for a page. */
const mostLetters = 300_000;

export function unfitSvg(svg: string): Fault[] {
  const faults: Fault[] = [];
  const attributes = svg.replace(/>[^<]*</g, "><");
  if (/\b(?:NaN|Infinity|undefined)\b/.test(attributes) || />(?:NaN|undefined)</.test(svg)) {
    const message = "something of this plot would stand where no number says";
    faults.push(
      fault("E-plot-finite", [], message, "look for a logarithm of 0, or a division by it"),
    );
  }
  if (svg.length > mostLetters) {
    const message = `this plot would weigh ${Math.round(svg.length / 1000)} KB, more than a page should`;
    faults.push(
      fault("E-plot-size", [], message, "let the example report fewer rows, say every tenth"),
    );
  }
  return faults;
}

/** The names of what a view has inside, which it tells in no other way. */
function insideOf(view: View): { readonly data: object; readonly scales: object } {
  return (view as unknown as { _runtime: { data: object; scales: object } })._runtime;
}
