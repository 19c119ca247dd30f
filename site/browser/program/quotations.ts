/**
 * What the page quotes of a program: values in its text and plots, which follow the reader's run until
 * the program is the lesson's again.
 */
import { inText } from "./printf.js";
import { readResults, readTables, type Result } from "./records.js";
import { RedrawnPlot } from "./redrawn-plot.js";

/** The text and the title of the lesson. */
const lessons = new WeakMap<HTMLElement, { readonly text: string; readonly title: string }>();

/** `program` is the name that lessons quote it by. Gives how many values are the reader's now. */
export function quoteRun(program: string, records: string): number {
  const results = readResults(records);
  let count = 0;
  for (const value of quoted("value", program)) {
    const result = results.get(value.dataset["result"]!);
    if (result === undefined) quoteLessonIn(value);
    else if (quoteResultIn(value, result, program)) ++count;
  }
  const tables = readTables(records);
  for (const plot of quoted("plot", program)) void RedrawnPlot.of(plot).show(tables);
  return count;
}

export function quoteLesson(program: string): void {
  quoted("value", program).forEach(quoteLessonIn);
  for (const plot of quoted("plot", program)) RedrawnPlot.of(plot).reset();
}

function quoted(kind: "value" | "plot", program: string): HTMLElement[] {
  return [
    ...document.querySelectorAll<HTMLElement>(`.${kind}[data-quotes="${CSS.escape(program)}"]`),
  ];
}

/** False for one that came out as in the lesson. */
function quoteResultIn(value: HTMLElement, result: Result, program: string): boolean {
  const lesson = lessons.get(value) ?? { text: value.textContent, title: value.title };
  lessons.set(value, lesson);
  const format = value.dataset["format"] ?? "";
  const text = typeof result === "number" ? inText(result, format) : result;
  if (text === lesson.text) {
    quoteLessonIn(value);
    return false;
  }
  value.textContent = text;
  value.title = `from your run of ${program}.cpp; the lesson’s has ${lesson.text}`;
  value.classList.add("yours");
  return true;
}

function quoteLessonIn(value: HTMLElement): void {
  const lesson = lessons.get(value);
  if (!lesson) return;
  value.textContent = lesson.text;
  value.title = lesson.title;
  value.classList.remove("yours");
}
