/**
 * The editor of a lab's MJCF and of a lesson's C++: CodeMirror, in a shadow root. There its styles are sheets that scripts
 * adopt, which the page's policy allows, and not <style> elements, which it does not. It is large:
 * import it when it is opened.
 */
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { bracketMatching, indentOnInput, indentUnit } from "@codemirror/language";
import { type Diagnostic, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { Annotation, EditorState, type Extension } from "@codemirror/state";
import { EditorView, type KeyBinding, keymap, lineNumbers } from "@codemirror/view";
import { editorTheme } from "./theme.js";

export interface EditorOptions {
  readonly text: string;
  /** What the field is called for those who do not see it. */
  readonly label: string;
  /** The text, 300 ms after the reader's last change. */
  readonly onChange: (text: string) => void;
  readonly language: Extension;
  /** Before all other keys. */
  readonly keys?: readonly KeyBinding[];
}

export interface Editor {
  readonly text: string;
  /** Marks the places that `find` gives for the text as it is, instead of those before. */
  mark(find: (state: EditorState) => readonly Diagnostic[]): void;
  /** Makes the line, of which the first is 1, the one in the middle. */
  scrollTo(line: number): void;
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
  const own = keymap.of(options.keys ?? []);
  const extensions = [leaving, own, features, options.language, accessible, changes];
  const state = EditorState.create({ doc: options.text, extensions });
  const view = new EditorView({ state, parent: root, root });
  root.append(hint);

  return {
    get text() {
      return view.state.doc.toString();
    },
    mark(find) {
      view.dispatch(setDiagnostics(view.state, find(view.state)));
    },
    scrollTo(line) {
      const { doc } = view.state;
      const { from } = doc.line(Math.min(Math.max(line, 1), doc.lines));
      view.dispatch({ effects: EditorView.scrollIntoView(from, { y: "center" }) });
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
