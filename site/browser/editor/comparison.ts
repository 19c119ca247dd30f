/** Two texts side by side with what differs marked; on a narrow page, one below the other. It is loaded
 * where a reader asks for it. */
import { unifiedMergeView, MergeView } from "@codemirror/merge";
import { EditorState, type Extension } from "@codemirror/state";
import { EditorView, lineNumbers } from "@codemirror/view";
import { editorTheme } from "./theme.js";

export interface Side {
  readonly text: string;
  /** For those who do not see it. */
  readonly label: string;
}

const look = EditorView.theme({
  ".cm-changedLine, .cm-insertedLine, .cm-deletedChunk": {
    background: "color-mix(in srgb, var(--accent) 10%, transparent) !important",
  },
  ".cm-changedText": {
    background: "color-mix(in srgb, var(--accent) 24%, transparent) !important",
  },
  ".cm-deletedChunk": { textDecoration: "none" },
});

/** Shows `own` and `other` in `host`, an element without content. */
export function compareTexts(host: HTMLElement, own: Side, other: Side, language: Extension): void {
  const root = host.shadowRoot ?? host.attachShadow({ mode: "open" });
  const place = document.createElement("div");
  root.replaceChildren(place);
  const extensionsOf = ({ label }: Side): Extension => [
    lineNumbers(),
    EditorView.lineWrapping,
    EditorState.readOnly.of(true),
    EditorView.contentAttributes.of({ "aria-label": label, tabindex: "0" }),
    language,
    editorTheme,
    look,
  ];
  if (host.clientWidth < 640) {
    const original = unifiedMergeView({ original: own.text, mergeControls: false, gutter: true });
    const state = EditorState.create({
      doc: other.text,
      extensions: [extensionsOf(other), original],
    });
    new EditorView({ state, parent: place, root });
    return;
  }
  new MergeView({
    a: { doc: own.text, extensions: extensionsOf(own) },
    b: { doc: other.text, extensions: extensionsOf(other) },
    parent: place,
    root,
    gutter: true,
  });
}
