/** What the shaders know of the camera, and through which mirror. */
import { type Matrix4, Vector3, Vector4 } from "three";

import type { Eye } from "./eye.js";

export class Gaze {
  readonly uniforms = {
    eye: { value: new Vector3() },
    /** Nothing is drawn below this plane: a normal, and minus its distance from the origin. */
    mirror: { value: new Vector4() },
    /** What a mirror leaves of the colours. */
    dim: { value: 1 },
  };

  straight(eye: Eye): void {
    const { uniforms } = this;
    uniforms.eye.value.copy(eye.position);
    uniforms.mirror.value.set(0, 0, 0, 1);
    uniforms.dim.value = 1;
  }

  /** Into the mirror whose points x have normal · x = offset, and which turns the world by `turn`. */
  into(turn: Matrix4, eye: Eye, normal: Vector3, offset: number, reflectance: number): void {
    const { uniforms } = this;
    uniforms.eye.value.copy(eye.position).applyMatrix4(turn);
    uniforms.mirror.value.set(normal.x, normal.y, normal.z, -offset);
    uniforms.dim.value = reflectance;
  }
}
