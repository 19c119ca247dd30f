// What counts as a word, in the index and in what a reader types.
//
// Names of C++ are found whole and by their parts: mj_integratePos by "integratepos" and by "pos",
// mjJNT_FREE by "free". What a reader types is never taken apart, so that "mj_step" does not find all
// that begins with mj.
//
// Scripts without blanks between words are searched by pairs of letters, as nothing here knows their words:
// 动力学 is found where 动力 and 力学 stand.

const unspaced = String.raw`\p{Script=Han}\p{Script=Hiragana}\p{Script=Katakana}\p{Script=Thai}\p{Script=Lao}\p{Script=Khmer}\p{Script=Myanmar}ー`;
const run = new RegExp(`^[${unspaced}]`, "u");
const word = new RegExp(
  String.raw`[${unspaced}]+|(?:(?![${unspaced}])[\p{L}\p{M}\p{N}_])+(?:\.\p{N}+)*`,
  "gu",
);
const humps = /(?<=\p{Ll})(?=\p{Lu})|(?<=\p{Lu})(?=\p{Lu}\p{Ll})/u;
const name = /_|^\p{Ll}.*\p{Lu}/u;

/** Where each word of `text` stands. */
export function* placesOf(text: string): Generator<{ at: number; word: string }> {
  for (const match of text.matchAll(word)) yield { at: match.index, word: match[0] };
}

export function wordsOf(text: string): string[] {
  return text.match(word) ?? [];
}

/** Is it of a script that sets no blanks between words? */
export function isRun(one: string): boolean {
  return run.test(one);
}

function pairsOf(letters: readonly string[]): string[] {
  return letters.slice(1).map((letter, index) => letters[index]! + letter);
}

/** What is looked for where a reader types `text`. */
export function soughtOf(text: string): string[] {
  return wordsOf(text).flatMap((one) => {
    const letters = Array.from(one);
    return isRun(one) && letters.length > 1 ? pairsOf(letters) : [one];
  });
}

function lettersAndPairs(letters: readonly string[]): string[] {
  return [...letters, ...pairsOf(letters)];
}

/** `one` and, of a name, its parts; of a run its letters and pairs of them. */
export function partsOf(one: string): string[] {
  if (isRun(one)) return Array.from(new Set(lettersAndPairs(Array.from(one))));
  if (!name.test(one)) return [one];
  const parts = one.split(/_+/).flatMap((part) => [part, ...part.split(humps)]);
  return [...new Set([one, ...parts.filter((part) => part.length > 1)])];
}

/** Without accents, and in small letters. */
export function folded(one: string): string {
  return one.normalize("NFKD").replace(/\p{M}/gu, "").toLowerCase();
}
