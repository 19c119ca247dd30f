// A piece of a text around what was found in it, with that marked.

import { make } from "../element.js";
import { folded, isRun, partsOf, placesOf } from "./words.js";

const room = 150; // letters
const before = 40; // of these, ahead of the first word that is marked
const most = 300; // places that are looked at, in a long text

type Words = ReadonlySet<string>;
type Place = ReturnType<typeof placesOf> extends Generator<infer T> ? T : never;

function isFound(word: string, words: Words): boolean {
  return partsOf(word).some((part) => words.has(folded(part)));
}

// The pieces of a run that were found.
function* foundInRun({ at, word }: Place, words: Words): Generator<Place> {
  const isPart = (from: number, end: number): boolean =>
    from >= 0 && end <= word.length && words.has(folded(word.slice(from, end)));
  const covers = (index: number): boolean =>
    isPart(index, index + 1) || isPart(index, index + 2) || isPart(index - 1, index + 1);
  for (let from = 0; from < word.length; ++from) {
    let end = from;
    while (end < word.length && covers(end)) ++end;
    if (end > from) yield { at: at + from, word: word.slice(from, end) };
    from = end;
  }
}

function foundIn(text: string, words: Words): Place[] {
  const found: Place[] = [];
  for (const place of placesOf(text)) {
    if (isRun(place.word)) found.push(...foundInRun(place, words));
    else if (isFound(place.word, words)) found.push(place);
    if (found.length >= most) break;
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

// Between words, where there is a blank near; else between letters.
function startOf(text: string, best: number): number {
  const blank = text.indexOf(" ", best - before);
  return blank >= 0 && blank < best ? blank + 1 : best - before;
}

function endOf(text: string, best: number, last: number): number {
  const blank = text.lastIndexOf(" ", last);
  return blank > best ? blank : last;
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
  const from = best <= before ? 0 : startOf(text, best);
  const end = from + room >= text.length ? text.length : endOf(text, best, from + room);
  const piece = text.slice(from, end);
  return [from > 0 ? "… " : "", ...marked(piece, words), end < text.length ? " …" : ""];
}

export function hasAny(text: string, words: Words): boolean {
  for (const { word } of placesOf(text)) if (isFound(word, words)) return true;
  return false;
}
