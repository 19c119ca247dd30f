/**
 * On a narrow screen a docked lab stays at hand once it was scrolled past: as a sheet at the bottom of
 * the window, folded to a bar until the reader unfolds it (lab-sheet.css). The place in the text stays
 * as high as it was, so nothing in the text moves.
 */
import { iconButton, rename } from "../markup/icon-button.js";

const narrow = "(width < 1100px)";

export class Sheet {
  readonly buttons: readonly HTMLButtonElement[];
  readonly #lab: HTMLElement;
  readonly #figure: HTMLElement;
  readonly #fold: HTMLButtonElement;
  readonly #narrow = matchMedia(narrow);
  /** The lab's place in the text is above the window. */
  #past = false;
  #closed = false;

  constructor(lab: HTMLElement, figure: HTMLElement) {
    this.#lab = lab;
    this.#figure = figure;
    const classes = "sheet-button";
    this.#fold = iconButton({
      name: "Unfold the lab",
      icon: "unfold",
      classes,
      act: () => this.fold(!this.folded),
    });
    const close = iconButton({
      name: "Close the sheet",
      icon: "close",
      classes,
      act: () => this.#close(),
    });
    this.buttons = [this.#fold, close];
    new IntersectionObserver(([entry]) => {
      this.#past = !entry!.isIntersecting && entry!.boundingClientRect.bottom < 0;
      if (!this.#past) this.#closed = false;
      this.#update();
    }).observe(lab);
    new ResizeObserver(() => this.#keepRoom()).observe(figure);
    this.#narrow.addEventListener("change", () => this.#update());
  }

  get folded(): boolean {
    return this.#lab.matches(".sheet.folded");
  }

  fold(folded: boolean): void {
    this.#lab.classList.toggle("folded", folded);
    rename(this.#fold, folded ? "Unfold the lab" : "Fold the lab", folded ? "unfold" : "fold");
    this.#fold.ariaExpanded = String(!folded);
  }

  #close(): void {
    this.#closed = true;
    this.#update();
  }

  #update(): void {
    const { style, classList } = this.#lab;
    const up = this.#past && !this.#closed && this.#narrow.matches;
    if (up === classList.contains("sheet")) return;
    style.blockSize = up ? `${this.#lab.getBoundingClientRect().height}px` : "";
    classList.toggle("sheet", up);
    this.fold(true);
    this.#keepRoom();
  }

  /** What the page leaves free at its end, and around what gets the focus. */
  #keepRoom(): void {
    const up = this.#lab.classList.contains("sheet");
    const height = up ? `${this.#figure.getBoundingClientRect().height}px` : "";
    document.documentElement.style.setProperty("--sheet", height);
  }
}
