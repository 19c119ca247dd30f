/**
 * What a link brings, done to a run of its own before it is done to the page's: the same steps in the same
 * order. It may hang, take all memory or trap, as a model may be anything, so trial-worker.ts does it where
 * that costs nothing. Enter with tryLink().
 */
import { geomOf } from "../stage/geom.js";
import { ModelFields } from "../stage/model-fields.js";
import { cornersOf, qualityOf } from "../stage/quality.js";
import type { LabLink } from "./lab-link.js";
import type { Run } from "./run.js";

/** How much more a link's model may have than the lesson's. Nothing is drawn here, so what the page would
 * make of the model to draw it is counted: with all overlays, as its reader may want to see them. */
const most = {
  nbody: 1000,
  ngeom: 1000,
  nv: 1000,
  bytes: 1 << 26,
  pixels: 1 << 22,
  shapes: 5000,
  corners: 1 << 22,
} as const;

type Size = keyof typeof most;

/** Nothing interrupts a step. */
const mostIterations = 1000;

/** What may show only once it moves: a shadow that has to catch up, bodies inside of one another. */
const steps = 20;

const names: Readonly<Record<Size, string>> = {
  nbody: "bodies",
  ngeom: "geoms",
  nv: "degrees of freedom",
  bytes: "bytes of memory",
  pixels: "pixels of textures",
  shapes: "shapes to draw",
  corners: "corners of shapes to draw",
};

/** The corners last: only so many shapes are looked at. */
const sizes: Readonly<Record<Size, (run: Run) => number>> = {
  nbody: (run) => modelOf(run).number("nbody"),
  ngeom: (run) => modelOf(run).number("ngeom"),
  nv: (run) => modelOf(run).number("nv"),
  bytes: bytesOf,
  pixels: pixelsOf,
  shapes: (run) => run.scene.geomCount,
  corners: cornersToDraw,
};

/** Why it is not for the page, as a clause; undefined for what may be. `run` is as the lesson begins. */
export function tryLink(run: Run, link: LabLink): string | undefined {
  const bound =
    link.mjcf !== undefined && run.lab.editable !== null ? boundsBeside(run) : undefined;
  if (bound) {
    const error = run.recompile(link.mjcf!);
    if (error) return `its model does not compile: ${error.message}`;
    const fault = bound() ?? tooMany(run);
    if (fault !== undefined) return fault;
  }
  if (link.run) run.restore(link.run);
  if (link.overlays) run.visualization.overlays = link.overlays;
  run.visualization.update();
  const fault = bound?.();
  if (fault !== undefined) return fault;
  run.step(steps);
  return undefined;
}

/** What tells why the model that `run` has later is too large, beside the one that it has now. */
function boundsBeside(run: Run): () => string | undefined {
  const all = Object.keys(most) as Size[];
  const showAll = () => {
    run.visualization.overlays = run.scene.overlays;
    run.visualization.update();
  };
  showAll();
  const limits = new Map(all.map((size) => [size, sizes[size](run) + most[size]]));
  return () => {
    showAll();
    for (const [size, limit] of limits) {
      const its = sizes[size](run);
      if (its > limit) {
        return `its model has ${its} ${names[size]}, and a link’s may have ${limit} here`;
      }
    }
    return undefined;
  };
}

function modelOf({ simulation }: Run): ModelFields {
  return new ModelFields(simulation);
}

function bytesOf(run: Run): number {
  const data = run.simulation.world["data"] as Readonly<Record<string, number>>;
  return modelOf(run).number("nbuffer") + data["nbuffer"]! + 8 * data["nstack"]!;
}

function pixelsOf(run: Run): number {
  const heights = modelOf(run).array("tex_height");
  const widths = Array.from(modelOf(run).array("tex_width"));
  return widths.reduce((sum, width, i) => sum + width * heights[i]!, 0);
}

function cornersToDraw(run: Run): number {
  const model = modelOf(run);
  const quality = qualityOf(model);
  return run.scene.geoms.reduce((sum, geom) => sum + cornersOf(geomOf(geom), model, quality), 0);
}

function tooMany(run: Run): string | undefined {
  for (const name of ["iterations", "noslip_iterations", "mpr_iterations"]) {
    const count = modelOf(run).number(`opt.${name}`);
    if (count > mostIterations) {
      return `its model sets ${name} to ${count}, and a link’s may have ${mostIterations}`;
    }
  }
  return undefined;
}
