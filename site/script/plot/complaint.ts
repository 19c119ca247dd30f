/** What Vega and Vega-Lite say of a spec. */
import { Warn, type LoggerInterface } from "vega";

import { fault, type Fault } from "./fault.js";
import { expressionKeys } from "./columns.js";
import { walk, type JsonObject } from "./json.js";

/** A logger for both: each warning becomes one of `faults`. Its functions are called by themselves. */
export function listener(spec: JsonObject, faults: Fault[]): LoggerInterface {
  const listen = (...words: readonly unknown[]) => {
    const texts = words.map((word) => (word instanceof Error ? word.message : String(word)));
    const found = vegaFault(texts.join(" "), spec);
    if (faults.every(({ message }) => message !== found.message)) faults.push(found);
    return logger;
  };
  const ignore = () => logger;
  const level = (wish?: number) => (wish === undefined ? Warn : logger);
  const logger = { level, error: listen, warn: listen, info: ignore, debug: ignore };
  return logger;
}

/** What Vega says of `spec`, at the first part of it that the message quotes, or that is an expression
 * with the message's last word. */
export function vegaFault(message: string, spec: JsonObject): Fault {
  const quoted = new Set(Array.from(message.matchAll(/["'`]([^"'`]+)["'`]/g), (match) => match[1]));
  quoted.add(/^(\w+) scale/.exec(message)?.[1]!.toLowerCase());
  const [word] = /\w+(?=\W*$)/.exec(message) ?? [];
  let found: Fault | undefined;
  walk(spec, (value, path, name) => {
    const last = path.at(-1);
    const key = typeof last === "string" && quoted.has(last);
    const spoken = typeof value === "string" && word !== undefined && expressionKeys.has(name);
    const meant = key || quoted.has(value as string) || (spoken && value.includes(word));
    if (found === undefined && meant) found = { ...fault("E-plot-spec", path, message), key };
  });
  return found ?? fault("E-plot-spec", [], message);
}
