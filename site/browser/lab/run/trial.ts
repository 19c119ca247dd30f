/**
 * What a link brings, done to a run of its own before it is done to the page's: the same steps in the same
 * order. It may hang, take all memory or trap, as a model may be anything, so trial-worker.ts does it where
 * that costs nothing. Enter with tryLink().
 */
import type { Simulation } from "../../engine/simulation.js";
import type { LabLink } from "./lab-link.js";
import type { Run } from "./run.js";

/** How much more a link's model may have than the lesson's. */
const most = { nbody: 1000, ngeom: 1000, nv: 1000, bytes: 1 << 26 } as const;

/** Nothing interrupts a step. */
const mostIterations = 1000;

/** What may show only once it moves: a shadow that has to catch up, bodies inside of one another. */
const steps = 20;

const names: Readonly<Record<keyof typeof most, string>> = {
  nbody: "bodies",
  ngeom: "geoms",
  nv: "degrees of freedom",
  bytes: "bytes of memory",
};

/** Why it is not for the page, as a clause; undefined for what may be. `run` is as the lesson begins. */
export function tryLink(run: Run, link: LabLink): string | undefined {
  if (link.mjcf !== undefined && run.lab.editable !== null) {
    const own = sizesOf(run.simulation);
    const error = run.recompile(link.mjcf);
    if (error) return `its model does not compile: ${error.message}`;
    const fault = excess(own, sizesOf(run.simulation)) ?? tooMany(run.simulation);
    if (fault !== undefined) return fault;
  }
  if (link.run) run.restore(link.run);
  if (link.overlays) run.visualization.overlays = link.overlays;
  run.visualization.update();
  run.step(steps);
  return undefined;
}

type Sizes = Readonly<Record<keyof typeof most, number>>;

function sizesOf({ world }: Simulation): Sizes {
  const { nbody, ngeom, nv, nbuffer } = world["model"] as Record<string, number>;
  const data = world["data"] as Record<string, number>;
  const bytes = nbuffer! + data["nbuffer"]! + 8 * data["nstack"]!;
  return { nbody: nbody!, ngeom: ngeom!, nv: nv!, bytes };
}

function excess(own: Sizes, its: Sizes): string | undefined {
  for (const name of Object.keys(most) as (keyof Sizes)[]) {
    const limit = own[name] + most[name];
    if (its[name] > limit) {
      return `its model has ${its[name]} ${names[name]}, and a link’s may have ${limit} here`;
    }
  }
  return undefined;
}

function tooMany({ world }: Simulation): string | undefined {
  const { opt } = world["model"] as { readonly opt: Readonly<Record<string, number>> };
  for (const name of ["iterations", "noslip_iterations", "mpr_iterations"]) {
    if (opt[name]! > mostIterations) {
      return `its model sets ${name} to ${opt[name]!}, and a link’s may have ${mostIterations}`;
    }
  }
  return undefined;
}
