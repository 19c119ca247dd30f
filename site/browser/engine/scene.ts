/**
 * What a page draws: the geoms, lights and camera that MuJoCo's own renderer would draw, in MuJoCo's
 * memory, and the mouse in them. The same flags as in the generator's pictures give the same scene.
 */
import { MujocoError } from "./errors.js";
import type { Pointer } from "./glue.js";
import { float, type Memory } from "./memory.js";
import { type Layout, readLayouts, type Struct } from "./struct-layout.js";

/** What a drag does, with MuJoCo's numbers (mjtMouse). */
const actions = {
  rotateVertical: 1,
  rotateHorizontal: 2,
  moveVertical: 3,
  moveHorizontal: 4,
  zoom: 5,
} as const;
export type Action = keyof typeof actions;

/** How a body is held, with MuJoCo's numbers (mjtPertBit). */
const holds = { none: 0, pull: 1, turn: 2 } as const;
export type Hold = keyof typeof holds;

/** Three numbers for each vertex; those of skin i begin at its skin_vertadr. */
export interface Skins {
  readonly vertices: Float32Array;
  readonly normals: Float32Array;
}

export class Scene {
  private readonly layouts: ReadonlyMap<string, Layout>;
  /** Structs by address, as long as memory does not move. */
  private structs = new Map<Pointer, Struct>();
  private buffer: ArrayBuffer;

  /** @internal Use Simulation.openScene(). */
  constructor(
    private readonly memory: Memory,
    private handle: Pointer,
  ) {
    this.layouts = readLayouts(memory);
    this.buffer = memory.buffer;
    this.overlays = overlayNames(memory);
  }

  /** The overlays that there are: "joints", "contacts" … */
  readonly overlays: readonly string[];

  /** Those of them that are drawn. MuJoCo draws some by itself, and of frames and labels one kind. */
  get shown(): ReadonlySet<string> {
    return new Set(this.overlays.filter((_, i) => this.call("mjc_scene_shows_overlay", i) !== 0));
  }

  showOverlay(name: string, on: boolean): void {
    const found = this.memory.withText(name, (text) =>
      this.call("mjc_scene_overlay", text, Number(on)),
    );
    if (found === 0) throw new RangeError(`there is no overlay ${name}`);
  }

  /** Up to date with the simulation; false, and as it was, when that has stopped. */
  update(): boolean {
    return this.call("mjc_scene_update") !== 0;
  }

  /** How many `geoms` there are, which costs nothing. */
  get geomCount(): number {
    return this.call("mjc_scene_geom_count");
  }

  /** mjvGeom, each with a `label`. They are the same objects from update to update. */
  get geoms(): readonly Struct[] {
    return this.array("mjvGeom", "mjc_scene_geoms", this.geomCount);
  }

  /** The vertices of all skins, where the bodies have brought them, in place. */
  get skins(): Skins {
    const count = 3 * this.call("mjc_scene_skin_vertex_count");
    const floats = (first: string) =>
      this.memory.view(float, this.call(first), count) as Float32Array;
    return {
      vertices: floats("mjc_scene_skin_vertices"),
      normals: floats("mjc_scene_skin_normals"),
    };
  }

  /** mjvLight. */
  get lights(): readonly Struct[] {
    return this.array("mjvLight", "mjc_scene_lights", this.call("mjc_scene_light_count"));
  }

  /** mjvGLCamera: where the camera is and what it sees, after an update. */
  get view(): Struct {
    return this.array("mjvGLCamera", "mjc_scene_view", 1)[0]!;
  }

  /** mjvGLCamera of the left and of the right eye: MuJoCo's own renderer draws what one in the middle
   * between them sees. */
  get eyes(): readonly Struct[] {
    return this.array("mjvGLCamera", "mjc_scene_view", 2);
  }

  /** mjvCamera, to be set: lookat, distance, azimuth, elevation. */
  get camera(): Struct {
    return this.array("mjvCamera", "mjc_scene_camera", 1)[0]!;
  }

  /** `dx` and `dy` are parts of the window's height. */
  moveCamera(action: Action, dx: number, dy: number): void {
    this.call("mjc_scene_move_camera", actions[action], dx, dy);
  }

  /** Selects the body that is seen at (x, y), 0 to 1 from the lower left; 0 when there is none. */
  select(aspect: number, x: number, y: number): number {
    return this.call("mjc_scene_select", aspect, x, y);
  }

  hold(hold: Hold): void {
    this.call("mjc_scene_grab", holds[hold]);
  }

  drag(action: Action, dx: number, dy: number): void {
    this.call("mjc_scene_drag", actions[action], dx, dy);
  }

  /** Before each step, while a body is held and once after. */
  pull(): void {
    this.call("mjc_scene_pull");
  }

  /** @internal The simulation does it. */
  free(): void {
    this.call("mjc_scene_free");
    this.handle = 0;
  }

  private array(struct: string, first: string, count: number): Struct[] {
    const address = this.call(first);
    const layout = this.layouts.get(struct)!;
    return Array.from({ length: count }, (_, i) => this.struct(layout, address + i * layout.size));
  }

  private struct(layout: Layout, address: Pointer): Struct {
    if (this.buffer !== this.memory.buffer) {
      this.buffer = this.memory.buffer;
      this.structs = new Map();
    }
    const known = this.structs.get(address);
    if (known !== undefined) return known;
    const made = layout.at(address);
    this.structs.set(address, made);
    return made;
  }

  private call(name: string, ...args: number[]): number {
    if (this.handle === 0) throw new MujocoError("this scene was freed with its simulation");
    return this.memory.call(name, this.handle, ...args);
  }
}

function overlayNames(memory: Memory): string[] {
  const names: string[] = [];
  for (;;) {
    const name = memory.text(memory.call("mjc_overlay_name", names.length));
    if (name === "") return names;
    names.push(name);
  }
}
