// What counts as a word, in the index and in what a reader types.
//
// Names of C++ are found whole and by their parts: mj_integratePos by "integratepos" and by "pos",
// mjJNT_FREE by "free". What a reader types is never taken apart, so that "mj_step" does not find all
// that begins with mj.

const word = /[\p{L}\p{N}_]+(?:\.\p{N}+)*/gu;
const humps = /(?<=\p{Ll})(?=\p{Lu})|(?<=\p{Lu})(?=\p{Lu}\p{Ll})/u;
const name = /_|^\p{Ll}.*\p{Lu}/u;

/** Where each word of `text` stands. */
export function* placesOf(text: string): Generator<{ at: number; word: string }> {
  for (const match of text.matchAll(word)) yield { at: match.index, word: match[0] };
}

export function wordsOf(text: string): string[] {
  return text.match(word) ?? [];
}

/** `one` and, of a name, its parts. */
export function partsOf(one: string): string[] {
  if (!name.test(one)) return [one];
  const parts = one.split(/_+/).flatMap((part) => [part, ...part.split(humps)]);
  return [...new Set([one, ...parts.filter((part) => part.length > 1)])];
}

/** Without accents, and in small letters. */
export function folded(one: string): string {
  return one.normalize("NFKD").replace(/\p{M}/gu, "").toLowerCase();
}
