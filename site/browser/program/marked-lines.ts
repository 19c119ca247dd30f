/** Which parts of a text are marked, where lines of it are. */

export interface Part {
  readonly text: string;
  readonly isMarked: boolean;
}

/** So many lines are marked at most: each is an element of the page's. */
export const mostMarked = 1000;

/** The text, in order. `numbers` are those of lines, from 1; what stands between two is one part. */
export function markedParts(text: string, numbers: readonly number[]): Part[] {
  const marked = new Set(numbers.slice(0, mostMarked));
  const parts: Part[] = [];
  let begin = 0; // of what is not marked and no part yet
  let at = 0;
  for (let line = 1; at < text.length; ++line) {
    const end = text.indexOf("\n", at) + 1 || text.length;
    if (marked.has(line)) {
      if (begin < at) parts.push({ text: text.slice(begin, at), isMarked: false });
      parts.push({ text: text.slice(at, end), isMarked: true });
      begin = end;
    }
    at = end;
  }
  if (begin < text.length) parts.push({ text: text.slice(begin), isMarked: false });
  return parts;
}
