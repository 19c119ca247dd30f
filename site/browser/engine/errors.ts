/** What can go wrong in the engine, beyond mistakes of ours. */

/** MuJoCo refused, warned or diverged; the text is MuJoCo's or that of physics/simulation.cpp. */
export class MujocoError extends Error {
  override readonly name = "MujocoError";
  /** As press/script/native.ts asks. */
  readonly id = "E-script-mujoco";
}

/** The engine's memory is full. */
export class MemoryError extends Error {
  override readonly name = "MemoryError";
}

/** A model that does not load, with the place in its file. */
export class LoadError extends Error {
  override readonly name = "LoadError";

  constructor(
    message: string,
    /** The file at fault, as it was given. */
    readonly file: string,
    /** From 1; 0 where MuJoCo does not know. */
    readonly line: number,
    readonly column: number,
    /** "did you mean `size`?"; "" when there is nothing to suggest. */
    readonly cure: string,
  ) {
    super(message);
  }
}
