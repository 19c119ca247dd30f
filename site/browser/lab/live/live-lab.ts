/**
 * A lab that is live: the live view over the poster, and the panel in the place of what the page says
 * of the lab before that, which stays for print. Everything follows one Player.
 */
import { make } from "../markup/element.js";
import { menu, popup } from "../markup/menu.js";
import { copyMenu } from "../panel/copy-menu.js";
import { LinkOffer } from "../panel/link-offer.js";
import { TroubleBox } from "../panel/trouble-box.js";
import type { LabLink } from "../run/lab-link.js";
import type { Run } from "../run/run.js";
import type { Stage } from "../stage/stage.js";
import { presets } from "../view/presets.js";
import { ViewPanel } from "../view/view-panel.js";
import { Head } from "./head.js";
import { listenToKeys } from "./keys.js";
import { LabAddress } from "./lab-address.js";
import { Panel } from "./panel.js";
import { type Follower, Player } from "./player.js";
import { everywhere, inView, listOf } from "./shortcuts.js";
import { Transport } from "./transport.js";

export class LiveLab implements Follower {
  readonly #lab: HTMLElement;
  readonly #player: Player;
  readonly #view: ViewPanel;
  readonly #transport: Transport;
  readonly #head: Head;
  readonly #trouble = new TroubleBox();
  readonly #panel: Panel;
  readonly #address: LabAddress;
  readonly #closed: () => void;
  #offer: LinkOffer | undefined;

  /** `closed` is called when it has left the page. */
  constructor(lab: HTMLElement, run: Run, stage: Stage, closed: () => void) {
    const place = lab.querySelector<HTMLElement>(".lab-view")!;
    this.#lab = lab;
    this.#closed = closed;
    this.#player = new Player(run, place, this);
    this.#view = new ViewPanel(place, stage, this.#player);
    this.#transport = new Transport(this.#player);
    this.#head = new Head(lab, this.#player);
    this.#address = new LabAddress(lab.id, this.#player);
    const menus = this.#menus(run);
    this.#panel = new Panel(this.#player, menus.row, () => this.#rebuilt());
    this.#view.pulls = () => this.#panel.push.pulling;
    this.#panel.element.append(...menus.below);
    this.#show(place);
  }

  /** The reader's first Play, on the poster. */
  play(): void {
    this.#transport.playButton.focus();
    this.#player.play();
  }

  /** Gives back what it has, and leaves the page. */
  close(): void {
    this.#player.close();
    this.#view.close();
    this.#player.run.free();
    this.#lab.remove();
    this.#closed();
  }

  /** The browser took the 3D view away, or gave it back. */
  viewLost(lost: boolean): void {
    const words = "The browser has taken the 3D view away; it is drawn again when it comes back.";
    this.#lab.querySelector(".lab-status")!.textContent = lost ? words : "";
    this.#player.changed();
  }

  draw(): void {
    this.#view.draw();
  }

  refresh(): void {
    const { run, playing } = this.#player;
    if (playing) this.#lab.querySelector("button.lab-play")?.remove();
    this.#transport.refresh();
    this.#head.refresh();
    this.#trouble.show(run.trouble, run.readingTrouble);
    this.#panel.refresh();
  }

  /** Asks the reader about what the page's address brings to this lab, if it does. `fault` tries it, and
   * gives why it is not to be loaded. */
  offerLink(fault: (link: LabLink, signal: AbortSignal) => Promise<string | undefined>): void {
    const { head } = this.#address;
    if (!head) return;
    const load = async (signal: AbortSignal): Promise<string | undefined> => {
      const link = await this.#address.read();
      if (!link) return "its text cannot be read, and may have been cut off";
      const refused = await fault(link, signal);
      if (refused !== undefined || signal.aborted) return refused;
      await this.#address.restore(link, async (mjcf) => this.#panel.edit?.replace(mjcf));
      this.#transport.playButton.focus();
      return undefined;
    };
    const mjcfBytes = this.#panel.edit ? head.mjcfBytes : 0; // no other model is taken
    this.#offer = new LinkOffer({ ...head, mjcfBytes }, load, () => {
      this.#address.forget();
      this.#transport.playButton.focus();
    });
    this.#lab.querySelector(".lab-view")!.after(this.#offer.element);
  }

  /** As the lesson gave it: state, controls, camera, overlays, speed, model; and no link. */
  async restoreLesson(): Promise<void> {
    const { run } = this.#player;
    await this.#panel.edit?.restoreLesson();
    this.#player.reset();
    this.#view.home();
    run.visualization.overlays = run.lab.overlays;
    this.#player.speed = run.lab.speed;
    this.#offer?.close();
    this.#address.forget();
  }

  /** Into the page, in one go. */
  #show(place: HTMLElement): void {
    this.#lab.querySelector(".lab-body")!.before(this.#panel.element);
    place.after(this.#transport.element, this.#trouble.element);
    this.#lab.dataset["live"] = "";
    this.#lab.style.setProperty("--view", `${place.offsetHeight}px`);
    this.#player.playWhileSeen(this.#transport.element, this.#panel.element);
    this.#player.changed();
  }

  #rebuilt(): void {
    this.#view.replace();
    this.#panel.push.offerBodies();
    this.#player.changed();
  }

  /** The openers of the menus, and what stands below them. */
  #menus(run: Run): { readonly row: Node[]; readonly below: Node[] } {
    const camera = menu(
      "camera",
      new Map(presets.map((preset) => [preset, () => this.#view.lookFrom(preset)])),
    );
    const copy = copyMenu(this.#lab, run, () =>
      this.#address.href(this.#panel.edit?.edited === true),
    );
    const title = "State, controls, camera, overlays, speed and model as they were at first";
    const back = make("button", { type: "button", class: "menu-opener", title }, "reset all");
    back.addEventListener("click", () => void this.restoreLesson());
    const keys = this.#keys();
    const menus = [camera, copy, keys];
    return {
      row: [camera.opener, copy.opener, keys.opener, back],
      below: [copy.answer, ...menus.map(({ popover }) => popover)],
    };
  }

  #keys() {
    const view = this.#view;
    const targets = {
      player: this.#player,
      transport: this.#transport,
      moveCamera: view.moveCamera.bind(view),
      nextView: () => view.nextPreset(),
      fillScreen: () => this.#head.fillScreen(),
      showKeys: () => keys.popover.togglePopover(),
    };
    const all = everywhere(targets);
    const alone = inView(targets);
    const keys = popup("keys", listOf([...all, ...alone]));
    keys.opener.setAttribute("aria-keyshortcuts", "?");
    listenToKeys(this.#lab, view.canvas, all, alone);
    return keys;
  }
}
