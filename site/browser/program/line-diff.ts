/** Which lines of a text another one does not have. */

/** Cells of the table that is made at most; larger texts are compared line for line. */
const mostCells = 1 << 22;

/** For each line of `mine`, whether it is none of a longest common subsequence with `theirs`. */
export function newLines(mine: readonly string[], theirs: readonly string[]): boolean[] {
  if (mine.length * theirs.length > mostCells) return mine.map((line, i) => line !== theirs[i]);
  const common = commonLengths(mine, theirs);
  const wide = theirs.length + 1;
  const isNew: boolean[] = [];
  let at = 0;
  mine.forEach((line, i) => {
    const here = common[i * wide + at]!;
    // Lines of theirs that are not here are passed over where that loses nothing.
    while (at < theirs.length && line !== theirs[at] && common[i * wide + at + 1] === here) ++at;
    const same = at < theirs.length && line === theirs[at];
    if (same) ++at;
    isNew.push(!same);
  });
  return isNew;
}

/** Of what follows line `i` of mine and `j` of theirs, at i · (theirs.length + 1) + j. */
function commonLengths(mine: readonly string[], theirs: readonly string[]): Uint32Array {
  const wide = theirs.length + 1;
  const lengths = new Uint32Array((mine.length + 1) * wide);
  for (let i = mine.length - 1; i >= 0; --i) {
    for (let j = theirs.length - 1; j >= 0; --j) {
      lengths[i * wide + j] =
        mine[i] === theirs[j]
          ? lengths[(i + 1) * wide + j + 1]! + 1
          : Math.max(lengths[(i + 1) * wide + j]!, lengths[i * wide + j + 1]!);
    }
  }
  return lengths;
}
