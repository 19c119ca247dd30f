/**
 * A model's numbers as they lie in MuJoCo's memory, without the proxies that watch an author's
 * script. An array is to be used at once: memory may move when another model is loaded.
 */
import type { Simulation } from "../../engine/simulation.js";
import type { Numbers } from "../../../press/script/native.js";
import { viewOf } from "../../../press/script/strict-array.js";

export class ModelFields {
  constructor(private readonly simulation: Simulation) {}

  /** An array by MuJoCo's name: "mesh_vert", "vis.rgba.haze". */
  array(name: string): Numbers {
    return viewOf(this.member(name))!;
  }

  /** A number by MuJoCo's name: "stat.extent". */
  number(name: string): number {
    return this.member(name) as number;
  }

  private member(name: string): unknown {
    let found = this.simulation.world["model"];
    for (const part of name.split(".")) found = (found as Record<string, unknown>)[part];
    return found;
  }
}
