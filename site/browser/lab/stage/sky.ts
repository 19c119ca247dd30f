/** The sky, and the haze that hides where an infinite plane ends before it (render_gl3.c). */
import { BackSide, type BufferGeometry, Matrix4, Mesh, type Texture, Vector4 } from "three";

import type { Eye } from "./eye.js";
import { type Geom, geomTypes, heightAbove } from "./geom.js";
import { over, shader, type Uniforms } from "./materials.js";
import type { ModelFields } from "./model-fields.js";
import type { Quality } from "./quality.js";
import { drum } from "./shapes.js";
import { hazeFragment, hazeVertex, skyFragment, skyVertex } from "./shaders.js";
import { Surface } from "./surface.js";

/** Of the way to where nothing is drawn any more. */
const distance = 0.7;

export class Sky {
  readonly meshes: readonly Mesh[];
  private readonly hazeMesh: Mesh;
  private readonly uniforms = {
    far: { value: 1 },
    elevation: { value: 0 },
    plane: { value: new Matrix4() },
  };

  constructor(model: ModelFields, map: Texture, shared: Uniforms, quality: Quality) {
    const uniforms = { ...shared, ...this.uniforms };
    const side = BackSide;
    const sky = shader(skyVertex, skyFragment, {
      side,
      uniforms: { ...uniforms, map: { value: map } },
    });
    const haze = { value: new Vector4().fromArray(model.array("vis.rgba.haze")) };
    const mist = shader(hazeVertex, hazeFragment, {
      ...over,
      depthWrite: true,
      side,
      uniforms: { ...uniforms, haze },
    });
    this.hazeMesh = new Mesh(ring(model.number("vis.map.haze"), quality), mist);
    this.meshes = [new Mesh(drum(quality), sky), this.hazeMesh];
    for (const mesh of this.meshes) mesh.frustumCulled = false;
  }

  /** Only the first infinite plane has haze, and only from above. */
  place(geoms: readonly Geom[], eye: Eye): void {
    const { far, elevation, plane } = this.uniforms;
    far.value = distance * eye.far;
    const floor = geoms.find(
      ({ type, size }) => type[0] === geomTypes.plane && size[0] === 0 && size[1] === 0,
    );
    elevation.value = floor === undefined ? -1 : heightAbove(floor, eye.position) / far.value;
    this.hazeMesh.visible = elevation.value >= 0;
    if (floor === undefined) return;
    const [a, b, c, d, e, f, g, h, i] = floor.mat as unknown as number[];
    plane.value.set(a!, b!, c!, 0, d!, e!, f!, 0, g!, h!, i!, 0, 0, 0, 0, 1);
    plane.value.setPosition(eye.position);
  }

  dispose(): void {
    for (const mesh of this.meshes) {
      mesh.geometry.dispose();
      (mesh.material as ReturnType<typeof shader>).dispose();
    }
  }
}

/** From the plane, where it is `haze` nearer, up to the eye's height; thickest where it is seen over
 * the horizon's lower edge. */
function ring(haze: number, { slices }: Quality): BufferGeometry {
  const alpha = Math.atan2(1, haze);
  const thickest = (Math.SQRT1_2 * haze * Math.sin(alpha)) / Math.sin(0.75 * Math.PI - alpha);
  const heights = [0, thickest, 1];
  const surface = new Surface().grid(2, slices, (i, j) => {
    const angle = (2 * Math.PI * j) / slices;
    const radius = 1 - haze * (1 - heights[i]!);
    return {
      place: [Math.cos(angle) * radius, Math.sin(angle) * radius, heights[i]!],
      end: i === 1 ? 1 : 0,
      normal: [0, 0, 1],
    };
  });
  return surface.build();
}
