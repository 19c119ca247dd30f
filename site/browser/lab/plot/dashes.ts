/** How the four traces are told apart without colour: whole, long, dotted, in turn. In CSS pixels, for
 * uPlot and for the legend's SVG alike. */
export const dashes: readonly number[][] = [[], [9, 4], [2, 3], [9, 3, 2, 3]];

/** All traces of a ghost, which are thin as well. */
export const ghostDash: number[] = [4, 3];
