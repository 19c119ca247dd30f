/**
 * The one place of the page where WebGL draws: browsers give a page few contexts, and a lesson may
 * have many labs. Stage.open() makes it; each lab's View (view.ts) draws on it in turn, and copies
 * the picture to its own canvas at once.
 */
import { setConsoleFunction, WebGLRenderer } from "three";

import { Shadows } from "./shadows.js";
import type { Frame } from "./show.js";
import type { TextureLimits } from "./textures.js";

/** The browser does not draw with WebGL 2: labs stay pictures. */
export class StageError extends Error {
  override readonly name = "StageError";
}

export class Stage {
  /** The context is lost, say because the computer slept: nothing is drawn until it is back. */
  onLost: () => void = () => undefined;
  onRestored: () => void = () => undefined;
  /** @internal */
  readonly shadows = new Shadows();
  /** @internal */
  readonly limits: TextureLimits;

  private constructor(private readonly renderer: WebGLRenderer) {
    const { maxTextureSize, maxCubemapSize } = renderer.capabilities;
    this.limits = { flat: maxTextureSize, cube: maxCubemapSize };
    renderer.autoClear = false;
    renderer.domElement.addEventListener("webglcontextlost", this.lose);
    renderer.domElement.addEventListener("webglcontextrestored", this.restore);
  }

  /** Throws a StageError. */
  static open(): Stage {
    // What three.js says of a lost context is not for the console: it is mended.
    setConsoleFunction((type, ...words) => {
      if (type !== "log") console[type](...words);
    });
    const canvas = document.createElement("canvas");
    const options = { antialias: true, stencil: true } as const;
    const context = canvas.getContext("webgl2", { ...options, alpha: false });
    if (context === null) throw new StageError("this browser has no WebGL 2");
    return new Stage(new WebGLRenderer({ canvas, context, ...options }));
  }

  get lost(): boolean {
    return this.renderer.getContext().isContextLost();
  }

  dispose(): void {
    const { renderer } = this;
    renderer.domElement.removeEventListener("webglcontextlost", this.lose);
    renderer.domElement.removeEventListener("webglcontextrestored", this.restore);
    this.shadows.dispose();
    renderer.dispose();
    renderer.forceContextLoss();
  }

  /** Has `draw` draw a picture of the size of `frame` at the lower left of the stage's canvas, and
   * copies it to `to`. */
  show(frame: Frame, to: CanvasRenderingContext2D, draw: (renderer: WebGLRenderer) => void): void {
    const { renderer } = this;
    const { domElement: canvas } = renderer;
    const { width, height } = frame;
    if (canvas.width < width || canvas.height < height) {
      // It only grows: labs of several sizes take turns.
      renderer.setSize(Math.max(canvas.width, width), Math.max(canvas.height, height), false);
    }
    draw(renderer);
    to.drawImage(canvas, 0, canvas.height - height, width, height, 0, 0, width, height);
  }

  private readonly lose = () => this.onLost();
  private readonly restore = () => this.onRestored();
}
