/** The model's meshes, their convex hulls and its height fields, as MuJoCo draws them. */
import type { BufferGeometry } from "three";

import type { Numbers } from "../../../press/script/native.js";
import type { ModelFields } from "./model-fields.js";
import { Surface, type Vertex } from "./surface.js";

type Triple = readonly [x: number, y: number, z: number];

/** Where the angle between a corner's own normal and its face's is wider, MuJoCo shades it flat. */
const smoothest = 0.8;

/** Mesh `dataid / 2`, or for an odd `dataid` its hull. */
export function meshOf(model: ModelFields, dataid: number): BufferGeometry {
  const id = Math.floor(dataid / 2);
  return (dataid % 2 === 1 ? hull(model, id) : mesh(model, id)).build();
}

function mesh(model: ModelFields, id: number): Surface {
  const first = 3 * model.array("mesh_vertadr")[id]!;
  const vertices = model.array("mesh_vert").subarray(first);
  const normals = model.array("mesh_normal").subarray(first);
  const faces = model.array("mesh_face");
  const face = model.array("mesh_faceadr")[id]!;
  const uv = texcoords(model, id);
  const surface = new Surface();
  for (let at = 3 * face; at < 3 * (face + model.array("mesh_facenum")[id]!); at += 3) {
    const corners = [faces[at]!, faces[at + 1]!, faces[at + 2]!] as const;
    const flat = faceNormal(...triples(vertices, corners));
    const vertex = (corner: number): Vertex => {
      const own = triple(normals, corner);
      const isSmooth = uv !== undefined || dot(own, flat) >= smoothest;
      return { place: triple(vertices, corner), normal: isSmooth ? own : flat };
    };
    const [a, b, c] = corners;
    surface.triangle([vertex(a), vertex(b), vertex(c)], uv?.(corners));
  }
  return surface;
}

function hull(model: ModelFields, id: number): Surface {
  const vertices = model.array("mesh_vert").subarray(3 * model.array("mesh_vertadr")[id]!);
  const graph = model.array("mesh_graph").subarray(model.array("mesh_graphadr")[id]);
  const [vertexCount, faceCount] = [graph[0]!, graph[1]!];
  const faces = graph.subarray(2 + 3 * vertexCount + 3 * faceCount);
  const uv = texcoords(model, id);
  const surface = new Surface();
  for (let at = 0; at < 3 * faceCount; at += 3) {
    const corners = [faces[at]!, faces[at + 1]!, faces[at + 2]!] as const;
    surface.triangle(flatTriangle(...triples(vertices, corners)), uv?.(corners));
  }
  return surface;
}

/** What gives the texture coordinates of three vertices; undefined where the mesh has none. */
function texcoords(model: ModelFields, id: number) {
  const first = model.array("mesh_texcoordadr")[id]!;
  if (first < 0) return undefined;
  const all = model.array("mesh_texcoord").subarray(2 * first);
  return (corners: Triple) => corners.flatMap((corner) => [all[2 * corner]!, all[2 * corner + 1]!]);
}

export function hfieldOf(model: ModelFields, id: number): BufferGeometry {
  const [rows, columns] = [model.array("hfield_nrow")[id]!, model.array("hfield_ncol")[id]!];
  const [x, y, z, below] = model.array("hfield_size").subarray(4 * id) as unknown as number[];
  const heights = model.array("hfield_data").subarray(model.array("hfield_adr")[id]);
  const at = (row: number, column: number): Triple => [
    x! * ((2 * column) / (columns - 1) - 1),
    y! * ((2 * row) / (rows - 1) - 1),
    z! * heights[row * columns + column]!,
  ];
  const surface = new Surface();
  for (let row = 0; row < rows - 1; row++) {
    for (let column = 0; column < columns - 1; column++) {
      const [a, b] = [at(row, column), at(row, column + 1)];
      const [c, d] = [at(row + 1, column + 1), at(row + 1, column)];
      surface.triangle(flatTriangle(a, b, d));
      surface.triangle(flatTriangle(b, c, d));
    }
  }

  // The sides stand on the bottom, `below` under the lowest height; each is walked with the outside
  // to the right.
  const wall = (count: number, edge: (step: number) => Triple, normal: Triple) => {
    surface.grid(1, count - 1, (i, j) => {
      const top = edge(j);
      return { place: i === 1 ? top : [top[0], top[1], -below!], normal };
    });
  };
  wall(columns, (step) => at(0, step), [0, -1, 0]);
  wall(rows, (step) => at(step, columns - 1), [1, 0, 0]);
  wall(columns, (step) => at(rows - 1, columns - 1 - step), [0, 1, 0]);
  wall(rows, (step) => at(rows - 1 - step, 0), [-1, 0, 0]);
  surface.grid(1, 1, (i, j) => ({
    place: [x! * (1 - 2 * j), y! * (2 * i - 1), -below!],
    normal: [0, 0, -1],
  }));
  return surface.build();
}

function triple(numbers: Numbers, index: number): Triple {
  return [numbers[3 * index]!, numbers[3 * index + 1]!, numbers[3 * index + 2]!];
}

function triples(numbers: Numbers, [a, b, c]: Triple): [Triple, Triple, Triple] {
  return [triple(numbers, a), triple(numbers, b), triple(numbers, c)];
}

function flatTriangle(a: Triple, b: Triple, c: Triple): [Vertex, Vertex, Vertex] {
  const normal = faceNormal(a, b, c);
  return [
    { place: a, normal },
    { place: b, normal },
    { place: c, normal },
  ];
}

function dot(a: Triple, b: Triple): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** +z for a triangle without area, as in MuJoCo. */
function faceNormal(a: Triple, b: Triple, c: Triple): Triple {
  const [px, py, pz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const [qx, qy, qz] = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
  const normal = [py * qz - pz * qy, pz * qx - px * qz, px * qy - py * qx] as const;
  const length = Math.hypot(...normal);
  if (length < 1e-10) return [0, 0, 1];
  return [normal[0] / length, normal[1] / length, normal[2] / length];
}
