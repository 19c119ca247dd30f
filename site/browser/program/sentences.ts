/** What a run came to, in sentences for its reader. */
import type { End, OutputChanges } from "../cpp/messages.js";

/** How it ended. `expected` is the exit code of the lesson's run. */
export function sentenceOf(end: End, expected: number): string {
  const place = end.line === undefined ? "" : ` (line ${end.line})`;
  if (end.how === "exit") return exit(end.code, expected, place);
  switch (end.how) {
    case "error":
      return closed(`MuJoCo ended it${place}: ${end.message}`);
    case "uncaught":
      return closed(`An exception was not caught${place}: ${end.message}`);
    case "stack-overflow":
      return `The stack overflowed${place}: a function calls itself without end, or an array is large.`;
    case "memory":
      return `It wants more memory than a program has in a page${place}.`;
    case "output":
      return "It was ended, since it prints without end.";
    case "trap":
      return closed(`It crashed${place}: ${end.message}`);
  }
}

/** What it printed beside what the lesson's run did. */
export function comparisonSentence({ gone, come }: OutputChanges): string {
  const are = (count: number) => (count === 1 ? "is" : "are");
  const missing = gone - come.length;
  const sentences = [
    ...(come.length > 0
      ? [`${counted(come.length, "line")} of its output ${are(come.length)} not the lesson’s.`]
      : []),
    ...(missing > 0
      ? [`${counted(missing, "line")} of the lesson’s output ${are(missing)} missing.`]
      : []),
  ];
  return sentences.join(" ") || "It printed what the lesson’s printed.";
}

/** What others say has a full stop or not. */
export const closed = (sentence: string): string => sentence.replace(/[^.!?]$/, "$&.");

/** "1 line", "2 lines" */
export function counted(count: number, noun: string): string {
  return `${count} ${noun}${count === 1 ? "" : "s"}`;
}

function exit(code: number, expected: number, place: string): string {
  if (code === 0 && expected === 0) return "It ran to the end.";
  const lesson = code === expected ? ", as in the lesson" : "";
  return `It ended with exit code ${code}${place}${lesson}.`;
}
