/**
 * Into how many pieces things are cut, and so how many corners what MuJoCo lists is drawn with. It needs
 * nothing of WebGL, as a link's model is counted where none is (lab/run/trial.ts).
 */
import { type Geom, geomTypes } from "./geom.js";
import type { ModelFields } from "./model-fields.js";

/** vis.quality */
export interface Quality {
  readonly slices: number;
  readonly stacks: number;
  readonly quads: number;
}

/** Of a round thing; MuJoCo's own is 28. Nobody sees finer ones, and a model may ask for any. */
const finest = 100;

/** Into how many pieces MuJoCo cuts a plane at most (mjMAXPLANEGRID). */
export const finestPlane = 200;

/** As fine as the model asks for, and no finer than can be seen. */
export function qualityOf(model: ModelFields): Quality {
  const piecesOf = (name: string) => Math.min(model.number(`vis.quality.${name}`), finest);
  return {
    slices: piecesOf("numslices"),
    stacks: piecesOf("numstacks"),
    quads: piecesOf("numquads"),
  };
}

/** Along a side of a plane; size[2] is how far apart the cuts are to be. */
export function piecesOf({ size, dataid }: Geom, side: 0 | 1, { quads }: Quality): number {
  if (dataid[0]! < 0) return quads;
  if (size[side]! <= 0) return finestPlane;
  const piece = Math.max(size[2]!, size[side]! / (finestPlane - 2));
  const count = Math.floor(size[side]! / piece);
  return count - (count % 2) + 2;
}

/** Of how many grids, as large as a sphere's, a shape is made (shapes.ts). */
const grids: Readonly<Record<number, number>> = {
  [geomTypes.sphere]: 1,
  [geomTypes.ellipsoid]: 1,
  [geomTypes.capsule]: 2,
  [geomTypes.cylinder]: 2,
  [geomTypes.arrow]: 3,
  [geomTypes.arrow1]: 3,
  [geomTypes.arrow2]: 4,
};

/** How many corners `geom` is drawn with, about. */
export function cornersOf(geom: Geom, model: ModelFields, quality: Quality): number {
  const [type, dataid] = [geom.type[0]!, geom.dataid[0]!];
  const { slices, stacks, quads } = quality;
  switch (type) {
    case geomTypes.plane:
      return piecesOf(geom, 0, quality) * piecesOf(geom, 1, quality);
    case geomTypes.box:
      return 6 * quads ** 2;
    case geomTypes.mesh:
      return 3 * (model.array("mesh_facenum")[Math.floor(dataid / 2)] ?? 0);
    case geomTypes.hfield:
      return (
        6 * (model.array("hfield_nrow")[dataid] ?? 0) * (model.array("hfield_ncol")[dataid] ?? 0)
      );
    case geomTypes.skin:
      return model.array("skin_vertnum")[geom.objid[0]!]!;
    default:
      return (grids[type] ?? 0) * slices * stacks;
  }
}
