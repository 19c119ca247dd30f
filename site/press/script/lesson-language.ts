/**
 * Lessons, for highlight.js: Markdown whose fences are set in the language that they hold, and whose
 * formulas are left alone, since to Markdown their underscores are emphasis.
 */
import type { LanguageFn, Mode } from "highlight.js";
import markdown from "highlight.js/lib/languages/markdown";

const fence = (kind: string, language: string): Mode => ({
  begin: new RegExp(`^(?:\`{3,}|~{3,})(?:${kind})\\b.*\\n`),
  beginScope: "meta",
  end: /^(?:`{3,}|~{3,})$/,
  endScope: "meta",
  subLanguage: language,
});

/** As Pandoc has it: no space inside of the dollars, no digit behind the second, `\\$` is none. */
const formula: Mode = {
  scope: "string",
  match: /\$\$[^$]+\$\$|\$(?![\s$])(?:\\.|[^\\$\n])*?(?:\\.|[^\\$\s])\$(?!\d)/,
};

export const lesson: LanguageFn = (hljs) => {
  const language = markdown(hljs);
  const ours = [
    fence("cpp", "cpp"),
    fence("xml", "xml"),
    fence("lab|quiz|figure|plot", "json"),
    fence("text|io", "plaintext"),
    formula,
  ];
  // A callout is a quote, and as much a part of the text as any other.
  const theirs = language.contains.filter((mode) => mode.className !== "quote");
  return { ...language, name: "Lesson", contains: [...ours, ...theirs] };
};
