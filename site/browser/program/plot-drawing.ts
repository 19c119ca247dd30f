/**
 * Draws a plot as the build does, of other numbers. It brings Vega, which is large: import it once a
 * plot is to be drawn.
 */
import { drawForPage, type Drawings } from "../../press/script/plot/frames.js";
import type { Fault } from "../../press/script/plot/fault.js";
import { rowsOf, specOf, type Columns } from "../../press/script/plot/written.js";

/** `json` is the plot as its author wrote it, `id` what begins the ids of its drawings. Rejects with
 * what keeps it from being drawn. */
export async function drawPlot(json: string, columns: Columns, id: string): Promise<Drawings> {
  const faults: Fault[] = [];
  const drawings = await drawForPage(specOf(json), rowsOf(columns), id, faults);
  const [fault] = faults;
  if (fault !== undefined) throw new Error(fault.message);
  return drawings;
}
