/** The model's textures. Their numbers are drawn as they are: MuJoCo knows no sRGB. */
import {
  CubeTexture,
  DataTexture,
  LinearFilter,
  LinearMipmapLinearFilter,
  RepeatWrapping,
  type Texture,
} from "three";

import type { Numbers } from "../../../press/script/native.js";
import type { ModelFields } from "./model-fields.js";

/** mjtTexture. */
const flat = 0;
const skybox = 2;

/** Pixels that a side may have in this browser. */
export interface TextureLimits {
  readonly flat: number;
  readonly cube: number;
}

interface Size {
  readonly width: number;
  readonly height: number;
}

export class Textures {
  private readonly types: Numbers;
  private readonly made = new Map<number, Texture>();

  /** What is larger than `limits` is shrunk. */
  constructor(
    private readonly model: ModelFields,
    private readonly limits: TextureLimits,
  ) {
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
    const size = this.size(id);
    const { flat: limit } = this.limits;
    const to = { width: Math.min(size.width, limit), height: Math.min(size.height, limit) };
    const texture = new DataTexture(shrink(this.rgb(id, 0), size, to), to.width, to.height);
    texture.wrapS = texture.wrapT = RepeatWrapping;
    return texture;
  }

  /** A square is every side; else the six lie one below the other. */
  private cube(id: number): Texture {
    const { width, height } = this.size(id);
    const count = width === height ? 1 : 6;
    const edge = Math.min(width, this.limits.cube);
    const [from, to] = [squareOf(width), squareOf(edge)];
    const sides = Array.from(
      { length: count },
      (_, side) =>
        new DataTexture(shrink(this.rgb(id, side * width * width), from, to), edge, edge),
    );
    for (const side of sides) side.needsUpdate = true;
    return new CubeTexture(Array.from({ length: 6 }, (_, side) => sides[side % count]!));
  }

  private size(id: number): Size {
    const [width, height] = ["tex_width", "tex_height"].map((name) => this.model.array(name)[id]!);
    return { width: width!, height: height! };
  }

  /** From pixel `first` on. */
  private rgb(id: number, first: number): Numbers {
    return this.model.array("tex_rgb").subarray(this.model.array("tex_adr")[id]! + 3 * first);
  }
}

function squareOf(width: number): Size {
  return { width, height: width };
}

/** Pixels of a picture from the first on, and up to the last, which is not one of them. */
interface Patch {
  readonly rows: readonly [number, number];
  readonly columns: readonly [number, number];
}

/** A picture in another size, which is no larger: each pixel is the mean of those that it stands for,
 * with an alpha, which WebGL wants and MuJoCo does not have. */
function shrink(rgb: Numbers, from: Size, to: Size): Uint8Array<ArrayBuffer> {
  const rgba = new Uint8Array(4 * to.width * to.height).fill(255);
  const columns = boundaries(from.width, to.width);
  const rows = boundaries(from.height, to.height);
  for (let y = 0; y < to.height; y++) {
    for (let x = 0; x < to.width; x++) {
      const patch: Patch = {
        rows: [rows[y]!, rows[y + 1]!],
        columns: [columns[x]!, columns[x + 1]!],
      };
      for (let channel = 0; channel < 3; channel++) {
        rgba[4 * (y * to.width + x) + channel] = mean(rgb, from.width, channel, patch);
      }
    }
  }
  return rgba;
}

function mean(rgb: Numbers, width: number, channel: number, { rows, columns }: Patch): number {
  let sum = 0;
  for (let row = rows[0]; row < rows[1]; row++) {
    for (let column = columns[0]; column < columns[1]; column++) {
      sum += rgb[3 * (row * width + column) + channel]!;
    }
  }
  return Math.round(sum / ((rows[1] - rows[0]) * (columns[1] - columns[0])));
}

/** Where each of `to` parts of a row of `from` pixels begins, and where the last one ends. */
function boundaries(from: number, to: number): number[] {
  return Array.from({ length: to + 1 }, (_, part) => Math.floor((part * from) / to));
}
