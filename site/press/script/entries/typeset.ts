/** KaTeX: `typeset(tex, display, macros)` gives `{html}`, or `{message, offset, length, cure}`. */
import katex from "katex";

import { bytes } from "../bytes.js";
import { boundExpansion, tooLong } from "../expansion.js";

/** `display` is "true" or "false"; `macros` is JSON from `\name` to TeX; so is the answer JSON. */
function typeset(tex: string, display: string, macros: string): string {
  const options = {
    displayMode: display === "true",
    macros: { ...refuseCommands(tex), ...(JSON.parse(macros) as Record<string, string>) },
    output: "htmlAndMathml",
    throwOnError: true,
    strict: "error",
    trust: false,
  } as const;
  try {
    return JSON.stringify({ html: katex.renderToString(tex, options) });
  } catch (error) {
    if (!(error instanceof katex.ParseError)) throw error;
    return JSON.stringify(describe(tex, error, options.macros));
  }
}

type Macros = Record<string, string | (() => string)>;

/**
 * What KaTeX sets in red instead of a refusal, since it leads out of the formula or makes HTML, and
 * what the lesson has for it.
 */
const untrusted: Record<string, string> = {
  "\\href": "a link is Markdown: `[text](https://…)`",
  "\\url": "a link is Markdown: `<https://…>`",
  "\\includegraphics": "a picture is Markdown: `![what it shows](picture.png)`",
  "\\htmlClass": "colour it with `\\textcolor{…}{…}`, or leave it out",
  "\\htmlData": "leave it out",
  "\\htmlId": "to link to a place, give it a heading: `[text](#its-words)`",
  "\\htmlStyle": "colour it with `\\textcolor{…}{…}`, or leave it out",
};

const labels =
  "write a number, `\\tag{1}` within `$$`, and speak of it as (1); to link there, give it a heading";

/** What LaTeX has for a whole document, and a lesson otherwise. */
const documents: Record<string, string> = {
  "\\label": labels,
  "\\ref": labels,
  "\\eqref": labels,
  "\\cref": labels,
  "\\autoref": labels,
  "\\cite": "write a link, `[text](https://…)`, or a footnote, `[^name]`, behind the formula",
  "\\footnote": "write a footnote, `[^name]`, behind the formula",
};

/** Macros that throw a ParseError in place of the commands of `untrusted`. */
function refuseCommands(tex: string): Macros {
  const refuse = (name: string) => () => {
    const start = tex.search(new RegExp(`\\${name}(?![A-Za-z@])`));
    const token = { loc: { lexer: { input: tex }, start, end: start + name.length } };
    const refusal: Error = new katex.ParseError(
      `Refused command: ${name}`,
      start < 0 ? undefined : token,
    );
    throw refusal;
  };
  return Object.fromEntries(Object.keys(untrusted).map((name) => [name, refuse(name)]));
}

/** What KaTeX's error has beyond its published type. */
interface ParseError {
  readonly rawMessage: string;
  /** In UTF-16 units; undefined when KaTeX does not know. */
  readonly position?: number;
  readonly length?: number;
}

function describe(tex: string, error: ParseError, macros: Macros) {
  const unknown = /^(?:Undefined control sequence|Refused command): (\\.*)$/.exec(
    error.rawMessage,
  )?.[1];
  let { position = 0, length = 0 } = error;
  // a command out of a macro's text is placed in that text, which the author does not see here
  if (unknown !== undefined && !tex.startsWith(unknown, position)) [position, length] = [0, 0];
  return {
    message: whole(error.rawMessage, tex, position)
      .replace("LaTeX-incompatible input and strict mode is set to 'error': ", "not LaTeX: ")
      .replace(/ \[\w+\]$/, "")
      .replace(
        /^Refused command: (.*)$/,
        "`$1` is not for formulas, as it makes HTML or leads elsewhere",
      )
      .replace(/(Unrecognized Unicode character .*) \(\d+\)$/, "$1"),
    offset: bytes(tex.slice(0, position)),
    length: bytes(tex.slice(position, position + length)),
    cure: cureOf(error.rawMessage, unknown, macros),
  };
}

function cureOf(message: string, unknown: string | undefined, macros: Macros): string {
  if (message === tooLong) return "shorten its macros, or make several formulas of it";
  return unknown === undefined ? "" : suggestCommand(unknown, macros);
}

/** KaTeX names characters beyond U+FFFF by their first half alone. */
function whole(message: string, tex: string, position: number): string {
  return message.replace(/\p{Surrogate}/gu, (half) =>
    tex.startsWith(half, position) ? String.fromCodePoint(tex.codePointAt(position)!) : "\ufffd",
  );
}

/** Nobody misspells a longer name, and its slips are many. */
const mostMeant = 40;

/** The command that differs by one slip of the fingers. KaTeX has no list of its commands, but it
 * tells macros whether it knows one, so the slips are tried. */
function suggestCommand(name: string, macros: Macros): string {
  const other = untrusted[name] ?? documents[name];
  if (other !== undefined) return other;
  if (name.length > mostMeant) return "";
  let meant: string | undefined;
  const probe = (context: object) => {
    const { isDefined } = context as { isDefined: (this: object, name: string) => boolean };
    meant = slips(name.slice(1)).find((slip) => isDefined.call(context, `\\${slip}`));
    return "";
  };
  katex.renderToString("\\probe", { macros: { ...macros, "\\probe": probe } });
  return meant === undefined ? "" : `did you mean \`\\${meant}\`?`;
}

/** Names one edit away, likeliest first: letters swapped, one missing, one wrong, one too many. */
function slips(name: string): string[] {
  const letters = Array.from("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
  const places = Array.from({ length: name.length + 1 }, (_, place) => place);
  const replace = (place: number, count: number, text: string) =>
    name.slice(0, place) + text + name.slice(place + count);
  const inside = places.slice(0, -1);
  return [
    ...inside.map((place) => replace(place, 2, (name[place + 1] ?? "") + name[place]!)),
    ...places.flatMap((place) => letters.map((letter) => replace(place, 0, letter))),
    ...inside.flatMap((place) => letters.map((letter) => replace(place, 1, letter))),
    ...inside.map((place) => replace(place, 1, "")),
  ].filter((slip) => slip !== "" && slip !== name);
}

boundExpansion();
Object.assign(globalThis, { typeset });
