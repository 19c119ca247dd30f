/**
 * How long a formula may become once its macros are written out.
 *
 * KaTeX counts how often a macro is expanded, not what comes of it: a macro of a thousand letters,
 * a thousand times, is a million of them, and KaTeX needs kilobytes for each. It has no option for
 * that, but gives macros that are functions its expander, whose methods are replaced here for all
 * formulas.
 */
import katex from "katex";

const mostTokens = 10_000;

/** The message of a formula that becomes longer. */
export const tooLong = `with its macros written out, this formula has more than ${mostTokens} letters and commands`;

interface Expansion {
  readonly tokens: readonly { readonly text: string }[];
  readonly numArgs: number;
}

/** Of KaTeX's MacroExpander, what is used here. */
interface Expander {
  _getExpansion: (this: Expander, name: string) => Expansion | null | undefined;
  consumeArgs: (this: Expander, count: number, delimiters?: string[][]) => unknown[][];
}

interface Written {
  tokens: number;
  /** How often the expansion at hand names an argument. */
  arguments: number;
}

/** Call once. From then on formulas that become too long throw a ParseError with `tooLong`. */
export function boundExpansion(): void {
  const expander = expanderPrototype();
  const { _getExpansion, consumeArgs } = expander;
  const written = new WeakMap<Expander, Written>();
  const add = (to: Written, tokens: number) => {
    to.tokens += tokens;
    if (to.tokens > mostTokens) throw new katex.ParseError(tooLong) as Error;
  };
  const of = (which: Expander) => {
    const known = written.get(which) ?? { tokens: 0, arguments: 0 };
    written.set(which, known);
    return known;
  };
  expander._getExpansion = function (name) {
    const expansion = _getExpansion.call(this, name);
    if (expansion) {
      const now = of(this);
      add(now, expansion.tokens.length);
      now.arguments = expansion.tokens.filter(({ text }) => text === "#").length;
    }
    return expansion;
  };
  // Called with an expansion before its arguments are put in, and by macros for themselves.
  expander.consumeArgs = function (count, delimiters) {
    const found = consumeArgs.call(this, count, delimiters);
    const now = of(this);
    add(now, now.arguments * Math.max(0, ...found.map((tokens) => tokens.length)));
    now.arguments = 0;
    return found;
  };
}

function expanderPrototype(): Expander {
  let prototype: Expander | undefined;
  const show = (context: object) => {
    prototype = Object.getPrototypeOf(context) as Expander;
    return "";
  };
  katex.renderToString("\\show", { macros: { "\\show": show } });
  return prototype!;
}
