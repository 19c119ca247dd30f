/** What stopped a run, as a reader is told. */
import { MujocoError } from "../../engine/errors.js";
import { Fault } from "../../script/fault.js";

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

/** Why a lab's model does not start here, which the build could simulate: a page has less memory, and
 * all its labs share it. */
export function whyNoStart(error: unknown): string {
  const message = error instanceof Error ? error.message : String(error);
  if (!/alloc|memory|bytes left/i.test(message)) return `The lab could not be started: ${message}`;
  return (
    "The page has no memory left for this lab’s model, so it stays a picture. Reload the page and " +
    "play this lab first."
  );
}

/** `error` as trouble; mistakes of ours are thrown on. */
export function troubleOf(error: unknown): Trouble {
  if (error instanceof ScriptTrouble) return error;
  if (error instanceof MujocoError) return { message: error.message, cure: "", source: "" };
  throw error;
}

/** What a script threw, with the script. */
export function scriptTrouble(error: unknown, source: string): ScriptTrouble {
  const message = error instanceof Error ? error.message : String(error);
  return new ScriptTrouble(message, error instanceof Fault ? error.cure : "", source);
}
