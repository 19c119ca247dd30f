/**
 * What one lab shows: MuJoCo's own list of geoms, drawn as MuJoCo's own renderer draws it, so that
 * it agrees with the picture that the generator made. Neither draws fog.
 */
import type { Scene } from "../../engine/scene.js";
import type { Simulation } from "../../engine/simulation.js";
import { writeLabels } from "./labels.js";
import { type Frame, Show } from "./show.js";
import type { Stage } from "./stage.js";

/** More pixels than these for each of the page's are not seen, and cost. */
const highestDensity = 2;

export class View {
  private readonly context: CanvasRenderingContext2D;
  private show: Show;

  /** The canvas is a 2D canvas: the stage draws, and the picture is copied. */
  constructor(
    private readonly stage: Stage,
    private readonly canvas: HTMLCanvasElement,
    simulation: Simulation,
    private scene: Scene,
  ) {
    this.context = canvas.getContext("2d")!;
    this.show = new Show(simulation, stage.shadows, stage.limits);
  }

  /**
   * Draws the scene, which is up to date, at the canvas's present size; `ghost` as its pale shadow.
   * While the stage is lost the canvas keeps its last picture.
   */
  draw(ghost?: Scene): void {
    const { stage, context, show, scene } = this;
    const frame = this.frame();
    if (stage.lost || frame.width === 0 || frame.height === 0) return;
    this.fit(frame);
    stage.show(frame, context, (renderer) => show.draw(renderer, frame, scene, ghost));
    writeLabels(context, frame, scene.geoms, show.eye.camera);
  }

  /** After another model was compiled. */
  replace(simulation: Simulation, scene: Scene): void {
    this.show.dispose();
    this.show = new Show(simulation, this.stage.shadows, this.stage.limits);
    this.scene = scene;
  }

  dispose(): void {
    this.show.dispose();
  }

  private frame(): Frame {
    const { clientWidth, clientHeight } = this.canvas;
    const fits = this.stage.limits.flat / Math.max(clientWidth, clientHeight);
    const density = Math.min(devicePixelRatio, highestDensity, fits);
    return {
      width: Math.round(clientWidth * density),
      height: Math.round(clientHeight * density),
      density,
    };
  }

  /** To set a size empties a canvas, so only another one is set. */
  private fit({ width, height }: Frame): void {
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
  }
}
