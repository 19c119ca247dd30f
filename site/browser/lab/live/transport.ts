/** The row under the view: play, step, scrub, time, speed. */
import { make, setText } from "../markup/element.js";
import { iconButton, rename } from "../markup/icon-button.js";
import { fixed } from "../run/fixed.js";
import type { Player } from "./player.js";

const speeds = [0.1, 0.25, 0.5, 1, 2, 4];

export class Transport {
  readonly element: HTMLElement;
  readonly playButton: HTMLButtonElement;
  readonly #player: Player;
  readonly #scrub = make("input", { type: "range", class: "scrub", min: 0, max: 0, value: 0 });
  readonly #time = make("span", { class: "lab-time" });
  readonly #speed = make("select", {
    class: "lab-speed",
    "aria-label": "Speed",
    "aria-keyshortcuts": "[ ]",
  });
  readonly #rate = make("span", { class: "lab-rate" });

  constructor(player: Player) {
    this.#player = player;
    this.playButton = iconButton({
      name: "Play",
      icon: "play",
      keys: "Space K",
      act: () => player.toggle(),
    });
    this.#scrub.ariaLabel = "Rewind";
    this.#scrub.addEventListener("input", () => player.seek(this.#scrub.valueAsNumber));
    this.#offer(speeds);
    this.#speed.addEventListener("change", () => (player.speed = Number(this.#speed.value)));
    const moves = make("div", { class: "lab-moves" }, ...this.#moves());
    const row = { class: "lab-transport", role: "group", "aria-label": "Time" };
    this.element = make("div", row, moves, this.#scrub, this.#time, this.#rate, this.#speed);
  }

  refresh(): void {
    const { run, playing, speed } = this.#player;
    rename(this.playButton, playing ? "Pause" : "Play", playing ? "pause" : "play");
    const time = `${fixed(run.time, 3)} s`;
    setText(this.#time, time);
    this.#scrub.max = String(Math.max(0, run.history.length - 1));
    this.#scrub.value = String(run.history.index);
    // What is heard with each change, so only where the reader makes the changes.
    if (!playing) this.#scrub.setAttribute("aria-valuetext", time);
    if (Number(this.#speed.value) !== speed) this.#offer([...new Set([...speeds, speed])]);
    this.#sayRate(playing);
  }

  /** The next slower or faster speed. */
  shiftSpeed(by: 1 | -1): void {
    const all = [...this.#speed.options].map(({ value }) => Number(value));
    const next = all[all.indexOf(this.#player.speed) + by];
    if (next !== undefined) this.#player.speed = next;
  }

  #moves(): HTMLButtonElement[] {
    const player = this.#player;
    return [
      iconButton({
        name: "Back to the start",
        icon: "back",
        keys: "0 Home",
        act: () => player.reset(),
      }),
      this.playButton,
      iconButton({ name: "One step", icon: "step", keys: ".", act: () => player.step(1) }),
      iconButton({ name: "Ten steps", icon: "steps", keys: ">", act: () => player.step(10) }),
    ];
  }

  #offer(offered: readonly number[]): void {
    const { speed } = this.#player;
    const options = offered
      .toSorted((a, b) => a - b)
      .map((value) => {
        const option = make("option", { value }, `${value}×`);
        option.selected = value === speed;
        return option;
      });
    this.#speed.replaceChildren(...options);
  }

  #sayRate(playing: boolean): void {
    const [measured = "", slow] = this.#player.rate.split(" — ");
    setText(
      this.#rate,
      playing ? (slow === undefined ? `at ${measured}` : `only ${measured}`) : "",
    );
    this.#rate.classList.toggle("slow", playing && slow !== undefined);
    this.#rate.title = slow ?? "";
  }
}
