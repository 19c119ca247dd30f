/** An mjvGeom as the engine shows it in place, and what its numbers mean (mjmodel.h, mjvisualize.h). */
import type { Vector3Like } from "three";

import type { Struct } from "../../engine/struct-layout.js";
import type { Numbers } from "../../../press/script/native.js";

export const geomTypes = {
  plane: 0,
  hfield: 1,
  sphere: 2,
  capsule: 3,
  ellipsoid: 4,
  cylinder: 5,
  box: 6,
  mesh: 7,
  arrow: 100,
  arrow1: 101,
  arrow2: 102,
  line: 103,
  skin: 104,
} as const;

/** mjOBJ_GEOM: what is drawn is a geom of the model, `objid` its id. */
const modelGeom = 5;

/** mjCAT_DYNAMIC: what is drawn belongs to a body that can move. */
const dynamic = 2;

/** The members that are drawn; each is an array, a number being one of length 1. */
export type Geom = Readonly<
  Record<
    | "type"
    | "dataid"
    | "objtype"
    | "objid"
    | "category"
    | "texid"
    | "texuniform"
    | "texcoord"
    | "texrepeat"
    | "size"
    | "pos"
    | "mat"
    | "rgba"
    | "emission"
    | "specular"
    | "shininess"
    | "reflectance",
    Numbers
  >
>;

export function geomOf(struct: Struct): Geom {
  return struct.numbers;
}

export function isOfModel(geom: Geom): boolean {
  return geom.objtype[0] === modelGeom;
}

export function canMove(geom: Geom): boolean {
  return geom.category[0] === dynamic;
}

/** How far `point` is above the geom's xy-plane; below it, it is negative. */
export function heightAbove({ pos, mat }: Geom, point: Vector3Like): number {
  return (
    (point.x - pos[0]!) * mat[2]! + (point.y - pos[1]!) * mat[5]! + (point.z - pos[2]!) * mat[8]!
  );
}
