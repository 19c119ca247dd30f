/** A text, and another with what differs marked: its own lines, and above them those in whose place they
 * came. It is loaded where a reader asks for it. */
import { unifiedMergeView } from "@codemirror/merge";
import { EditorState, type Extension } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { editorTheme } from "./theme.js";

const mixed = (colour: string, share: number): { background: string } => ({
  background: `color-mix(in srgb, var(--${colour}) ${share}%, transparent) !important`,
});

const look = EditorView.theme({
  ".cm-deletedChunk": { paddingInlineStart: "0" },
  ".cm-deletedChunk .cm-deletedLine": mixed("wrong", 9),
  ".cm-deletedChunk .cm-deletedText": mixed("wrong", 24),
  ".cm-changedLine, .cm-insertedLine": mixed("proved", 9),
  ".cm-changedText": mixed("proved", 24),
  ".cm-deletedLine::before": { content: '"− "' },
  ".cm-changedLine::before": { content: '"+ "' },
});

/** Shows `later` in `host`, an element without content, and how it differs from `former`. */
export function compareTexts(
  host: HTMLElement,
  [former, later]: readonly [string, string],
  label: string,
  language: Extension,
): void {
  const root = host.shadowRoot ?? host.attachShadow({ mode: "open" });
  const place = document.createElement("div");
  root.replaceChildren(place);
  const extensions = [
    unifiedMergeView({ original: former, mergeControls: false, gutter: false }),
    EditorView.lineWrapping,
    EditorState.readOnly.of(true),
    EditorView.contentAttributes.of({ "aria-label": label, tabindex: "0" }),
    language,
    editorTheme,
    look,
  ];
  const state = EditorState.create({ doc: later, extensions });
  new EditorView({ state, parent: place, root });
}
