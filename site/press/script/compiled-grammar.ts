/**
 * Grammars of highlight.js whose regular expressions JavaScriptCore compiles.
 *
 * Its compiler takes no group that is repeated a fixed number of times, or at least once. One such
 * group in a grammar, and all that is looked for at the same time is interpreted, which takes several
 * times as long. Comments have one in every language. So these are written out: what they match is
 * the same.
 */
import type { HLJSApi, Language, LanguageFn } from "highlight.js";

/** `[ ]+(word){3}`, three words in a row, as highlight.js tells a comment's text. */
const threeWords = /^\[ \]\+\((.*)\)\{3\}$/s;
/** `(_?[0-9])+`, the digits of Python's numbers. */
const digits = /\((_\?\[[^\]]+\])\)\+/g;

function writtenOut(source: string): string {
  return source
    .replace(threeWords, (_, word: string) => `[ ]+${`(?:${word})`.repeat(3)}`)
    .replace(digits, "$1(?:$1)*");
}

/** A copy, since the modes that languages share are frozen. They may contain themselves. */
function copyOf(value: unknown, copies: Map<object, unknown>): unknown {
  if (typeof value === "string") return writtenOut(value);
  if (value instanceof RegExp) return new RegExp(writtenOut(value.source), value.flags);
  if (typeof value !== "object" || value === null) return value;
  const known = copies.get(value);
  if (known !== undefined) return known;
  const copy = Array.isArray(value) ? [] : {};
  copies.set(value, copy);
  for (const [key, part] of Object.entries(value)) {
    Object.assign(copy, { [key]: copyOf(part, copies) });
  }
  return copy;
}

export function compiled(language: LanguageFn): LanguageFn {
  return (hljs: HLJSApi) => copyOf(language(hljs), new Map()) as Language;
}
