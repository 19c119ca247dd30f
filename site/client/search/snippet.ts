// A piece of a text around what was found in it, with that marked.

import { make } from "../element.js";
import { folded, partsOf, placesOf } from "./words.js";

const room = 150; // letters
const before = 40; // of these, ahead of the first word that is marked
const most = 300; // places that are looked at, in a long text

type Words = ReadonlySet<string>;
type Place = ReturnType<typeof placesOf> extends Generator<infer T> ? T : never;

function isFound(word: string, words: Words): boolean {
  return partsOf(word).some((part) => words.has(folded(part)));
}

function foundIn(text: string, words: Words): Place[] {
  const found: Place[] = [];
  for (const place of placesOf(text)) {
    if (isFound(place.word, words)) found.push(place);
    if (found.length === most) break;
  }
  return found;
}

/** All of `text`. */
export function marked(text: string, words: Words): (Node | string)[] {
  const parts: (Node | string)[] = [];
  let done = 0;
  for (const { at, word } of foundIn(text, words)) {
    parts.push(text.slice(done, at), make("mark", {}, word));
    done = at + word.length;
  }
  return [...parts, text.slice(done)];
}

/** The first piece of `text` with the most of `words`; its beginning where there are none. */
export function snippet(text: string, words: Words): (Node | string)[] {
  const found = foundIn(text, words);
  const worth = (index: number): number => {
    const inside = found.slice(index).filter(({ at }) => at < found[index]!.at + room - before);
    return new Set(inside.map(({ word }) => folded(word))).size;
  };
  const worths = found.map((_, index) => worth(index));
  const best = found[worths.indexOf(Math.max(...worths))]?.at ?? 0;
  const from = best <= before ? 0 : text.indexOf(" ", best - before) + 1;
  const end = from + room >= text.length ? text.length : text.lastIndexOf(" ", from + room);
  const piece = text.slice(Math.min(from, best), end > best ? end : from + room);
  return [from > 0 ? "… " : "", ...marked(piece, words), end < text.length ? " …" : ""];
}

export function hasAny(text: string, words: Words): boolean {
  for (const { word } of placesOf(text)) if (isFound(word, words)) return true;
  return false;
}
