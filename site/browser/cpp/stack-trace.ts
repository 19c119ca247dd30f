/** Where a program was when it ended, by what the browser's exception says of that. */

/** As many calls are told: an error of MuJoCo's may lie below some dozens of its own. */
const mostFrames = 200;

/** Exceptions are to know more of the calls than the ten innermost ones. */
export function keepLongTraces(): void {
  (Error as { stackTraceLimit?: number }).stackTraceLimit = mostFrames;
}

/**
 * The offsets in the program's module of the calls that had not returned, the innermost first. The
 * program calls the engine, and the page calls the program: the outermost module is the program's.
 */
export function programOffsets(stack: string): number[] {
  const frames = [...stack.matchAll(/([^\s(@]*):wasm-function\[\d+\]:0x([0-9a-f]+)/g)];
  const own = frames.at(-1)?.[1];
  return frames.filter(([, url]) => url === own).map(([, , offset]) => parseInt(offset!, 16));
}
