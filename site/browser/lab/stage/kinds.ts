/**
 * What geoms have in common that one call of WebGL can draw: shape, texture, and how the texture lies
 * on the shape. A model has a few kinds; each is made when a geom of it is first seen.
 */
import type { BufferGeometry, Texture } from "three";

import { type Geom, geomTypes, isOfModel } from "./geom.js";
import type { Pattern } from "./materials.js";
import { hfieldOf, meshOf } from "./meshes.js";
import type { ModelFields } from "./model-fields.js";
import { finestPlane, piecesOf, type Quality } from "./quality.js";
import { shapeOf, square } from "./shapes.js";
import { skinOf, type SkinRange, skinRange } from "./skins.js";
import type { Textures } from "./textures.js";

export interface Kind {
  readonly id: number;
  readonly type: number;
  readonly shape: BufferGeometry;
  readonly pattern: Pattern;
  readonly map: Texture | undefined;
  /** Of a plane: half its sides, also where it is infinite. */
  readonly extent: readonly [number, number] | undefined;
  readonly skin: SkinRange | undefined;
}

export class Kinds {
  private readonly known = new Map<number, Kind | undefined>();
  private readonly shapes = new Map<number, BufferGeometry | undefined>();

  constructor(
    private readonly model: ModelFields,
    private readonly textures: Textures,
    private readonly quality: Quality,
  ) {}

  /** Undefined for what is not drawn: labels without a geom. */
  of(geom: Geom): Kind | undefined {
    const [type, dataid, texid] = [geom.type[0]!, dataOf(geom), geom.texid[0]!];
    // Room for 2 * 65536 meshes and as many textures.
    const id = ((type * 0x20000 + dataid + 1) * 0x10000 + texid + 1) * 2 + geom.texcoord[0]!;
    if (this.known.has(id)) return this.known.get(id);
    const kind = this.make(id, geom);
    this.known.set(id, kind);
    return kind;
  }

  private make(id: number, geom: Geom): Kind | undefined {
    const type = geom.type[0]!;
    const shape = this.shape(geom);
    if (shape === undefined) return undefined;
    const extent = type === geomTypes.plane ? this.extent(geom) : undefined;
    const skin = type === geomTypes.skin ? skinRange(this.model, dataOf(geom)) : undefined;
    const texture = geom.texid[0]!;
    if (texture < 0) return { id, type, shape, pattern: "none", map: undefined, extent, skin };
    const isFlat = this.textures.isFlat(texture);
    const isUnwrapped = isFlat && geom.texcoord[0] !== 0 && shape.hasAttribute("uv");
    const pattern = isUnwrapped ? "unwrapped" : isFlat ? "flat" : "cube";
    return { id, type, shape, pattern, map: this.textures.at(texture), extent, skin };
  }

  private shape(geom: Geom): BufferGeometry | undefined {
    const [type, dataid] = [geom.type[0]!, dataOf(geom)];
    const key = type * 0x20000 + dataid + 1;
    if (!this.shapes.has(key)) this.shapes.set(key, this.makeShape(geom, type, dataid));
    return this.shapes.get(key);
  }

  private makeShape(geom: Geom, type: number, dataid: number): BufferGeometry | undefined {
    if (type === geomTypes.plane) {
      return square(piecesOf(geom, 0, this.quality), piecesOf(geom, 1, this.quality));
    }
    if (type === geomTypes.mesh) return dataid < 0 ? undefined : meshOf(this.model, dataid);
    if (type === geomTypes.skin) return skinOf(this.model, dataid);
    if (type === geomTypes.hfield) return dataid < 0 ? undefined : hfieldOf(this.model, dataid);
    return shapeOf(type, this.quality);
  }

  private extent(geom: Geom): [number, number] {
    return [this.half(geom, 0), this.half(geom, 1)];
  }

  /** An infinite side ends where nothing is drawn any more, wherever MuJoCo has moved the plane to:
   * it moves by repeats of the texture. */
  private half(geom: Geom, side: 0 | 1): number {
    const size = geom.size[side]!;
    if (size > 0) return size;
    const far = this.model.number("vis.map.zfar") * this.model.number("stat.extent");
    const material = isOfModel(geom) ? this.model.array("geom_matid")[geom.objid[0]!]! : -1;
    const repeat = material < 0 ? 0 : this.model.array("mat_texrepeat")[2 * material + side]!;
    return 1.05 * far + (repeat > 0 ? 2 / repeat : (2.1 * far) / (finestPlane - 2));
  }
}

/** Which mesh or height field, and which skin, of which MuJoCo says it in another member. */
function dataOf({ type, dataid, objid }: Geom): number {
  return type[0] === geomTypes.skin ? objid[0]! : dataid[0]!;
}

/** Shapes that have their own size already. */
const sized: readonly number[] = [geomTypes.mesh, geomTypes.hfield, geomTypes.skin];

/** Writes three numbers: by how much the shape is stretched. */
export function sizeOf({ size }: Geom, kind: Kind, to: Float32Array, at: number): void {
  const isSized = sized.includes(kind.type);
  to[at] = isSized ? 1 : (kind.extent?.[0] ?? size[0]!);
  to[at + 1] = isSized ? 1 : (kind.extent?.[1] ?? size[1]!);
  to[at + 2] = isSized || kind.extent !== undefined ? 1 : size[2]!;
}

/** Writes three numbers: what the shape's own coordinates are multiplied with to find a place on its
 * texture (settexture in render_gl3.c; a plane's coordinates are metres there). */
export function patternOf(geom: Geom, kind: Kind, to: Float32Array, at: number): void {
  const x = kind.extent?.[0] ?? 1;
  const y = kind.extent?.[1] ?? 1;
  if (kind.pattern === "flat") {
    to[at] = 0.5 * x * repeats(geom, 0);
    to[at + 1] = -0.5 * y * repeats(geom, 1);
    return;
  }
  const isUniform = geom.texuniform[0] !== 0;
  to[at] = isUniform ? x * geom.size[0]! : x;
  to[at + 1] = isUniform ? y * geom.size[1]! : y;
  to[at + 2] = isUniform ? geom.size[2]! : 1;
}

/** How often a picture is repeated along a side. */
function repeats(geom: Geom, side: 0 | 1): number {
  const size = geom.size[side]!;
  let times = geom.texrepeat[side]!;
  if (size <= 0) return times;
  if (geom.dataid[0]! >= 0) times /= size;
  if (geom.texuniform[0] !== 0) times *= size;
  return times;
}
