// What a reader's browser remembers of this site. Storage may be refused, as in private windows, or
// full: then nothing is remembered, and the page does as if it were the first visit.
//
// All that is kept has its key here. A key bears a version: when what is kept changes its form, the
// old is left alone and not misread. A lesson's `path` is the whole path of its address, so that
// several courses of one server, or of one disk, do not mix.

export const keys = {
  theme: "theme",
  /** quiz/answers.ts */
  answer: (path: string, question: string) => `mjcourse.answer.v2:${path}#${question}`,
  /** reading/readings.ts */
  reading: (path: string) => `mjcourse.reading.v1:${path}`,
  /** program-text.ts; `root` is the path of the course, `file` "examples/x.cpp". */
  program: (root: string, file: string) => `mjcourse.program.v1:${root}#${file}`,
  /** The path of the lesson that was read last in the course at `root`. */
  last: (root: string) => `mjcourse.last.v1:${root}`,
} as const;

export function recall(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

/** JSON that `is` what it should be; undefined for nothing, and for what others have put there. */
export function recallJson<T>(key: string, is: (value: unknown) => value is T): T | undefined {
  try {
    const kept: unknown = JSON.parse(recall(key) ?? "null");
    return is(kept) ? kept : undefined;
  } catch {
    return undefined;
  }
}

/** Null forgets. */
export function remember(key: string, value: string | null): void {
  try {
    if (value === null) localStorage.removeItem(key);
    else localStorage.setItem(key, value);
  } catch {
    // The page still shows what was chosen.
  }
}
