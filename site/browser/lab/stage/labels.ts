/** The names beside geoms, written over the picture where MuJoCo writes them. */
import { type Camera, Vector4 } from "three";

import type { Struct } from "../../engine/struct-layout.js";
import type { Frame } from "./show.js";

/** CSS pixels. */
const fontSize = 12.5;
const haloWidth = 3;

/** White with a dark edge, whatever is behind. */
export function writeLabels(
  to: CanvasRenderingContext2D,
  frame: Frame,
  geoms: readonly Struct[],
  camera: Camera,
): void {
  let isReady = false;
  for (const geom of geoms) {
    const text = geom.text("label");
    if (text === "") continue;
    if (!isReady) prepare(to, frame);
    isReady = true;
    const place = onPicture(geom.numbers["pos"]!, camera, frame);
    if (place === undefined) continue;
    to.strokeText(text, ...place);
    to.fillText(text, ...place);
  }
}

function prepare(to: CanvasRenderingContext2D, { density }: Frame): void {
  to.font = `600 ${fontSize * density}px ${getComputedStyle(to.canvas).fontFamily}`;
  to.textBaseline = "alphabetic";
  to.lineJoin = "round";
  to.lineWidth = haloWidth * density;
  to.strokeStyle = "rgb(20 24 30 / 85%)";
  to.fillStyle = "#fff";
}

/** Undefined for what is not in the picture. */
function onPicture(
  pos: ArrayLike<number>,
  camera: Camera,
  { width, height }: Frame,
): [number, number] | undefined {
  const at = new Vector4(pos[0], pos[1], pos[2], 1);
  at.applyMatrix4(camera.matrixWorldInverse).applyMatrix4(camera.projectionMatrix);
  if (Math.max(Math.abs(at.x), Math.abs(at.y), Math.abs(at.z)) > at.w) return undefined;
  return [(0.5 + (0.5 * at.x) / at.w) * width, (0.5 - (0.5 * at.y) / at.w) * height];
}
