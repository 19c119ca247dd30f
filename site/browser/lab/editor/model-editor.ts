/** The editor of a lab's MJCF, with the place of MuJoCo's error. It is large: import it when it is
 * opened. */
import { xml } from "@codemirror/lang-xml";
import { type Editor, openEditor } from "../../editor/editor.js";
import type { LoadError } from "../../engine/errors.js";
import { diagnosticOf } from "./diagnostic.js";

export interface ModelEditorOptions {
  readonly text: string;
  /** What the field is called for those who do not see it. */
  readonly label: string;
  /** The text, when the reader pauses after a change. */
  readonly onChange: (text: string) => void;
  /** The file that is edited: errors in another one have no place here. */
  readonly file?: string;
}

export interface ModelEditor extends Editor {
  /** Marks the place of the error; undefined takes the mark away. */
  showError(error: LoadError | undefined): void;
}

/** Opens it in `host`, an element without content. */
export function openModelEditor(host: HTMLElement, options: ModelEditorOptions): ModelEditor {
  const { file, ...rest } = options;
  const editor = openEditor(host, { ...rest, language: xml() });
  const showError = (error: LoadError | undefined): void =>
    editor.mark((state) => (error === undefined ? [] : [diagnosticOf(error, state, file)]));
  return Object.assign(editor, { showError });
}
