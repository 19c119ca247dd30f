/** The editor of a program, with clang's errors and warnings at their places. */
import { autocompletion, type CompletionSource } from "@codemirror/autocomplete";
import { cpp } from "@codemirror/lang-cpp";
import type { Diagnostic } from "../cpp/messages.js";
import { type Editor, openEditor } from "../editor/editor.js";
import { marksOf } from "./diagnostics.js";

export interface CodeEditorOptions {
  readonly text: string;
  /** Its path, as the compiler knows it. */
  readonly file: string;
  readonly onChange: (text: string) => void;
  readonly run: () => void;
  readonly completion: CompletionSource;
}

export interface CodeEditor extends Editor {
  showDiagnostics(diagnostics: readonly Diagnostic[]): void;
}

/** Opens it in `host`, an element without content. */
export function openCodeEditor(host: HTMLElement, options: CodeEditorOptions): CodeEditor {
  const { text, file, onChange, run, completion } = options;
  const runs = (): true => {
    run();
    return true;
  };
  const editor = openEditor(host, {
    text,
    label: `Your text of ${file}`,
    onChange,
    language: [cpp(), autocompletion({ override: [completion] })],
    keys: [{ key: "Mod-Enter", run: runs }],
  });
  const showDiagnostics = (diagnostics: readonly Diagnostic[]): void =>
    editor.mark((state) => marksOf(diagnostics, file, state));
  return Object.assign(editor, { showDiagnostics });
}
