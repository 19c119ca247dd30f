/**
 * All that stands on the stage in one frame. Each geom is drawn with others of its kind, in the order
 * of MuJoCo's renderer. First comes the mirror, over its own mirror image; then what is solid; then
 * the sky. What light shines through follows one by one, from the nearest to the farthest and back
 * again. Last comes the ghost.
 */
import { type Material, Matrix4, type Mesh, Scene } from "three";

import type { Skins } from "../../engine/scene.js";
import type { Eye } from "./eye.js";
import { canMove, type Geom, geomTypes, heightAbove, isOfModel } from "./geom.js";
import { Instances } from "./instances.js";
import type { Kind, Kinds } from "./kinds.js";
import type { Materials, Way } from "./materials.js";

/** What casts a shadow is on this layer, and what a mirror shows is on the other. */
export const castingLayer = 1;
export const mirroredLayer = 2;

/** When things are drawn. */
const turns = { mirror: 0, solid: 1, sky: 2, clear: 10, ghost: 1e6 };

/** From this alpha on MuJoCo takes a geom for solid. */
const solidAlpha = 0.995;
/** What a plane keeps of its alpha when it is seen from behind. */
const behindOpacity = 0.3;

/** A scene as MuJoCo lists it. */
export interface Players {
  readonly geoms: readonly Geom[];
  readonly skins: Skins;
}

interface Clear {
  readonly geom: Geom;
  readonly kind: Kind;
  readonly way: "clear" | "behind";
  readonly distance: number;
}

/** Those that are drawn alone: all there are of a kind and way, and how many are on stage. */
interface Soloists {
  readonly all: Instances[];
  used: number;
}

export class Cast {
  readonly scene = new Scene();
  /** Where everything stands: identity, but while a mirror image is drawn. */
  readonly turn = new Matrix4();
  private readonly crowds = new Map<string, Instances>();
  private readonly soloists = new Map<string, Soloists>();

  constructor(
    private readonly kinds: Kinds,
    private readonly materials: Materials,
    /** geom_rbound: how far each of the model's geoms reaches. */
    private readonly reach: ArrayLike<number>,
  ) {
    this.scene.matrixWorldAutoUpdate = false;
  }

  addSky(meshes: readonly Mesh[]): void {
    meshes.forEach((mesh, i) => {
      mesh.renderOrder = turns.sky + i;
      this.scene.add(mesh);
    });
  }

  /** `mirror` is one of the geoms of `players`; of `ghosts` the bodies are shown. */
  assemble(players: Players, eye: Eye, mirror: Geom | undefined, ghosts?: Players): void {
    for (const crowd of this.crowds.values()) crowd.begin();
    const clear: Clear[] = [];
    for (const geom of players.geoms) {
      const kind = this.kinds.of(geom);
      if (kind === undefined) continue;
      const way = wayOf(geom, eye);
      if (way === "solid") {
        this.crowd(geom === mirror ? "mirror" : way, kind).add(geom, players.skins);
      } else clear.push({ geom, kind, way, distance: this.distance(geom, eye) });
    }
    for (const geom of ghosts?.geoms ?? []) {
      const kind = canMove(geom) ? this.kinds.of(geom) : undefined;
      if (kind !== undefined) this.crowd("ghost", kind).add(geom, ghosts!.skins);
    }
    for (const crowd of this.crowds.values()) crowd.end();
    this.assembleClear(clear, players.skins);
  }

  dispose(): void {
    for (const crowd of this.crowds.values()) crowd.dispose();
    for (const { all } of this.soloists.values()) all.forEach((soloist) => soloist.dispose());
  }

  private assembleClear(clear: Clear[], skins: Skins): void {
    for (const soloists of this.soloists.values()) soloists.used = 0;
    clear.sort((a, b) => a.distance - b.distance);
    clear.forEach(({ geom, kind, way }, i) => {
      const soloist = this.soloist(way, kind);
      soloist.begin();
      soloist.add(geom, skins, way === "behind" ? behindOpacity : 1);
      soloist.end();
      const [going, coming] = soloist.meshes;
      going!.renderOrder = turns.clear + i;
      coming!.renderOrder = turns.clear + 2 * clear.length - i;
    });
    for (const { all, used } of this.soloists.values()) {
      for (const idle of all.slice(used)) for (const mesh of idle.meshes) mesh.visible = false;
    }
  }

  private crowd(way: "solid" | "mirror" | "ghost", kind: Kind): Instances {
    const key = `${way} ${kind.id}`;
    const known = this.crowds.get(key);
    if (known !== undefined) return known;
    const own = this.material(way, kind);
    const crowd = this.enter(kind, way === "ghost" ? [this.materials.screen(), own] : [own]);
    crowd.meshes.forEach((mesh, i) => {
      mesh.renderOrder = turns[way] + i;
      if (way !== "ghost") this.involve(mesh, kind, way === "solid");
    });
    this.crowds.set(key, crowd);
    return crowd;
  }

  private soloist(way: "clear" | "behind", kind: Kind): Instances {
    const key = `${way} ${kind.id}`;
    let soloists = this.soloists.get(key);
    if (soloists === undefined) this.soloists.set(key, (soloists = { all: [], used: 0 }));
    const known = soloists.all[soloists.used++];
    if (known !== undefined) return known;
    const own = this.material(way, kind);
    const soloist = this.enter(kind, [own, own]);
    const [going, coming] = soloist.meshes;
    this.involve(going!, kind, true);
    coming!.layers.enable(mirroredLayer);
    soloists.all.push(soloist);
    return soloist;
  }

  private enter(kind: Kind, materials: readonly Material[]): Instances {
    const instances = new Instances(kind, materials, this.turn);
    this.scene.add(...instances.meshes);
    return instances;
  }

  /** In shadows, which lines do not cast, and in the mirror. */
  private involve(mesh: Mesh, kind: Kind, isMirrored: boolean): void {
    if (kind.type !== geomTypes.line) mesh.layers.enable(castingLayer);
    if (isMirrored) mesh.layers.enable(mirroredLayer);
  }

  private material(way: Way, kind: Kind): Material {
    if (kind.type === geomTypes.line) return this.materials.line(way);
    return this.materials.lit(way, kind.pattern, kind.map);
  }

  /** From the eye to the nearest that the geom may reach; planes lie behind everything. */
  private distance(geom: Geom, { position }: Eye): number {
    if (geom.type[0] === geomTypes.plane) return Infinity;
    const { pos, size } = geom;
    const x = pos[0]! - position.x;
    const y = pos[1]! - position.y;
    const z = pos[2]! - position.z;
    const reach = isOfModel(geom)
      ? this.reach[geom.objid[0]!]!
      : Math.max(size[0]!, size[1]!, size[2]!);
    return Math.hypot(x, y, z) - reach;
  }
}

function wayOf(geom: Geom, eye: Eye): "solid" | "clear" | "behind" {
  const isPlane = geom.type[0] === geomTypes.plane;
  if (isPlane && heightAbove(geom, eye.position) < 0) return "behind";
  return geom.rgba[3]! < solidAlpha ? "clear" : "solid";
}

/** The first plane or box that reflects; MuJoCo lets no other. */
export function findMirror(geoms: readonly Geom[], eye: Eye): Geom | undefined {
  return geoms.find((geom) => {
    const type = geom.type[0]!;
    const canReflect = type === geomTypes.plane || type === geomTypes.box;
    return canReflect && geom.reflectance[0]! > 0 && wayOf(geom, eye) === "solid";
  });
}
