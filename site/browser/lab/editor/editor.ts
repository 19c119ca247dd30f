/**
 * The editor of a lab's MJCF: CodeMirror, in a shadow root. There its styles are sheets that scripts
 * adopt, which the page's policy allows, and not <style> elements, which it does not. It is large:
 * import it when it is opened.
 */
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { xml } from "@codemirror/lang-xml";
import { bracketMatching, indentOnInput, indentUnit } from "@codemirror/language";
import { lintKeymap, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { Annotation, EditorState, type Extension } from "@codemirror/state";
import { EditorView, keymap, lineNumbers } from "@codemirror/view";
import type { LoadError } from "../../engine/errors.js";
import { diagnosticOf } from "./diagnostic.js";
import { editorTheme } from "./theme.js";

export interface EditorOptions {
  readonly text: string;
  /** What the field is called for those who do not see it. */
  readonly label: string;
  /** The text, 300 ms after the reader's last change. */
  readonly onChange: (text: string) => void;
  /** The file that is edited: errors in another one have no place here. */
  readonly file?: string;
}

export interface Editor {
  readonly text: string;
  /** Marks the place of the error; undefined takes the mark away. */
  showError(error: LoadError | undefined): void;
  /** Another text, which undo can take back; onChange is not called. */
  replace(text: string): void;
  focus(): void;
  destroy(): void;
}

/** Milliseconds that the reader pauses before the text is taken. */
const pause = 300;

/** A change that is not the reader's. */
const replaced = Annotation.define<boolean>();

/** Opens an editor in `host`, an element without content, which gets a shadow root. */
export function openEditor(host: HTMLElement, options: EditorOptions): Editor {
  const root = host.shadowRoot ?? host.attachShadow({ mode: "open" });
  const hint = makeHint();
  let waiting: ReturnType<typeof setTimeout> | undefined;
  const changes = EditorView.updateListener.of((update) => {
    if (!update.docChanged) return;
    clearTimeout(waiting);
    if (update.transactions.some((transaction) => transaction.annotation(replaced))) return;
    waiting = setTimeout(() => options.onChange(view.state.doc.toString()), pause);
  });
  const accessible = EditorView.contentAttributes.of({
    "aria-label": options.label,
    "aria-describedby": hint.id,
    // It is in the keyboard's way anyhow; said so, checkers know that what scrolls can be reached.
    tabindex: "0",
  });
  const extensions = [leaving, features, accessible, changes];
  const state = EditorState.create({ doc: options.text, extensions });
  const view = new EditorView({ state, parent: root, root });
  root.append(hint);

  return {
    get text() {
      return view.state.doc.toString();
    },
    showError(error) {
      const marks = error === undefined ? [] : [diagnosticOf(error, view.state, options.file)];
      view.dispatch(setDiagnostics(view.state, marks));
    },
    replace(text) {
      const changes = { from: 0, to: view.state.doc.length, insert: text };
      view.dispatch({ changes, annotations: replaced.of(true) });
    },
    focus: () => view.focus(),
    destroy() {
      clearTimeout(waiting);
      view.destroy();
      hint.remove();
    },
  };
}

const features: Extension = [
  lineNumbers(),
  history(),
  indentUnit.of("  "),
  indentOnInput(),
  bracketMatching(),
  xml(),
  search({ top: true }),
  highlightSelectionMatches(),
  EditorView.lineWrapping,
  keymap.of([...defaultKeymap, ...historyKeymap, ...searchKeymap, ...lintKeymap, indentWithTab]),
  editorTheme,
];

/** Tab indents; after Escape it leaves, until the reader comes back. It comes before the keymap, which
 * may take Escape for itself. */
const leaving: Extension = EditorView.domEventHandlers({
  keydown(event, view) {
    if (event.key === "Escape") view.setTabFocusMode(true);
    return false;
  },
  blur(_, view) {
    view.setTabFocusMode(false);
  },
});

function makeHint(): HTMLElement {
  const hint = document.createElement("p");
  hint.id = "hint";
  hint.textContent = "Tab indents; Escape, then Tab leaves the editor.";
  return hint;
}
