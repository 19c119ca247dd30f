/** The order of a dictionary: `collate(language, texts)` gives the indices of the sorted texts. */

/** `texts` is JSON, and so is the answer. A language that is none takes the root's order. */
function collate(language: string, texts: string): string {
  const list = JSON.parse(texts) as string[];
  const collator = new Intl.Collator(isLanguage(language) ? language : "und", {
    sensitivity: "base",
    numeric: true,
  });
  const order = list.map((_, index) => index);
  return JSON.stringify(order.sort((a, b) => collator.compare(list[a]!, list[b]!)));
}

function isLanguage(tag: string): boolean {
  try {
    return Intl.getCanonicalLocales(tag).length === 1;
  } catch {
    return false;
  }
}

Object.assign(globalThis, { collate });
