/** The buttons beside a lab's title: Play while the lab is a sheet, the sheet's own, whole screen. */
import { make } from "../markup/element.js";
import { iconButton, rename } from "../markup/icon-button.js";
import type { Player } from "./player.js";
import { Sheet } from "./sheet.js";

export class Head {
  readonly #lab: HTMLElement;
  readonly #player: Player;
  readonly #sheet: Sheet | undefined;
  readonly #play: HTMLButtonElement;

  constructor(lab: HTMLElement, player: Player) {
    this.#lab = lab;
    this.#player = player;
    const figure = lab.querySelector("figure")!;
    this.#sheet = lab.classList.contains("dock") ? new Sheet(lab, figure) : undefined;
    this.#play = iconButton({
      name: "Play",
      icon: "play",
      classes: "sheet-button",
      act: () => this.#playInSheet(),
    });
    const whole = iconButton({
      name: "Whole screen",
      icon: "whole",
      keys: "F",
      classes: "whole-button",
      act: () => this.fillScreen(),
    });
    whole.hidden = !document.fullscreenEnabled;
    const sheet = this.#sheet ? [this.#play, ...this.#sheet.buttons] : [];
    figure.prepend(make("div", { class: "lab-tools" }, whole, ...sheet));
  }

  refresh(): void {
    const { playing } = this.#player;
    rename(this.#play, playing ? "Pause" : "Play", playing ? "pause" : "play");
  }

  /** And back. */
  fillScreen(): void {
    if (!document.fullscreenEnabled) return;
    if (document.fullscreenElement === this.#lab) void document.exitFullscreen();
    else void this.#lab.requestFullscreen();
  }

  /** What plays is seen. */
  #playInSheet(): void {
    if (this.#sheet!.folded) this.#sheet!.fold(false);
    this.#player.toggle();
  }
}
