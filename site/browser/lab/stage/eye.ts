/** Where MuJoCo's camera is and what it sees, as three.js draws it. */
import { Camera, Vector3 } from "three";

import type { Struct } from "../../engine/struct-layout.js";

export class Eye {
  readonly camera = new Camera();
  readonly position = new Vector3();
  readonly forward = new Vector3();
  private readonly up = new Vector3();
  /** Metres from the eye. */
  near = 0;
  far = 0;

  constructor() {
    this.camera.matrixWorldAutoUpdate = false;
  }

  /**
   * Looks through `eyes`, the two of MuJoCo's stereo camera, from the middle between them. The
   * height of what is seen is MuJoCo's; the width follows from `aspect`.
   */
  look(eyes: readonly Struct[], aspect: number): void {
    const [left, right] = eyes.map(({ numbers }) => numbers);
    const { position, forward, up, camera } = this;
    position.fromArray(left!["pos"]!).add(new Vector3().fromArray(right!["pos"]!));
    position.multiplyScalar(0.5);
    forward.fromArray(left!["forward"]!).normalize();
    up.fromArray(left!["up"]!);
    aim(camera, position, forward, up);

    const bottom = left!["frustum_bottom"]![0]!;
    const top = left!["frustum_top"]![0]!;
    this.near = left!["frustum_near"]![0]!;
    this.far = left!["frustum_far"]![0]!;
    const half = 0.5 * aspect * (top - bottom);
    camera.projectionMatrix.makePerspective(-half, half, top, bottom, this.near, this.far);
    camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
  }
}

const side = new Vector3();
const upward = new Vector3();
const backward = new Vector3();

/** Puts `camera` at `position`, looking along `forward`. */
export function aim(camera: Camera, position: Vector3, forward: Vector3, up: Vector3): void {
  backward.copy(forward).normalize().negate();
  side.crossVectors(up, backward).normalize();
  upward.crossVectors(backward, side);
  camera.matrixWorld.makeBasis(side, upward, backward).setPosition(position);
  camera.matrixWorldInverse.copy(camera.matrixWorld).invert();
}
