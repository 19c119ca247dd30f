/** What is wrong with a plot, and where in its JSON; the generator finds the place in the lesson. */

export type Path = readonly (string | number)[];

export interface Fault {
  readonly id: string;
  readonly message: string;
  readonly cure: string;
  readonly path: Path;
  /** The last step of the path is itself what is wrong, not its value. */
  readonly key: boolean;
  /** A part of the string at `path`, in bytes; 0 and 0 for all of the value. */
  readonly from: number;
  readonly to: number;
}

export function fault(id: string, path: Path, message: string, cure = ""): Fault {
  return { id, message, cure, path, key: false, from: 0, to: 0 };
}

/** Ends a drawing that something is wrong with. */
export class Refused extends Error {
  readonly fault: Fault;

  constructor(found: Fault) {
    super(found.message);
    this.fault = found;
  }
}
