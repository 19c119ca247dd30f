/** Skins: surfaces whose corners MuJoCo moves with the bodies, in the world's own frame. */
import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from "three";

import type { Skins } from "../../engine/scene.js";
import type { ModelFields } from "./model-fields.js";

/** Where a skin's vertices lie among those of all. */
export interface SkinRange {
  readonly first: number;
  readonly count: number;
}

export function skinRange(model: ModelFields, id: number): SkinRange {
  return { first: model.array("skin_vertadr")[id]!, count: model.array("skin_vertnum")[id]! };
}

/** Skin `id` with the attributes of a Surface; its corners are nowhere yet. */
export function skinOf(model: ModelFields, id: number): BufferGeometry {
  const { count } = skinRange(model, id);
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(4 * count), 4));
  geometry.setAttribute("normal", new BufferAttribute(new Float32Array(3 * count), 3));
  const uv = model.array("skin_texcoordadr")[id]!;
  if (uv >= 0) {
    const own = model.array("skin_texcoord").subarray(2 * uv, 2 * (uv + count));
    geometry.setAttribute("uv", new BufferAttribute(Float32Array.from(own), 2));
  }
  const face = model.array("skin_faceadr")[id]!;
  const faces = model
    .array("skin_face")
    .subarray(3 * face, 3 * (face + model.array("skin_facenum")[id]!));
  geometry.setIndex(new BufferAttribute(Uint32Array.from(faces), 1));
  return geometry;
}

/** The same with room of its own for its corners: a simulation and its ghost wear it differently. */
export function ownSkin(attribute: BufferAttribute): BufferAttribute {
  return new BufferAttribute(attribute.array.slice(), attribute.itemSize).setUsage(
    DynamicDrawUsage,
  );
}

/** Moves the corners of `geometry` to where they are now. */
export function moveSkin(geometry: BufferGeometry, { first, count }: SkinRange, skins: Skins) {
  const places = geometry.getAttribute("position") as BufferAttribute;
  const normals = geometry.getAttribute("normal") as BufferAttribute;
  for (let i = 0; i < count; i++) {
    for (let axis = 0; axis < 3; axis++) {
      places.array[4 * i + axis] = skins.vertices[3 * (first + i) + axis]!;
    }
  }
  normals.array.set(skins.normals.subarray(3 * first, 3 * (first + count)));
  places.needsUpdate = normals.needsUpdate = true;
}
