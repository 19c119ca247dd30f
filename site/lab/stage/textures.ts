/** The model's textures. Their numbers are drawn as they are: MuJoCo knows no sRGB. */
import {
  CubeTexture,
  DataTexture,
  LinearFilter,
  LinearMipmapLinearFilter,
  RepeatWrapping,
  type Texture,
} from "three";

import type { Numbers } from "../../script/native.js";
import type { ModelFields } from "./model-fields.js";

/** mjtTexture. */
const flat = 0;
const skybox = 2;

export class Textures {
  private readonly types: Numbers;
  private readonly made = new Map<number, Texture>();

  constructor(private readonly model: ModelFields) {
    this.types = model.array("tex_type").slice();
  }

  /** Is it a picture, and not the six sides of a cube? */
  isFlat(id: number): boolean {
    return this.types[id] === flat;
  }

  /** The first texture that is a sky; undefined where there is none. */
  get sky(): Texture | undefined {
    const id = this.types.indexOf(skybox);
    return id < 0 ? undefined : this.at(id);
  }

  at(id: number): Texture {
    const known = this.made.get(id);
    if (known !== undefined) return known;
    const texture = this.isFlat(id) ? this.picture(id) : this.cube(id);
    texture.magFilter = LinearFilter;
    texture.minFilter = LinearMipmapLinearFilter;
    texture.generateMipmaps = true;
    texture.needsUpdate = true;
    this.made.set(id, texture);
    return texture;
  }

  dispose(): void {
    for (const texture of this.made.values()) texture.dispose();
  }

  private picture(id: number): Texture {
    const { width, height } = this.size(id);
    const texture = new DataTexture(this.pixels(id, 0, width * height), width, height);
    texture.wrapS = texture.wrapT = RepeatWrapping;
    return texture;
  }

  /** A square is every side; else the six lie one below the other. */
  private cube(id: number): Texture {
    const { width, height } = this.size(id);
    const step = width === height ? 0 : width * width;
    const sides = Array.from(
      { length: 6 },
      (_, side) => new DataTexture(this.pixels(id, side * step, width * width), width, width),
    );
    for (const side of sides) side.needsUpdate = true;
    return new CubeTexture(sides);
  }

  private size(id: number) {
    const [width, height] = ["tex_width", "tex_height"].map((name) => this.model.array(name)[id]!);
    return { width: width!, height: height! };
  }

  /** `count` pixels from number `first` on, with an alpha, which WebGL wants and MuJoCo has not. */
  private pixels(id: number, first: number, count: number): Uint8Array<ArrayBuffer> {
    const rgb = this.model.array("tex_rgb").subarray(this.model.array("tex_adr")[id]! + 3 * first);
    const rgba = new Uint8Array(4 * count);
    for (let i = 0; i < count; i++) {
      rgba[4 * i] = rgb[3 * i]!;
      rgba[4 * i + 1] = rgb[3 * i + 1]!;
      rgba[4 * i + 2] = rgb[3 * i + 2]!;
      rgba[4 * i + 3] = 255;
    }
    return rgba;
  }
}
