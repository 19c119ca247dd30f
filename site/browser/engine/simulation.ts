/**
 * A model in motion, watched by the same code as in a build (generator/physics/simulation.cpp): what
 * diverges stops, and says so.
 */
import { MemoryError, MujocoError } from "./errors.js";
import { dataFields, modelFields } from "./field-table.js";
import { nativeFunctions } from "./functions.js";
import type { Pointer } from "./glue.js";
import type { Memory } from "./memory.js";
import { Scene } from "./scene.js";
import { constants } from "../../press/script/constants.js";
import type { Native } from "../../press/script/native.js";
import { openWorld, type Scope } from "../../press/script/world.js";

export class Simulation {
  private readonly model: Pointer;
  private readonly data: Pointer;
  private readonly scenes = new Set<Scene>();
  private opened: { readonly buffer: ArrayBuffer; readonly world: Scope } | undefined;

  /** @internal Use Engine.load(). */
  constructor(
    private readonly memory: Memory,
    private handle: Pointer,
  ) {
    this.model = memory.call("mjc_model", handle);
    this.data = memory.call("mjc_data", handle);
  }

  /**
   * The strict world of scripts: `model`, `data`, lookups, functions. Its arrays are MuJoCo's own
   * memory. Loading another model may move that memory, after which this is another world over the
   * same simulation: take it anew each time, and keep nothing of the old one.
   */
  get world(): Scope {
    this.checkAlive();
    const { buffer } = this.memory;
    if (this.opened?.buffer !== buffer) {
      this.opened = { buffer, world: openWorld(this.native()) };
    }
    return this.opened.world;
  }

  /** What MuJoCo's compiler warned of. */
  get warnings(): readonly string[] {
    const lines = this.memory.text(this.call("mjc_warnings"));
    return lines === "" ? [] : lines.split("\n");
  }

  /** The first thing that went wrong since the last reset; "" when nothing did. */
  get trouble(): string {
    return this.memory.text(this.call("mjc_trouble"));
  }

  /** Each of these throws a MujocoError when something is or went wrong. */
  step(count = 1): void {
    this.move("mjc_step", count);
  }
  forward(): void {
    this.move("mjc_forward");
  }
  reset(): void {
    this.move("mjc_reset");
  }
  resetToKeyframe(key: number): void {
    const problem = this.memory.text(this.call("mjc_reset_to_keyframe", key));
    if (problem !== "") throw new MujocoError(problem);
    this.checkTrouble();
  }

  /** The names of all objects of a type (mjtObj), by id; "" for an object without one. */
  namesOf(type: number): string[] {
    const { memory, model } = this;
    return Array.from({ length: this.call("mjc_object_count", type) }, (_, id) =>
      memory.text(memory.call("mj_id2name", model, type, id)),
    );
  }

  /** All that the next step depends on, to keep and put back. */
  get state(): Float64Array {
    return this.withState((state, room) => {
      this.memory.call("mjc_get_state", this.model, this.data, room);
      return state.slice();
    });
  }
  /** What follows from it is not computed yet: forward, or step. */
  set state(kept: Float64Array) {
    this.withState((state, room) => {
      if (kept.length !== state.length) {
        throw new RangeError(`a state of ${kept.length} numbers; this model's has ${state.length}`);
      }
      state.set(kept);
      this.memory.call("mjc_set_state", this.model, this.data, room);
    });
  }

  /** What a page draws. It lives until the simulation is freed. */
  openScene(): Scene {
    const handle = this.call("mjc_scene_new");
    if (handle === 0) throw new MemoryError("the engine has no memory for a scene");
    const scene = new Scene(this.memory, handle);
    this.scenes.add(scene);
    return scene;
  }

  /** Gives the memory back. The simulation, its world and its scenes are not to be used again. */
  free(): void {
    if (this.handle === 0) return;
    for (const scene of this.scenes) scene.free();
    this.call("mjc_free");
    this.handle = 0;
    this.opened = undefined;
  }

  get freed(): boolean {
    return this.handle === 0;
  }

  private native(): Native {
    const { memory, model, data } = this;
    return {
      modelFields: modelFields(memory, model),
      dataFields: dataFields(memory, model, data),
      names: this.names(),
      step: () => this.step(),
      forward: () => this.forward(),
      reset: () => this.reset(),
      functions: nativeFunctions(memory, model, data),
    };
  }

  private names(): Record<number, readonly string[]> {
    const names: Record<number, readonly string[]> = {};
    for (const [constant, type] of Object.entries(constants)) {
      if (constant.startsWith("mjOBJ_")) names[type] = this.namesOf(type);
    }
    return names;
  }

  private withState<T>(use: (state: Float64Array, room: Pointer) => T): T {
    this.checkAlive();
    const size = this.memory.call("mjc_state_size", this.model);
    return this.memory.withRoom(size * 8, (room) =>
      use(new Float64Array(this.memory.buffer, room, size), room),
    );
  }

  private move(name: string, ...args: number[]): void {
    this.call(name, ...args);
    this.checkTrouble();
  }

  private checkTrouble(): void {
    const { trouble } = this;
    if (trouble !== "") throw new MujocoError(trouble);
  }

  private call(name: string, ...args: number[]): number {
    this.checkAlive();
    return this.memory.call(name, this.handle, ...args);
  }

  private checkAlive(): void {
    if (this.handle === 0) throw new TypeError("this simulation was freed");
  }
}
