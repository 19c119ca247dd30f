/** "Did you mean …?", by the rule of generator/base/nearest.h. */

/** Longer names are nobody's slip of the fingers. */
const longest = 80; // characters

/** Levenshtein's distance. */
function distance(a: readonly string[], b: readonly string[]): number {
  let above = Array.from({ length: b.length + 1 }, (_, column) => column);
  for (let row = 1; row <= a.length; row++) {
    const here = [row];
    for (let column = 1; column <= b.length; column++) {
      const change = a[row - 1] === b[column - 1] ? 0 : 1;
      here[column] = Math.min(
        above[column - 1]! + change,
        above[column]! + 1,
        here[column - 1]! + 1,
      );
    }
    above = here;
  }
  return above[b.length]!;
}

/** The name that was meant; "" where none is near. */
export function nearest(name: string, known: readonly string[]): string {
  const wanted = Array.from(name);
  if (wanted.length > longest) return "";
  let best = "";
  let least = Math.max(2, Math.floor(wanted.length / 3)) + 1;
  for (const candidate of known) {
    const letters = Array.from(candidate);
    if (Math.abs(letters.length - wanted.length) >= least) continue;
    const edits = distance(wanted, letters);
    // two edits make any short word out of any other
    if (edits < least && edits < wanted.length) [best, least] = [candidate, edits];
  }
  return best;
}

/** The name that was meant, written with `prefix`; else all names when they are few. */
export function suggest(name: string, known: readonly string[], prefix = ""): string {
  const best = nearest(name, known);
  if (best !== "") return `did you mean \`${prefix}${best}\`?`;
  const named = known.filter((candidate) => candidate !== "");
  return named.length > 0 && named.length <= 12 ? `known: ${named.join(", ")}` : "";
}
