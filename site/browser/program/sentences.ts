/** What a run came to, in sentences for its reader. */
import type { End, OutputChanges } from "../cpp/messages.js";

/** How it ended. `expected` is the exit code of the lesson's run. */
export function sentenceOf(end: End, expected: number): string {
  const place = end.line === undefined ? "" : ` (line ${end.line})`;
  if (end.how === "exit") return exit(end.code, expected, place);
  switch (end.how) {
    case "error":
      return `MuJoCo ended it${place}: ${end.message}`;
    case "uncaught":
      return `Nobody caught an exception${place}: ${end.message}`;
    case "stack-overflow":
      return `The stack overflowed${place}: a function calls itself without end, or an array is large.`;
    case "memory":
      return `It wants more memory than a program has in a page${place}.`;
    case "output":
      return "It was ended, since it prints without end.";
    case "trap":
      return `It crashed${place}: ${end.message}`;
  }
}

/** What it printed beside what the lesson's run did. */
export function comparisonSentence({ gone, come }: OutputChanges): string {
  const are = (count: number) => (count === 1 ? "is" : "are");
  const [others, missing] = [come.length, gone].map((count) => counted(count, "line"));
  if (come.length > 0) return `${others} of its output ${are(come.length)} not the lesson’s.`;
  if (gone > 0) return `${missing} of the lesson’s output ${are(gone)} missing.`;
  return "It printed what the lesson’s printed.";
}

/** "1 line", "2 lines" */
export function counted(count: number, noun: string): string {
  return `${count} ${noun}${count === 1 ? "" : "s"}`;
}

function exit(code: number, expected: number, place: string): string {
  if (code === 0 && expected === 0) return "It ended well.";
  const lesson = code === expected ? ", as in the lesson" : "";
  return `It ended with exit code ${code}${place}${lesson}.`;
}
