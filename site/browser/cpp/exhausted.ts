/** What an exception says that comes of a want of room: of the stack's, or of memory's. */

/** V8 and WebKit have a RangeError for that, Gecko an error of its own. */
export const isStackOverflow = (error: unknown): boolean =>
  error instanceof Error && /call stack|recursion/i.test(error.message);

/** Not each RangeError is one: there are lengths and places that nothing can have. */
export const isOutOfMemory = (error: unknown): boolean =>
  /memory|allocat|typed array length/i.test(String(error)) && !isStackOverflow(error);
