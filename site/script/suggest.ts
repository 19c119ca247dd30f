/** "Did you mean …?", by the rule of generator/base/nearest.h. */

/** Levenshtein's distance. */
function distance(a: string, b: string): number {
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

/** The name that was meant, written with `prefix`; else all names when they are few. */
export function suggest(name: string, known: readonly string[], prefix = ""): string {
  const limit = Math.max(2, Math.floor(name.length / 3));
  let best = "";
  let least = limit + 1;
  for (const candidate of known) {
    const edits = distance(name, candidate);
    // two edits make any short word out of any other
    if (candidate !== "" && edits < least && edits < name.length)
      [best, least] = [candidate, edits];
  }
  if (best !== "") return `did you mean \`${prefix}${best}\`?`;
  const named = known.filter((candidate) => candidate !== "");
  return named.length > 0 && named.length <= 12 ? `known: ${named.join(", ")}` : "";
}
