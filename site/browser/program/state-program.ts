/**
 * "Open the state as a program": a listing below a lab, of a program that begins where the lab is, to be
 * edited and run like the lesson's own. Enter with showStateProgram().
 */
import { make } from "../client/element.js";
import type { ModelFiles } from "../engine/engine.js";
import { Folder } from "./folder.js";

export interface LabState {
  readonly title: string;
  /** Simulated seconds. */
  readonly time: number;
  /** Statements that set the state of `data`. */
  readonly code: string;
  /** Of the model: its main file, "pendulum.xml", and all files. */
  readonly model: string;
  readonly files: ModelFiles;
}

/** What client/programs.ts opens: the listing has what generator/page/blocks/program_data.h gives one. */
export const madeEvent = "program-made";

const folders = new WeakMap<HTMLElement, Folder>();

/** Of a listing that was made here. */
export const madeFolder = (listing: HTMLElement): Folder | undefined => folders.get(listing);

/** A second one of the same lab takes the place of the first. */
export function showStateProgram(lab: HTMLElement, state: LabState): void {
  const name = `state_of_${lab.id.replace(/\W/g, "_")}`;
  const text = programOf(state);
  document.getElementById(`program-${name}`)?.remove();
  const listing = listingOf(lab, name, text);
  folders.set(listing, Folder.made(name, text, state.files));
  lab.after(listing);
  listing.dispatchEvent(new CustomEvent(madeEvent, { bubbles: true }));
  listing.scrollIntoView({ block: "nearest" });
}

function listingOf(lab: HTMLElement, name: string, text: string): HTMLElement {
  const file = make("span", { class: "file" }, `${name}.cpp`);
  const listing = make(
    "figure",
    { class: "example", id: `program-${name}` },
    make("figcaption", {}, file),
    make("pre", { class: "code" }, make("code", {}, text)),
  );
  const { compiler, engine, wasm, style } = lab.dataset;
  const addresses = JSON.parse(compiler!) as Record<string, string>;
  const own = { program: `${name}.cpp`, engine, wasm, labStyle: style };
  Object.assign(listing.dataset, addresses, own);
  return listing;
}

function programOf({ title, time, code, model }: LabState): string {
  const indented = code.trimEnd().replace(/^(?=.)/gm, "  ");
  return `// Begins where the lab “${title}” was at t = ${time.toFixed(3)} s.
#include <cmath>
#include <cstdio>

#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

int main() {
  const Model model = load_model("${model.replace(/\.xml$/, "")}");
  const Data data = make_data(model);

${indented}

  const int steps = static_cast<int>(std::lround(1 / model->opt.timestep));
  for (int i = 0; i < steps; ++i) mj_step(model, data);

  std::printf("t = %.3f s\\n", data->time);
  for (int i = 0; i < model->nq; ++i) std::printf("qpos[%d] = %.6g\\n", i, data->qpos[i]);
  snapshot("a second later", model, data);
}
`;
}
