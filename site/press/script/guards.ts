/**
 * What a lab's script may do is known from its text (guard/guarded.ts), but for a name that it puts
 * together and an object that it comes by. So the text that is run, in the page and in the generator
 * alike, has these two functions around them.
 */
import { Fault } from "./fault.js";

/** Members that lead from any value to the page that it is in, or to what all of the page shares. */
export const foreignMembers: ReadonlySet<string> = new Set([
  ...["constructor", "prototype", "__proto__", "caller", "callee", "arguments"],
  ...["__defineGetter__", "__defineSetter__", "__lookupGetter__", "__lookupSetter__"],
  ...["call", "apply", "bind", "fromAsync"],
  ...["captureStackTrace", "prepareStackTrace", "stackTraceLimit"],
]);

export function foreignMember(name: string): string {
  return `a lab's script cannot use \`${name}\``;
}

/** `key`, of a member; asked for its name once. */
export function guardedKey(key: unknown): PropertyKey {
  if (typeof key === "number") return key;
  const name = String(key);
  if (foreignMembers.has(name)) throw new Fault("E-script-foreign", foreignMember(name), [name]);
  return name;
}

/** `target`, of which a member is to be written: functions belong to all scripts of a page. */
export function guardedTarget(target: unknown): unknown {
  if (typeof target !== "function") return target;
  throw new Fault("E-script-foreign", "a lab's script cannot change a function", []);
}

/** The names of the two in a script, which none of an author's can be, and how they stand there. */
export const key = "key$";
export const target = "own$";
export const closing = "))/*$*/";

/** The author's text of a script that has guards in it. */
export function withoutGuards(text: string): string {
  return [`${key}((`, `${target}((`, closing].reduce(
    (left, mark) => left.replaceAll(mark, ""),
    text,
  );
}
