/** What bundle/computed.mjs finds out while it bundles. */

declare module "computed:letter-widths" {
  /** From a character to thousandths of an em. */
  type Widths = Readonly<Record<string, number>>;
  const widths: { readonly regular: Widths; readonly bold: Widths };
  export default widths;
}

declare module "computed:plot-vocabulary" {
  /** bundle/plot-vocabulary.mjs says what these are. */
  interface State {
    readonly kinds: string;
    readonly words?: readonly string[];
    readonly keys?: Readonly<Record<string, number>>;
    readonly rest?: number;
    readonly items?: number;
  }
  const vocabulary: {
    readonly elsewhere: Readonly<Record<string, string>>;
    readonly states: readonly State[];
  };
  export default vocabulary;
}
