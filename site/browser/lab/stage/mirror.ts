/**
 * What a plane, or the top of a box, reflects: the scene drawn once more, turned over, and only where
 * the mirror is seen. The mirror itself is added to it later, with everything else.
 */
import { Matrix4, ReplaceStencilOp, Scene, Vector3, type WebGLRenderer } from "three";

import { type Cast, mirroredLayer } from "./cast.js";
import type { Eye } from "./eye.js";
import type { Gaze } from "./gaze.js";
import { type Geom, geomTypes, heightAbove } from "./geom.js";
import { Instances } from "./instances.js";
import type { Kind, Kinds } from "./kinds.js";
import { depthMaterial, type Materials } from "./materials.js";
import { square } from "./shapes.js";

/** A plane or a box is none. */
const noSkins = { vertices: new Float32Array(0), normals: new Float32Array(0) };

export class Mirror {
  private readonly scene = new Scene();
  /** The top of a box. */
  private readonly lid: Kind = {
    id: -1,
    type: geomTypes.box,
    shape: square(1, 1, 1),
    pattern: "none",
    map: undefined,
    extent: undefined,
    skin: undefined,
  };
  private readonly sheet = square(1, 1);
  private readonly outlines = new Map<number, Instances>();
  private readonly material = depthMaterial({
    depthTest: false,
    depthWrite: false,
    stencilWrite: true,
    stencilRef: 1,
    stencilZPass: ReplaceStencilOp,
  });

  constructor(
    private readonly cast: Cast,
    private readonly kinds: Kinds,
    private readonly materials: Materials,
    private readonly gaze: Gaze,
  ) {}

  /** Draws the mirror image in `geom`; lights are to shine without shadows. */
  draw(renderer: WebGLRenderer, geom: Geom, eye: Eye): void {
    const isBox = geom.type[0] === geomTypes.box;
    const top = isBox ? geom.size[2]! : 0;
    if (heightAbove(geom, eye.position) < top) return;
    // A plane is cut into many pieces for the light's sake, which its outline does not need.
    this.outline(geom, isBox ? this.lid : { ...this.kinds.of(geom)!, shape: this.sheet });
    renderer.render(this.scene, eye.camera);

    const { cast, materials, gaze } = this;
    const { mat, pos } = geom;
    const normal = new Vector3(mat[2], mat[5], mat[8]);
    const offset = normal.dot(new Vector3().fromArray(pos)) + top;
    reflect(cast.turn, normal, offset);
    gaze.into(cast.turn, eye, normal, offset, geom.reflectance[0]!);
    materials.onlyInStencil(true);
    eye.camera.layers.set(mirroredLayer);
    renderer.render(cast.scene, eye.camera);

    eye.camera.layers.set(0);
    materials.onlyInStencil(false);
    cast.turn.identity();
    gaze.straight(eye);
  }

  dispose(): void {
    for (const outline of this.outlines.values()) outline.dispose();
    this.material.dispose();
  }

  /** Leaves the outline of `geom` alone on the scene. */
  private outline(geom: Geom, kind: Kind): void {
    let outline = this.outlines.get(kind.id);
    if (outline === undefined) {
      outline = new Instances(kind, [this.material], new Matrix4());
      this.outlines.set(kind.id, outline);
      this.scene.add(...outline.meshes);
    }
    for (const other of this.outlines.values()) {
      other.begin();
      if (other === outline) other.add(geom, noSkins);
      other.end();
    }
  }
}

/** The reflection in the plane of points x with normal · x = offset. */
function reflect(to: Matrix4, { x, y, z }: Vector3, offset: number): void {
  // prettier-ignore
  to.set(
    1 - 2 * x * x, -2 * x * y, -2 * x * z, 2 * offset * x,
    -2 * x * y, 1 - 2 * y * y, -2 * y * z, 2 * offset * y,
    -2 * x * z, -2 * y * z, 1 - 2 * z * z, 2 * offset * z,
    0, 0, 0, 1,
  );
}
