/** The way from a lab's state to an address and back. One address speaks of one lab of the page. */
import { decodeLink, encodeLink, headOf, type LabLink, type LinkHead } from "../run/lab-link.js";
import type { Player } from "./player.js";

const parameter = "lab";

export class LabAddress {
  readonly #id: string;
  readonly #player: Player;

  constructor(id: string, player: Player) {
    this.#id = id;
    this.#player = player;
  }

  /** The page's address that brings the lab as it is now; `edited` tells whether its model was.
   * Undefined when that would be longer than servers take. */
  async href(edited: boolean): Promise<string | undefined> {
    const { run, speed } = this.#player;
    const value = await encodeLink({
      id: this.#id,
      camera: run.visualization.camera,
      overlays: [...run.visualization.overlays],
      speed,
      run: run.state,
      ...(edited ? { mjcf: run.mjcf } : {}),
    });
    if (value === undefined) return undefined;
    const address = new URL(location.href);
    address.searchParams.set(parameter, value);
    address.hash = this.#id;
    return address.href;
  }

  /** What the page's address says that it brings to this lab; undefined for nothing. */
  get head(): LinkHead | undefined {
    const head = headOf(this.#value);
    return head?.id === this.#id ? head : undefined;
  }

  /** What it brings; undefined where that cannot be read. */
  read(): Promise<LabLink | undefined> {
    return decodeLink(this.#value);
  }

  /** Brings back what `link` says of this lab. `replace` edits the model. */
  async restore(link: LabLink, replace: (mjcf: string) => Promise<void>): Promise<void> {
    const { run } = this.#player;
    if (link.mjcf !== undefined) await replace(link.mjcf);
    if (link.run) run.restore(link.run);
    if (link.camera) run.visualization.camera = link.camera;
    if (link.overlays) run.visualization.overlays = link.overlays;
    this.#player.speed = link.speed ?? run.lab.speed;
  }

  /** The address speaks of no lab any more. */
  forget(): void {
    const address = new URL(location.href);
    if (!address.searchParams.has(parameter)) return;
    address.searchParams.delete(parameter);
    history.replaceState(history.state, "", address);
  }

  get #value(): string {
    return new URL(location.href).searchParams.get(parameter) ?? "";
  }
}
