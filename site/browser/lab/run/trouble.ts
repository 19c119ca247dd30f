/** What stopped a run, as a reader is told. */
import { LoadError, MemoryError, MujocoError } from "../../engine/errors.js";
import { Fault } from "../../../press/script/fault.js";

export interface Trouble {
  /** What happened; MuJoCo's words, or those of the strict world of scripts. */
  readonly message: string;
  /** What to do about it; "" when there is nothing to suggest. */
  readonly cure: string;
  /** The author's script in which it happened; "" when it was in no script. */
  readonly source: string;
}

/** A script that threw. */
export class ScriptTrouble extends Error implements Trouble {
  override readonly name = "ScriptTrouble";

  constructor(
    message: string,
    readonly cure: string,
    readonly source: string,
  ) {
    super(message);
  }
}

/** MuJoCo's words where it got no memory; not those of a reader, who may name a body `memory`. */
const withoutMemory =
  /^(?:object '[^']*': )?(?:\w+: )?could not (?:allocate|create mjData)|^std::bad_alloc$/i;

/** A page has less memory than the build, and all its labs share it. */
export function isOutOfMemory(error: unknown): boolean {
  return error instanceof MemoryError || withoutMemory.test(wordsOf(error));
}

/** Why a lab's model does not start here, which the build could simulate. */
export function whyNoStart(error: unknown): string {
  if (!isOutOfMemory(error)) return `The lab could not be started: ${wordsOf(error)}`;
  return (
    "The page has no memory left for this lab’s model, so it stays a picture. Reload the page and " +
    "play this lab first."
  );
}

/** Why the reader's model, edited in the file `name`, is not the lab's. */
export function whyNoEdit(error: unknown, name: string): LoadError {
  if (isOutOfMemory(error)) {
    const cure =
      "smaller meshes, textures and height fields, or a smaller `njmax`, `nconmax` or `nstack` in " +
      "its `<size>`";
    return new LoadError("the page has no memory left for this model", name, 0, 0, cure);
  }
  if (error instanceof LoadError) return error;
  return new LoadError(wordsOf(error), name, 0, 0, "");
}

/** `error` as trouble; mistakes of ours are thrown on. */
export function troubleOf(error: unknown): Trouble {
  if (error instanceof ScriptTrouble) return error;
  if (error instanceof MujocoError) return { message: error.message, cure: "", source: "" };
  throw error;
}

/** What a script threw, with the script. */
export function scriptTrouble(error: unknown, source: string): ScriptTrouble {
  return new ScriptTrouble(wordsOf(error), error instanceof Fault ? error.cure : "", source);
}

function wordsOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
