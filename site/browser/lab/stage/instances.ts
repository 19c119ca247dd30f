/**
 * Instances of one kind, drawn by a single call of WebGL. Between begin() and end() geoms are added;
 * room for more is made as it is needed, and kept.
 */
import {
  BufferAttribute,
  DynamicDrawUsage,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  type Material,
  type Matrix4,
  Mesh,
} from "three";

import type { Skins } from "../../engine/scene.js";
import type { Geom } from "./geom.js";
import { type Kind, patternOf, sizeOf } from "./kinds.js";
import { moveSkin, ownSkin } from "./skins.js";

/** What the shaders know of an instance: names, and how many numbers each has. */
const members = {
  row0: 4, // of the matrix that turns and moves it
  row1: 4,
  row2: 4,
  sizeEmission: 4,
  rgba: 4,
  patternSpecular: 4, // how its texture is stretched, and how much it shines
  shininess: 1,
};
/** Of what lies in the world's frame already. */
const inPlace = { pos: [0, 0, 0], mat: [1, 0, 0, 0, 1, 0, 0, 0, 1] };
const numbersEach = Object.values(members).reduce((sum, count) => sum + count);

export class Instances {
  private readonly geometry = new InstancedBufferGeometry();
  private data = new Float32Array(0);
  private buffer: InstancedInterleavedBuffer | undefined;
  private count = 0;
  /** One for each material, to be put on a scene. */
  readonly meshes: readonly Mesh[];

  /** They stand where `turn` says, which others share. */
  constructor(
    private readonly kind: Kind,
    materials: readonly Material[],
    turn: Matrix4,
  ) {
    // Attributes of its own over the shape's numbers: three.js frees those of a geometry with it.
    const { attributes, index } = kind.shape;
    for (const [name, attribute] of Object.entries(attributes)) {
      const { array, itemSize } = attribute;
      const moves = kind.skin !== undefined && name !== "uv";
      this.geometry.setAttribute(
        name,
        moves ? ownSkin(attribute as BufferAttribute) : new BufferAttribute(array, itemSize),
      );
    }
    this.geometry.setIndex(new BufferAttribute(index!.array, 1));
    this.meshes = materials.map((material) => {
      const mesh = new Mesh(this.geometry, material);
      mesh.frustumCulled = false;
      mesh.matrixWorldAutoUpdate = false;
      mesh.matrixWorld = turn;
      return mesh;
    });
  }

  begin(): void {
    this.count = 0;
  }

  /** `opacity` is what is left of its alpha. A skin is where `skins` has it. */
  add(geom: Geom, skins: Skins, opacity = 1): void {
    if (this.buffer === undefined || this.count === this.buffer.count) this.grow();
    const { rgba } = geom;
    const { pos, mat } = this.kind.skin === undefined ? geom : inPlace;
    if (this.kind.skin !== undefined) moveSkin(this.geometry, this.kind.skin, skins);
    const { data } = this;
    const start = numbersEach * this.count++;
    for (let row = 0; row < 3; row++) {
      for (let i = 0; i < 3; i++) data[start + 4 * row + i] = mat[3 * row + i]!;
      data[start + 4 * row + 3] = pos[row]!;
    }
    sizeOf(geom, this.kind, data, start + 12);
    data[start + 15] = geom.emission[0]!;
    for (let i = 0; i < 4; i++) data[start + 16 + i] = rgba[i]!;
    data[start + 19]! *= opacity;
    patternOf(geom, this.kind, data, start + 20);
    data[start + 23] = geom.specular[0]!;
    data[start + 24] = 128 * geom.shininess[0]!;
  }

  end(): void {
    for (const mesh of this.meshes) mesh.visible = this.count > 0;
    this.geometry.instanceCount = this.count;
    if (this.buffer === undefined || this.count === 0) return;
    this.buffer.clearUpdateRanges();
    this.buffer.addUpdateRange(0, numbersEach * this.count);
    this.buffer.needsUpdate = true;
  }

  dispose(): void {
    this.geometry.dispose();
  }

  private grow(): void {
    const { geometry } = this;
    geometry.dispose(); // until then three.js knows of no more room
    const data = new Float32Array(numbersEach * Math.max(1, 2 * this.count));
    data.set(this.data);
    this.data = data;
    this.buffer = new InstancedInterleavedBuffer(data, numbersEach);
    this.buffer.setUsage(DynamicDrawUsage);
    let offset = 0;
    for (const [name, size] of Object.entries(members)) {
      geometry.setAttribute(name, new InterleavedBufferAttribute(this.buffer, size, offset));
      offset += size;
    }
  }
}
