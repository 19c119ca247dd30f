/**
 * The live view in the poster's place: the same size, the same camera. It draws the run when it is
 * asked to, and lets the reader move the camera and pull at bodies.
 */
import type { Action } from "../../engine/scene.js";
import type { Player } from "../live/player.js";
import { make, newId } from "../markup/element.js";
import type { Stage } from "../stage/stage.js";
import { View } from "../stage/view.js";
import { Pointer, type PointerTarget } from "./pointer.js";
import { type Preset, presets, seenFrom } from "./presets.js";

/** Milliseconds without a turn of the wheel, after which a turn is a new one. */
const wheelPause = 400;
const hintTime = 1600;
/** A hint is given twice and no more. */
let hintsLeft = 2;

export class ViewPanel implements PointerTarget {
  readonly canvas: HTMLCanvasElement;
  /** Whether a drag pulls bodies; the push form knows. */
  pulls: () => boolean = () => false;
  readonly #player: Player;
  readonly #view: View;
  readonly #leaving = new AbortController();
  readonly #hint = make("p", { class: "lab-hint", "aria-hidden": "true" });
  #preset: Preset = presets[0];
  #playsForPull = false;
  #lastWheel = 0;

  constructor(place: Element, stage: Stage, player: Player) {
    this.#player = player;
    const { lab, simulation, scene } = player.run;
    const id = newId();
    const picture = place.querySelector("picture")!;
    const atRest = picture.querySelector("img")!.alt;
    const words = "Arrow keys turn it, with Shift they move it; plus and minus zoom.";
    const described = make("span", { id, class: "unseen" }, `At rest: ${atRest} ${words}`);
    const attributes = { role: "application", tabindex: 0, "aria-describedby": id };
    this.canvas = make("canvas", { ...attributes, "aria-label": `3D view: ${lab.title}` });
    picture.after(this.canvas, described, this.#hint);
    if (lab.ghost) {
      this.#hint.after(make("p", { class: "ghost-legend" }, `shadow: ${lab.ghost.label}`));
    }
    this.#view = new View(stage, this.canvas, simulation, scene);
    new Pointer(this.canvas, this);
    new ResizeObserver(() => player.changed()).observe(this.canvas);
    const { signal } = this.#leaving;
    const turned = (): void => void (this.#lastWheel = performance.now());
    addEventListener("wheel", turned, { passive: true, signal });
  }

  /** Gives back what the graphics card has of it. */
  close(): void {
    this.#leaving.abort();
    this.#view.dispose();
  }

  draw(): void {
    const { visualization, ghost } = this.#player.run;
    visualization.update();
    this.#view.draw(ghost?.scene);
  }

  /** The model was edited. */
  replace(): void {
    const { simulation, scene } = this.#player.run;
    this.#view.replace(simulation, scene);
  }

  get pushing(): boolean {
    return this.pulls();
  }

  moveCamera(action: Action, dx: number, dy: number): void {
    this.#player.run.visualization.moveCamera(action, dx, dy);
    this.#player.changed();
  }

  lookFrom(preset: Preset): void {
    const { run } = this.#player;
    this.#preset = preset;
    run.visualization.camera = seenFrom(run.lab.camera, preset);
    this.#player.changed();
  }

  nextPreset(): void {
    this.lookFrom(presets[(presets.indexOf(this.#preset) + 1) % presets.length]!);
  }

  home(): void {
    this.lookFrom(presets[0]);
  }

  /** Time goes on as long as the reader pulls. */
  grab(x: number, y: number): boolean {
    const { run, playing } = this.#player;
    const { clientWidth, clientHeight } = this.canvas;
    if (run.visualization.select(clientWidth / clientHeight, x, 1 - y) === 0) return false;
    run.hold("pull");
    this.#playsForPull = !playing;
    this.#player.play();
    return true;
  }

  drag(dx: number, dy: number): void {
    this.#player.run.visualization.drag("moveVertical", dx, dy);
  }

  release(): void {
    this.#player.run.hold("none");
    if (this.#playsForPull) this.#player.pause();
  }

  wheelPassed(): void {
    if (performance.now() - this.#lastWheel < wheelPause || hintsLeft === 0) return;
    hintsLeft--;
    const key = navigator.userAgent.includes("Mac") ? "⌘" : "Ctrl";
    this.#hint.textContent = `Hold ${key} to zoom, or click the view first`;
    setTimeout(() => (this.#hint.textContent = ""), hintTime);
  }
}
