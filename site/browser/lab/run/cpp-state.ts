/** The state of a simulation as a learner sets it in C++: lines to paste after mj_makeData. */
import type { Simulation } from "../../engine/simulation.js";

/** Fields of mjData that a step begins from, and their size in mjModel's terms. What mj_resetData
 * makes of them need not be said; the time and the two that everybody looks for are said anyway. */
const fields = {
  qpos: "model->nq",
  qvel: "model->nv",
  act: "model->na",
  ctrl: "model->nu",
  mocap_pos: "3 * model->nmocap",
  mocap_quat: "4 * model->nmocap",
  qfrc_applied: "model->nv",
  xfrc_applied: "6 * model->nbody",
} as const;
const always = new Set(["qpos", "qvel"]);

/** As many numbers are set one by one; more are copied from an array. */
const mostAssigned = 3;

const columns = 80;

type Data = Readonly<Record<keyof typeof fields, ArrayLike<number>>> & { readonly time: number };

/** Doubles are written so that a compiler reads the very same bits. */
export function cppState(simulation: Simulation): string {
  const data = simulation.world["data"] as Data;
  const model = simulation.world["model"] as { readonly nq: number; readonly nv: number };
  const lines = [
    `// for a model with nq = ${model.nq} and nv = ${model.nv}`,
    "mj_resetData(model, data);",
    `data->time = ${literal(data.time)};`,
  ];
  for (const [field, size] of Object.entries(fields)) {
    const values = Array.from(data[field as keyof typeof fields]);
    if (always.has(field) || !isDefault(field, values)) lines.push(...setting(field, values, size));
  }
  return [...lines, "mj_forward(model, data);", ""].join("\n");
}

/** Mocap bodies begin where the model has them, the rest at zero. */
function isDefault(field: string, values: readonly number[]): boolean {
  if (values.length === 0) return true;
  return !field.startsWith("mocap") && values.every((value) => value === 0);
}

function setting(field: string, values: readonly number[], size: string): string[] {
  if (values.length <= mostAssigned) {
    return values.map((value, i) => `data->${field}[${i}] = ${literal(value)};`);
  }
  return [
    `const double ${field}[] = {`,
    ...wrapped(values.map(literal)),
    "};",
    `mju_copy(data->${field}, ${field}, ${size});`,
  ];
}

/** The shortest text that is read as the same double: "5" would be an int, "1e21" is a double. */
function literal(value: number): string {
  const text = Object.is(value, -0) ? "-0" : String(value);
  return /[.e]/.test(text) ? text : `${text}.0`;
}

function wrapped(literals: readonly string[]): string[] {
  const lines: string[] = [];
  let line = "   ";
  for (const literal of literals) {
    if (line.length + literal.length + 2 > columns) {
      lines.push(line);
      line = "   ";
    }
    line += ` ${literal},`;
  }
  return [...lines, line];
}
