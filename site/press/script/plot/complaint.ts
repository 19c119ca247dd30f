/** What Vega and Vega-Lite say of a spec. */
import { Warn, type LoggerInterface } from "vega";

import { fault, type Fault } from "./fault.js";
import { expressionKeys } from "./columns.js";
import { walk, type JsonObject } from "./json.js";

/** What becomes of an exception that speaks of Vega's own code, until it is known which part of the spec is
 * its cause (culprit.ts). */
export const unexplained = fault(
  "E-plot-spec",
  [],
  "Vega-Lite cannot draw this plot, and does not say why",
  "leave out one part after another until it is drawn, and look at the last one",
);

/** A logger for both: each warning becomes one of `faults`. Its functions are called by themselves. */
export function listener(spec: JsonObject, faults: Fault[]): LoggerInterface {
  const listen = (...words: readonly unknown[]) => {
    const error = words.find((word) => word instanceof Error);
    const found =
      error === undefined ? vegaFault(words.map(String).join(" "), spec) : faultOf(error, spec);
    if (faults.every(({ message }) => message !== found.message)) faults.push(found);
    return logger;
  };
  const ignore = () => logger;
  const level = (wish?: number) => (wish === undefined ? Warn : logger);
  const logger = { level, error: listen, warn: listen, info: ignore, debug: ignore };
  return logger;
}

/** Vega's own exceptions have words for an author; those of its code that fails have none. */
export function faultOf(error: Error, spec: JsonObject): Fault {
  const failed = [TypeError, RangeError, ReferenceError].some((kind) => error instanceof kind);
  return failed ? unexplained : vegaFault(error.message, spec);
}

/** Vega's words for what an author may mean, in ours. */
const reworded: readonly (readonly [RegExp, message: string, cure: string])[] = [
  [/^Invalid specification \{.*$/s, "this plot has no mark", 'say what to draw: `"mark": "line"`'],
  [
    /^Unrecognized signal name: (".*")$/,
    "nothing is named $1 here",
    'a column is `datum.NAME`; other names stand in the plot\'s `"params"`',
  ],
  [/^Duplicate signal name: (".*")$/, "two parameters are named $1", "give each a name of its own"],
  [
    /^Unrecognized function: (.*)$/,
    "no function is named $1",
    "Vega's documentation has those of its expressions",
  ],
  [
    /^invalid format: (.*)$/s,
    'nothing is written in the format "$1"',
    'write `".2f"` or `"%Y-%m"`',
  ],
  [
    /^Log scale domain includes zero: (.*)$/,
    "a logarithmic scale has no zero, and this one goes over $1",
    "leave out by a filter what is not above zero, or give the scale a domain that is",
  ],
  [
    /^Using unaggregated domain with raw field has no effect .*$/s,
    'the domain "unaggregated" is for what is aggregated, and this column is not',
    'leave "domain" out',
  ],
];

/** What Vega says of `spec`, at the first part of it that the message quotes, or that is an expression
 * with the message's last word. */
export function vegaFault(told: string, spec: JsonObject): Fault {
  const [form, words, cure = ""] = reworded.find(([known]) => known.test(told)) ?? [];
  const message = form === undefined ? told : told.replace(form, words!);
  const quoted = new Set(Array.from(message.matchAll(/["'`]([^"'`]+)["'`]/g), (match) => match[1]));
  quoted.add(/^(\w+) scale/.exec(told)?.[1]!.toLowerCase());
  const [word] = /\w+(?=\W*$)/.exec(told) ?? [];
  let found: Fault | undefined;
  walk(spec, (value, path, name) => {
    const last = path.at(-1);
    const key = typeof last === "string" && quoted.has(last);
    const spoken = typeof value === "string" && word !== undefined && expressionKeys.has(name);
    const meant = key || quoted.has(value as string) || (spoken && value.includes(word));
    if (found === undefined && meant) found = { ...fault("E-plot-spec", path, message, cure), key };
  });
  return found ?? fault("E-plot-spec", [], message, cure);
}
