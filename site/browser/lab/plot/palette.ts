/** The colours of a plot as its canvas needs them, which knows no CSS variables: asked of the page's
 * styles, and kept until the page's colours change. */
import { onThemeChange } from "../page/theme-watch.js";

interface Colours {
  readonly text: string;
  readonly line: string;
  readonly curves: readonly string[];
}

export class Palette {
  readonly #plot: Element;
  readonly #curves: readonly Element[];
  #known: Colours | undefined;

  /** `curves` are elements with the stroke of each; `changed` is called when all are to be asked
   * again. */
  constructor(plot: Element, curves: readonly Element[], changed: () => void) {
    this.#plot = plot;
    this.#curves = curves;
    onThemeChange(() => {
      this.#known = undefined;
      changed();
    });
  }

  get colours(): Colours {
    return (this.#known ??= this.#ask());
  }

  #ask(): Colours {
    const { color, borderBlockStartColor } = getComputedStyle(this.#plot);
    const curves = this.#curves.map((curve) => getComputedStyle(curve).stroke);
    return { text: color, line: borderBlockStartColor, curves };
  }
}
