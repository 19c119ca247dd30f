/**
 * Which places each light sees: one map of depths, of which every light that casts a shadow has a
 * tile. It belongs to the stage, since only one view is drawn at a time.
 */
import {
  BackSide,
  Camera,
  DepthTexture,
  LessEqualCompare,
  LinearFilter,
  Matrix4,
  NearestFilter,
  RedFormat,
  type Scene,
  UnsignedIntType,
  Vector3,
  type WebGLRenderer,
  WebGLRenderTarget,
} from "three";

import type { Struct } from "../../engine/struct-layout.js";
import { castingLayer } from "./cast.js";
import { aim, type Eye } from "./eye.js";
import { mostShadows } from "./lights.js";
import { depthMaterial } from "./materials.js";

/** Pixels a side; MuJoCo's own 4096 would take 64 MB. */
const largestTile = 2048;

/** vis.map and vis.quality, as far as they are about shadows. */
export interface ShadowSettings {
  /** Metres that a directional light's map reaches to each side. */
  readonly clip: number;
  /** Of a spot light's cone. */
  readonly scale: number;
  readonly size: number;
}

export class Shadows {
  private readonly target = makeTarget();
  private readonly camera = new Camera();
  /** The far sides: so nothing shades its own near ones. */
  private readonly material = depthMaterial({ side: BackSide });
  readonly uniforms = {
    shadowMap: { value: this.target.depthTexture },
    shadowCount: { value: 0 },
    shadowTexel: { value: 1 },
    shadowMatrix: { value: Array.from({ length: mostShadows }, () => new Matrix4()) },
    shadowTile: { value: new Float32Array(3 * mostShadows) },
  };

  constructor() {
    this.camera.matrixWorldAutoUpdate = false;
    this.camera.layers.set(castingLayer);
  }

  /** Draws the depths of `scene` as each light of `casting` sees them. */
  draw(
    renderer: WebGLRenderer,
    scene: Scene,
    casting: readonly Struct[],
    eye: Eye,
    settings: ShadowSettings,
  ): void {
    const { uniforms, target } = this;
    uniforms.shadowCount.value = casting.length;
    // Where no light has a tile nobody reads the map, and WebGL draws nothing without it all the same.
    renderer.initRenderTarget(target);
    if (casting.length === 0) return;
    const across = casting.length > 1 ? 2 : 1;
    const bearable = Math.floor(renderer.capabilities.maxTextureSize / across);
    const tile = Math.min(settings.size, largestTile, bearable);
    if (target.width < tile * across) target.setSize(tile * across, tile * across);
    uniforms.shadowTexel.value = 1 / target.width;

    target.viewport.set(0, 0, target.width, target.height);
    renderer.setRenderTarget(target);
    renderer.clear(false, true, false);
    scene.overrideMaterial = this.material;
    casting.forEach((light, k) => {
      const [x, y] = [tile * (k % 2), tile * Math.floor(k / 2)];
      uniforms.shadowTile.value.set(
        [x, y, tile].map((pixels) => pixels / target.width),
        3 * k,
      );
      // A pixel at the edge stays empty, so that what is outside of the map is lit.
      target.viewport.set(x + 1, y + 1, tile - 2, tile - 2);
      renderer.setRenderTarget(target);
      this.lookFrom(light, eye, settings);
      renderer.render(scene, this.camera);
      uniforms.shadowMatrix.value[k]!.copy(toUnit)
        .multiply(this.camera.projectionMatrix)
        .multiply(this.camera.matrixWorldInverse);
    });
    scene.overrideMaterial = null;
    renderer.setRenderTarget(null);
  }

  dispose(): void {
    this.target.dispose();
    this.material.dispose();
  }

  private lookFrom({ numbers }: Struct, { near, far }: Eye, settings: ShadowSettings): void {
    const { projectionMatrix } = this.camera;
    if (numbers["directional"]![0] !== 0) {
      const { clip } = settings;
      projectionMatrix.makeOrthographic(-clip, clip, clip, -clip, near, far);
    } else {
      const angle = Math.min(2 * numbers["cutoff"]![0]! * settings.scale, 160);
      const half = Math.tan((angle * Math.PI) / 360) * near;
      projectionMatrix.makePerspective(-half, half, half, -half, near, far);
    }
    const forward = new Vector3().fromArray(numbers["dir"]!);
    // Any direction will do that is not the light's own.
    const up = new Vector3(-1, 0, 0).cross(forward);
    if (up.lengthSq() <= 0.01) up.set(0, 1, 0);
    aim(this.camera, new Vector3().fromArray(numbers["pos"]!), forward, up);
  }
}

/** From -1 … 1 to 0 … 1. */
const toUnit = new Matrix4().makeTranslation(0.5, 0.5, 0.5).scale(new Vector3(0.5, 0.5, 0.5));

function makeTarget() {
  const depthTexture = new DepthTexture(1, 1, UnsignedIntType);
  depthTexture.compareFunction = LessEqualCompare;
  depthTexture.magFilter = depthTexture.minFilter = LinearFilter;
  // Nothing is drawn into the colours, which WebGL asks for: the smaller, the better.
  return new WebGLRenderTarget(1, 1, {
    depthTexture,
    format: RedFormat,
    magFilter: NearestFilter,
    minFilter: NearestFilter,
  });
}
