/** How a run ended, in a sentence for its reader. */
import type { End } from "../cpp/messages.js";

/** `expected` is the exit code of the lesson's run. */
export function sentenceOf(end: End, expected: number): string {
  if (end.how === "exit") return exit(end.code, expected);
  const place = end.line === undefined ? "" : ` (line ${end.line})`;
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

function exit(code: number, expected: number): string {
  if (code === 0 && expected === 0) return "It ended well.";
  const lesson = code === expected ? ", as in the lesson" : "";
  return `It ended with exit code ${code}${lesson}.`;
}
