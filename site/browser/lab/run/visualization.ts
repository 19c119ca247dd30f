/**
 * What is drawn of a run, in MuJoCo's words its visualization: the scene of its simulation and of its
 * ghost's, the camera, the overlays, and the reader's hand that pulls at a body. Camera and overlays
 * outlive an edited model.
 */
import type { Action, Hold, Scene } from "../../engine/scene.js";
import type { Simulation } from "../../engine/simulation.js";
import type { CameraPlace } from "../lab-module.js";

/** What a lab begins with, or what there was before. */
export interface Look {
  readonly camera: CameraPlace;
  readonly overlays: Iterable<string>;
}

export class Visualization {
  readonly scene: Scene;
  readonly ghost: Scene | undefined;
  #selected = 0;
  #held = false;

  constructor(simulation: Simulation, ghost: Simulation | undefined, look: Look) {
    this.scene = simulation.openScene();
    this.ghost = ghost?.openScene();
    this.camera = look.camera;
    this.overlays = look.overlays;
    this.update();
  }

  /** Brings the scenes up to date; false when the simulation has stopped, and they are as before. */
  update(): boolean {
    this.ghost?.update();
    return this.scene.update();
  }

  /** Those that are shown; to be set, too. Names of overlays that there are not are passed over. */
  get overlays(): ReadonlySet<string> {
    return this.scene.shown;
  }
  set overlays(names: Iterable<string>) {
    const shown = new Set(names);
    for (const name of this.scene.overlays) this.scene.showOverlay(name, false);
    for (const name of this.scene.overlays) if (shown.has(name)) this.scene.showOverlay(name, true);
  }

  showOverlay(name: string, on: boolean): void {
    this.scene.showOverlay(name, on);
  }

  get camera(): CameraPlace {
    const { azimuth, elevation, distance, lookat } = this.scene.camera.numbers;
    const [x, y, z] = lookat!;
    return {
      azimuth: azimuth![0]!,
      elevation: elevation![0]!,
      distance: distance![0]!,
      target: [x!, y!, z!],
    };
  }
  set camera({ azimuth, elevation, distance, target }: CameraPlace) {
    const { numbers } = this.scene.camera;
    numbers["azimuth"]![0] = azimuth;
    numbers["elevation"]![0] = elevation;
    numbers["distance"]![0] = distance;
    numbers["lookat"]!.set(target);
  }

  /** `dx` and `dy` are parts of the window's height. */
  moveCamera(action: Action, dx: number, dy: number): void {
    this.scene.moveCamera(action, dx, dy);
  }

  /** Selects the body that is seen at (x, y), 0 to 1 from the lower left; 0 when there is none. */
  select(aspect: number, x: number, y: number): number {
    this.#selected = this.scene.select(aspect, x, y);
    return this.#selected;
  }

  /** Takes the selected body by the hand, or lets go of it. */
  hold(hold: Hold): void {
    const held = hold !== "none" && this.#selected > 0;
    this.scene.hold(held ? hold : "none");
    // once more without a hand, so that the force is gone
    if (this.#held && !held) this.scene.pull();
    this.#held = held;
  }

  drag(action: Action, dx: number, dy: number): void {
    this.scene.drag(action, dx, dy);
  }

  /** The body that is held, 0 for none. */
  get held(): number {
    return this.#held ? this.#selected : 0;
  }

  /** Before each step while a body is held: the hand's force. */
  pull(): void {
    this.scene.pull();
  }
}
