/**
 * MuJoCo's primitive geoms at size 1, cut as finely as MuJoCo's own renderer cuts them
 * (render_context.c): it lights corners and blends between them, so the cut is seen.
 */
import type { BufferGeometry } from "three";

import { geomTypes } from "./geom.js";
import type { Quality } from "./quality.js";
import { Surface, type Vertex } from "./surface.js";

/** The shape of a geom type; undefined for what is not a primitive. */
export function shapeOf(type: number, quality: Quality): BufferGeometry | undefined {
  const make = makers[type];
  return make?.(new Surface(), quality).build();
}

const makers: Readonly<Record<number, (surface: Surface, quality: Quality) => Surface>> = {
  [geomTypes.sphere]: ball,
  [geomTypes.ellipsoid]: ball,
  [geomTypes.capsule]: capsule,
  [geomTypes.cylinder]: cylinder,
  [geomTypes.box]: box,
  [geomTypes.arrow]: (surface, quality) => arrow(surface, quality, 1.75),
  [geomTypes.arrow1]: (surface, quality) => arrow(surface, quality, 1),
  [geomTypes.arrow2]: doubleArrow,
  [geomTypes.line]: line,
};

/** A square from -1 to 1 in x and y that faces +z, at height z. */
export function square(columns: number, rows: number, z = 0): BufferGeometry {
  const vertex = (i: number, j: number): Vertex => ({
    place: [(2 * j) / columns - 1, (2 * i) / rows - 1, z],
    normal: [0, 0, 1],
  });
  return new Surface().grid(rows, columns, vertex).build();
}

/** MuJoCo draws the sky on it. */
export function drum(quality: Quality): BufferGeometry {
  return cylinder(new Surface(), quality).build();
}

function around(j: number, slices: number): readonly [cos: number, sin: number] {
  const angle = (2 * Math.PI * j) / slices;
  return [Math.cos(angle), Math.sin(angle)];
}

/** From one elevation to another, in quarter turns. */
function cap(surface: Surface, quality: Quality, from: number, to: number, end: -1 | 0 | 1) {
  const { slices, stacks } = quality;
  const rows = Math.max(1, Math.round(((to - from) * stacks) / 2));
  return surface.grid(rows, slices, (i, j) => {
    const elevation = (Math.PI / 2) * (from + ((to - from) * i) / rows);
    const [x, y] = around(j, slices);
    const across = Math.cos(elevation);
    const normal = [x * across, y * across, Math.sin(elevation)] as const;
    return { place: normal, end, normal };
  });
}

function ball(surface: Surface, quality: Quality): Surface {
  return cap(surface, quality, -1, 1, 0);
}

function tube(surface: Surface, { slices, stacks }: Quality, bottom = -1, top = 1): Surface {
  return surface.grid(stacks, slices, (i, j) => {
    const [x, y] = around(j, slices);
    return { place: [x, y, bottom + ((top - bottom) * i) / stacks], normal: [x, y, 0] };
  });
}

/** A disk that faces up or down. */
function disk(surface: Surface, quality: Quality, z: number, facing: -1 | 1, radius = 1): Surface {
  const { slices, stacks } = quality;
  const rings = Math.max(1, Math.floor(stacks / 2));
  return surface.grid(rings, slices, (i, j) => {
    const [x, y] = around(j, slices);
    const r = (radius * (facing > 0 ? rings - i : i)) / rings;
    return { place: [x * r, y * r, z], normal: [0, 0, facing] };
  });
}

/** An open cone from `base` to `tip`, which may be below it. */
function cone(surface: Surface, quality: Quality, base: number, tip: number, radius: number) {
  const { slices, stacks } = quality;
  const up = Math.sign(tip - base);
  // The slope's normal, before it is turned around the axis.
  const height = Math.abs(tip - base);
  const length = Math.hypot(height, radius);
  return surface.grid(stacks, slices, (i, j) => {
    const [x, y] = around(up * j, slices);
    const r = radius * (1 - i / stacks);
    return {
      place: [x * r, y * r, base + ((tip - base) * i) / stacks],
      normal: [(x * height) / length, (y * height) / length, (up * radius) / length],
    };
  });
}

function cylinder(surface: Surface, quality: Quality): Surface {
  disk(surface, quality, -1, -1);
  tube(surface, quality);
  return disk(surface, quality, 1, 1);
}

function capsule(surface: Surface, quality: Quality): Surface {
  tube(surface, quality);
  cap(surface, quality, 0, 1, 1);
  return cap(surface, quality, -1, 0, -1);
}

function arrow(surface: Surface, quality: Quality, head: number): Surface {
  disk(surface, quality, 0, -1);
  tube(surface, quality, 0, 1 / 3);
  disk(surface, quality, 1 / 3, -1, head);
  return cone(surface, quality, 1 / 3, 1 / 2, head);
}

function doubleArrow(surface: Surface, quality: Quality): Surface {
  const head = 1.75;
  tube(surface, quality, -1 / 3, 1 / 3);
  disk(surface, quality, 1 / 3, -1, head);
  cone(surface, quality, 1 / 3, 1 / 2, head);
  disk(surface, quality, -1 / 3, 1, head);
  return cone(surface, quality, -1 / 3, -1 / 2, head);
}

function box(surface: Surface, { quads }: Quality): Surface {
  for (const axis of [0, 1, 2]) {
    for (const facing of [-1, 1]) {
      // Two other axes that make a right-handed frame with the outward one.
      const [right, up] = [(axis + 1) % 3, (axis + 2) % 3];
      surface.grid(quads, quads, (i, j) => {
        const place: [number, number, number] = [0, 0, 0];
        const normal: [number, number, number] = [0, 0, 0];
        place[axis] = normal[axis] = facing;
        place[right] = facing * ((2 * j) / quads - 1);
        place[up] = (2 * i) / quads - 1;
        return { place, normal };
      });
    }
  }
  return surface;
}

/** From 0 to 1 in z; the shader widens it, by x, to a strip that faces the reader. */
function line(surface: Surface): Surface {
  return surface.grid(1, 1, (i, j) => ({ place: [2 * j - 1, 0, i], normal: [0, 0, 1] }));
}
