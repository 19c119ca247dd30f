/**
 * What the strict world needs from the engine under it: the one interface with two implementations,
 * MuJoCo linked into the generator (generator/script/native_world.cpp) and MuJoCo compiled to
 * WebAssembly in the page. Any side that gives these gets the same results of the same scripts.
 */

/** Numbers as MuJoCo stores them: double, float, int, and byte. */
export type Numbers = Float64Array | Float32Array | Int32Array | Uint8Array;

/** An array or a number of mjModel or mjData; a row of the field table (physics/field_table.h). */
export interface Field {
  /** "" for the struct itself, else the struct inside it: "opt", "vis.global". */
  readonly owner: string;
  /** MuJoCo's name. */
  readonly name: string;
  /**
   * MuJoCo's own memory, `rows * columns` numbers, row major: a write is seen by the next step. It
   * must stay valid as long as the world; the page opens a new world when its memory has moved. It
   * may be made when it is first read.
   */
  readonly view: Numbers;
  readonly rows: number;
  readonly columns: number;
  /** A number and not an array; its view has one element. */
  readonly scalar: boolean;
  /** C's int: the view is an Int32Array. */
  readonly integer: boolean;
}

/**
 * A MuJoCo function under its own name, in C's argument order without the model and the data.
 * Pointers are Float64Arrays, already checked for length, and are written in place.
 */
export type NativeFunction = (...args: (number | Float64Array)[]) => number | undefined;

/**
 * Every function may throw an Error whose `id` is "E-script-mujoco": MuJoCo refused, warned or
 * diverged.
 */
export interface Native {
  /** All fields that hold numbers; text fields are left out. */
  readonly modelFields: readonly Field[];
  readonly dataFields: readonly Field[];
  /**
   * For each mjtObj of constants.ts the names of its objects, by id; "" for an object without one.
   * mjOBJ_XBODY has the bodies, as mjOBJ_BODY.
   */
  readonly names: Readonly<Record<number, readonly string[]>>;
  /** One mj_step. */
  readonly step: () => void;
  readonly forward: () => void;
  readonly reset: () => void;
  /** The functions that mujoco-functions.ts lists. */
  readonly functions: Readonly<Record<string, NativeFunction>>;
}
