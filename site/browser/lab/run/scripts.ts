/** The scripts and expressions of a lab, run by their index over one simulation. */
import type { Simulation } from "../../engine/simulation.js";
import { withoutGuards } from "../../../press/script/guards.js";
import { asNumber, asTruth } from "../../../press/script/result.js";
import { strictMath } from "../../../press/script/strict-math.js";
import type { Scope } from "../../../press/script/world.js";
import type { Script, ScriptIndex } from "../lab-module.js";
import { ScriptTrouble, scriptTrouble } from "./trouble.js";

/** Each method throws a ScriptTrouble when the script throws or gives something else. */
export class Scripts {
  readonly #scripts: readonly Script[];
  readonly #simulation: Simulation;
  #random = strictMath();
  /** The world that scripts see, made of the simulation's world `of`. */
  #world: { readonly of: Scope; readonly scope: Scope } | undefined;

  constructor(scripts: readonly Script[], simulation: Simulation) {
    this.#scripts = scripts;
    this.#simulation = simulation;
  }

  /** Math.random() begins again, as it does for each run of the rehearsal. */
  restart(): void {
    this.#random = strictMath();
    this.#world = undefined;
  }

  run(index: ScriptIndex): void {
    this.#call(index, this.#scope, () => undefined);
  }

  /** Runs a slider's `write`, in whose world `value` is a name too. */
  write(index: ScriptIndex, value: number): void {
    this.#call(index, { ...this.#scope, value }, () => undefined);
  }

  number(index: ScriptIndex): number {
    return this.#call(index, this.#scope, asNumber);
  }

  /** What number() gives, or the trouble that it throws. */
  tryNumber(index: ScriptIndex): number | ScriptTrouble {
    try {
      return this.number(index);
    } catch (error) {
      if (error instanceof ScriptTrouble) return error;
      throw error;
    }
  }

  truth(index: ScriptIndex): boolean {
    return this.#call(index, this.#scope, asTruth);
  }

  /** Memory may have moved since the last script: then the simulation has another world. */
  get #scope(): Scope {
    const { world } = this.#simulation;
    if (this.#world?.of !== world) {
      this.#world = { of: world, scope: { ...world, Math: this.#random } };
    }
    return this.#world.scope;
  }

  #call<T>(index: ScriptIndex, scope: Scope, as: (value: unknown) => T): T {
    const script = this.#scripts[index]!;
    try {
      return as(script(scope));
    } catch (error) {
      throw scriptTrouble(error, authorsText(script));
    }
  }
}

/** The generator puts a line before and a line after what the author wrote, and its guards into it. */
function authorsText(script: Script): string {
  return withoutGuards(String(script).split("\n").slice(1, -1).join("\n"));
}
