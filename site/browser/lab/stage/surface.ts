/** A surface while it is built from grids of vertices and from triangles. */
import { BufferAttribute, BufferGeometry } from "three";

/** Place, which end of a capsule it moves with (0 for none), and normal. */
export interface Vertex {
  readonly place: readonly [x: number, y: number, z: number];
  readonly end?: -1 | 0 | 1;
  readonly normal: readonly [x: number, y: number, z: number];
}

export class Surface {
  private readonly places: number[] = [];
  private readonly normals: number[] = [];
  private readonly uvs: number[] = [];
  private readonly indices: number[] = [];

  /**
   * `vertex(i, j)` for i in 0..rows and j in 0..columns. Seen from outside, rows go up where columns
   * go to the right.
   */
  grid(rows: number, columns: number, vertex: (i: number, j: number) => Vertex): this {
    const first = this.places.length / 4;
    for (let i = 0; i <= rows; i++) {
      for (let j = 0; j <= columns; j++) this.vertex(vertex(i, j));
    }
    for (let i = 0; i < rows; i++) {
      for (let j = 0; j < columns; j++) {
        const a = first + i * (columns + 1) + j;
        const d = a + columns + 1;
        this.indices.push(a, a + 1, d, a + 1, d + 1, d);
      }
    }
    return this;
  }

  /** Its corners counterclockwise, seen from outside. */
  triangle(corners: readonly [Vertex, Vertex, Vertex], uvs: readonly number[] = []): void {
    const first = this.places.length / 4;
    for (const corner of corners) this.vertex(corner);
    this.uvs.push(...uvs);
    this.indices.push(first, first + 1, first + 2);
  }

  /** With the attributes `position` (four numbers: a place, and the end), `normal` and, where texture
   * coordinates were given, `uv`. */
  build(): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(this.places), 4));
    geometry.setAttribute("normal", new BufferAttribute(new Float32Array(this.normals), 3));
    if (this.uvs.length > 0) {
      geometry.setAttribute("uv", new BufferAttribute(new Float32Array(this.uvs), 2));
    }
    geometry.setIndex(new BufferAttribute(new Uint32Array(this.indices), 1));
    return geometry;
  }

  private vertex({ place, end = 0, normal }: Vertex): void {
    this.places.push(...place, end);
    this.normals.push(...normal);
  }
}
