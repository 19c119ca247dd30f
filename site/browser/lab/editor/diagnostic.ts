/** Where in the text an error of MuJoCo's is. */
import type { Diagnostic } from "@codemirror/lint";
import type { EditorState, Line } from "@codemirror/state";
import type { LoadError } from "../../engine/errors.js";

/** MuJoCo seldom knows the column: then it is the line without its indent; and where it knows no
 * line, or one of another file than `file`, it is the first. */
export function diagnosticOf(error: LoadError, state: EditorState, file?: string): Diagnostic {
  const { doc } = state;
  const here = file === undefined || error.file === "" || file === error.file;
  const line = doc.line(here ? Math.min(Math.max(error.line, 1), doc.lines) : 1);
  const place = here && error.column > 0 ? wordAt(line, error.column - 1) : trimmed(line);
  const elsewhere = here ? "" : `${error.file}: `;
  const cure = error.cure === "" ? "" : ` (${error.cure})`;
  return { ...place, severity: "error", message: `${elsewhere}${error.message}${cure}` };
}

interface Range {
  readonly from: number;
  readonly to: number;
}

function wordAt({ from, text }: Line, column: number): Range {
  const start = Math.min(column, text.length);
  const word = /^[\w.:-]*/.exec(text.slice(start))![0];
  return { from: from + start, to: from + Math.min(text.length, start + Math.max(1, word.length)) };
}

function trimmed({ from, text }: Line): Range {
  const start = text.length - text.trimStart().length;
  return { from: from + start, to: from + Math.max(start, text.trimEnd().length) };
}
