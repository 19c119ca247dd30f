/** The editor in the page's colours: its custom properties reach into the shadow root, and change
 * with the scheme. */
import { HighlightStyle, syntaxHighlighting } from "@codemirror/language";
import type { Extension } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { tags } from "@lezer/highlight";

const ring = { outline: "2px solid var(--accent)", outlineOffset: "-2px" };

const look = EditorView.theme({
  "&": {
    maxHeight: "min(28rem, 70dvh)",
    border: "1px solid var(--edge)",
    borderRadius: "4px",
    background: "var(--ground)",
    color: "var(--ink)",
    fontSize: "0.8125rem",
  },
  "&.cm-focused": ring,
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.55", scrollbarWidth: "thin" },
  ".cm-content": { caretColor: "var(--ink)" },
  ".cm-gutters": { border: "0", background: "transparent", color: "var(--soft)" },
  "& .cm-content ::selection, & .cm-content::selection": { background: "var(--selection)" },
  ".cm-selectionMatch, .cm-searchMatch": {
    outline: "1px solid var(--edge)",
    background: "transparent",
  },
  ".cm-searchMatch.cm-searchMatch-selected": { background: "var(--selection)" },
  "&.cm-focused .cm-matchingBracket": { background: "var(--selection)" },
  "&.cm-focused .cm-nonmatchingBracket": { background: "transparent", color: "var(--wrong)" },

  // what CodeMirror draws with data: images, which the page's policy refuses
  ".cm-lintRange-error": {
    background: "none",
    textDecoration: "underline wavy var(--wrong)",
    textDecorationSkipInk: "none",
  },
  ".cm-lintRange-warning": {
    background: "none",
    textDecoration: "underline wavy var(--asserted)",
    textDecorationSkipInk: "none",
  },
  ".cm-lintPoint-error:after": { borderBottomColor: "var(--wrong)" },
  ".cm-lintPoint-warning:after": { borderBottomColor: "var(--asserted)" },

  ".cm-tooltip, .cm-panels": {
    border: "1px solid var(--edge)",
    background: "var(--paper)",
    color: "var(--ink)",
    font: "var(--size-xs) / 1.45 var(--sans)",
  },
  ".cm-tooltip.cm-tooltip-autocomplete > ul > li[aria-selected]": {
    background: "var(--selection)",
    color: "var(--ink)",
  },
  ".cm-panels": { border: "0", borderBlockEnd: "1px solid var(--edge)" },
  ".cm-diagnostic-error": { borderInlineStart: "3px solid var(--wrong)" },
  ".cm-diagnostic-warning": { borderInlineStart: "3px solid var(--asserted)" },
  ".cm-panel.cm-panel-lint ul [aria-selected]": { background: "var(--selection)" },
  ".cm-textfield, .cm-button": {
    border: "1px solid var(--edge)",
    borderRadius: "3px",
    background: "var(--paper)",
    backgroundImage: "none",
    color: "inherit",
    font: "inherit",
  },
  ".cm-panel :focus-visible": ring,
});

/** What stands beside the editor, in the same shadow root. */
const hint = EditorView.baseTheme({
  "& + #hint": {
    margin: "0.25rem 0 0",
    color: "var(--soft)",
    font: "var(--size-xs) / 1.45 var(--sans)",
  },
});

/** As styles/highlight.css has it for XML and C++. */
const colours = HighlightStyle.define([
  { tag: tags.comment, color: "var(--code-comment)" },
  {
    tag: [tags.tagName, tags.processingInstruction, tags.keyword, tags.modifier],
    color: "var(--code-keyword)",
  },
  { tag: [tags.attributeName, tags.typeName], color: "var(--code-type)" },
  { tag: [tags.attributeValue, tags.character, tags.string], color: "var(--code-string)" },
  { tag: [tags.number, tags.bool, tags.null], color: "var(--code-number)" },
  { tag: tags.function(tags.definition(tags.variableName)), color: "var(--code-name)" },
  { tag: tags.invalid, color: "var(--wrong)" },
]);

export const editorTheme: Extension = [look, hint, syntaxHighlighting(colours)];
