/** Pushing a body by words in place of the mouse: which, where to, how hard. On a touch screen the
 * same form makes a drag pull in place of turning the view. */
import type { Player } from "../live/player.js";
import { make } from "../markup/element.js";
import { type Body, movableBodies, push } from "./push.js";

const directions: Readonly<Record<string, readonly [number, number, number]>> = {
  "+x": [1, 0, 0],
  "−x": [-1, 0, 0],
  "+y": [0, 1, 0],
  "−y": [0, -1, 0],
  "+z (up)": [0, 0, 1],
  "−z (down)": [0, 0, -1],
};

export class PushForm {
  readonly element: HTMLFormElement;
  /** Opens and shuts the form. */
  readonly opener = make(
    "button",
    { type: "button", class: "menu-opener", "aria-expanded": "false" },
    "push",
  );
  readonly #player: Player;
  readonly #bodies = make("select");
  readonly #direction = make("select");
  readonly #force = make("input", { type: "number", min: 0, step: "any", value: 10 });
  readonly #dragging = make("input", { type: "checkbox" });

  constructor(player: Player) {
    this.#player = player;
    this.#direction.append(...Object.keys(directions).map((name) => make("option", {}, name)));
    this.element = make(
      "form",
      { class: "push-form", hidden: true },
      make("label", {}, "Body", this.#bodies),
      make("label", {}, "Direction", this.#direction),
      make("label", {}, "Force", this.#force, "N for 0.1 s"),
      make("button", { class: "lab-button" }, "Push"),
      make("label", { class: "lab-check" }, this.#dragging, "A drag on the view pulls bodies"),
    );
    this.element.addEventListener("submit", (event) => {
      event.preventDefault();
      this.#push();
    });
    this.opener.addEventListener("click", () => this.#open(this.element.hidden !== false));
    this.offerBodies();
  }

  /** Whether a drag pulls. */
  get pulling(): boolean {
    return this.#dragging.checked && !this.element.hidden;
  }

  /** Of the model as it is now. */
  offerBodies(): void {
    const bodies: readonly Body[] = movableBodies(this.#player.run);
    this.#bodies.replaceChildren(
      ...bodies.map(({ id, name }) => make("option", { value: id }, name)),
    );
    this.opener.hidden = bodies.length === 0;
  }

  #open(open: boolean): void {
    this.element.hidden = !open;
    this.opener.ariaExpanded = String(open);
  }

  #push(): void {
    const newtons = this.#force.valueAsNumber;
    const [x, y, z] = directions[this.#direction.value]!;
    if (!Number.isFinite(newtons)) return;
    push(this.#player.run, Number(this.#bodies.value), [newtons * x, newtons * y, newtons * z]);
    this.#player.play();
  }
}
