/** Where in the reader's text clang's errors and warnings are, and what they say. */
import type { Diagnostic as Mark } from "@codemirror/lint";
import type { EditorState } from "@codemirror/state";
import type { Diagnostic } from "../cpp/messages.js";

/** Of those in `file`. A note is told with the error or warning before it. */
export function marksOf(
  diagnostics: readonly Diagnostic[],
  file: string,
  state: EditorState,
): Mark[] {
  return told(diagnostics)
    .filter((one) => one.file === file && one.severity !== "note")
    .map((one) => ({
      ...rangeOf(one, state),
      severity: one.severity as Severity,
      message: one.message,
    }));
}

type Severity = "error" | "warning";

/** As a compiler prints it: "program.cpp:3:11: error: …". */
export function lineOf({ file, line, column, severity, message }: Diagnostic): string {
  const place = line > 0 ? `${file}:${line}:${column}: ` : file === "" ? "" : `${file}: `;
  return `${place}${severity}: ${message}`;
}

/** As an error of a whole line, but for the blanks before it. */
export function diagnosticOfLine(file: string, line: number, message: string): Diagnostic {
  const column = { column: 1, endColumn: Infinity };
  return { file, line, endLine: line, ...column, severity: "error", message };
}

function told(diagnostics: readonly Diagnostic[]): Diagnostic[] {
  const all: Diagnostic[] = [];
  for (const one of diagnostics) {
    const before = all.at(-1);
    if (one.severity !== "note" || !before) all.push(one);
    else all[all.length - 1] = { ...before, message: `${before.message}\n${one.message}` };
  }
  return all;
}

/** One that ends where it begins has the word there. Clang's columns are bytes of UTF-8. */
function rangeOf(
  { line, column, endLine, endColumn }: Diagnostic,
  { doc }: EditorState,
): { readonly from: number; readonly to: number } {
  const lineAt = (number: number) => doc.line(Math.min(Math.max(number, 1), doc.lines));
  const first = lineAt(line);
  const last = lineAt(endLine);
  const blanks = /^\s*/.exec(first.text)![0].length;
  const from = first.from + Math.max(blanks, charactersIn(first.text, column - 1));
  const to = last.from + charactersIn(last.text, endColumn - 1);
  if (to > from) return { from, to };
  const word = /^\w+/.exec(first.text.slice(from - first.from))?.[0] ?? "";
  return { from, to: Math.min(first.to, from + Math.max(1, word.length)) };
}

/** In so many bytes from the start of `line`. */
function charactersIn(line: string, bytes: number): number {
  const head = new TextEncoder().encode(line).subarray(0, Math.max(0, bytes));
  return new TextDecoder().decode(head).length;
}
