/**
 * "Look at where it ended": a lab of the model that the reader's run loaded, in the states of which it
 * made snapshots. The lab's code is loaded when the reader asks for it, and what it takes of the engine's
 * memory is given back before the next run.
 */
import { make } from "../client/element.js";
import type { LoadedModel } from "../cpp/messages.js";
import type { Engine, ModelFiles } from "../engine/engine.js";
import type { CameraPlace, LabModule } from "../lab/lab-module.js";
import type { Scope } from "../../press/script/world.js";
import type { Snapshot } from "./records.js";

export interface EndOfRun {
  readonly snapshots: ReadonlyMap<string, Snapshot>;
  readonly model: LoadedModel;
  /** What the model may name. */
  readonly files: ModelFiles;
}

/** Degrees: from a little above, and aside. */
const outlook = { azimuth: 120, elevation: -20 } as const;
/** Half of MuJoCo's field of view, 45°. */
const halfView = Math.PI / 8;
const height = 320;

export class EndedLab {
  /** Where it is offered. */
  readonly element = make("p", { class: "program-ended", hidden: "" });
  readonly #listing: HTMLElement;
  readonly #program: string;
  readonly #say: (text: string) => void;
  readonly #button = make("button", { type: "button", class: "plain-button" });
  #end: EndOfRun | undefined;
  #lab: { close(): void } | undefined;
  #place: HTMLElement | undefined;

  /** `listing` is the program's figure, below which the lab comes; `program` its name. */
  constructor(listing: HTMLElement, program: string, say: (text: string) => void) {
    this.#listing = listing;
    this.#program = program;
    this.#say = say;
    this.#button.textContent = "Look at where it ended";
    this.#button.addEventListener("click", () => void this.#open());
    this.element.append(this.#button);
  }

  offer(end: EndOfRun): void {
    this.#end = end;
    this.element.hidden = false;
  }

  close(): void {
    this.#end = undefined;
    this.element.hidden = true;
    this.#lab?.close();
    this.#place?.remove();
    this.#lab = this.#place = undefined;
  }

  async #open(): Promise<void> {
    const end = this.#end;
    if (!end || this.#place) return;
    const place = (this.#place = placeOf(this.#listing, this.#program));
    this.#button.ariaBusy = "true";
    try {
      const { openMadeLab } = await import("../lab/lab.js");
      const lab = await openMadeLab(place, (engine) => {
        const { left, ...made } = labOf(engine, this.#program, end);
        if (left) this.#say(left);
        return made;
      });
      if (this.#place === place) this.#lab = lab;
      else lab.close(); // meanwhile it was run again
      this.element.hidden = true;
      place.querySelector<HTMLElement>("button")?.focus();
    } catch (error) {
      this.#refuse(error, place);
    } finally {
      this.#button.ariaBusy = null;
    }
  }

  /** A Refusal has a sentence for the reader (lab/lab.ts). */
  #refuse(error: unknown, place: HTMLElement): void {
    place.remove();
    if (this.#place === place) this.#place = undefined;
    const isRefusal = error instanceof Error && /^(Refusal|NoMemory)$/.test(error.name);
    if (!isRefusal) reportError(error);
    this.#say(
      isRefusal ? error.message : "The lab could not be opened, and the console tells why.",
    );
  }
}

/** The elements of lab.hbs, below the listing. */
function placeOf(listing: HTMLElement, program: string): HTMLElement {
  const { id } = listing;
  const titleId = `${id}-ended-title`;
  const alt = `The model where your run of ${program}.cpp ended.`;
  const title = make("figcaption", { id: titleId }, `Where your run of ${program}.cpp ended`);
  const picture = make("picture", {}, make("img", { alt, hidden: "" }));
  const figure = make(
    "figure",
    { "aria-labelledby": titleId },
    title,
    make("div", { class: "lab-view" }, picture),
    make("p", { class: "lab-status", role: "status" }),
    make("div", { class: "lab-body" }),
  );
  const lab = document.createElement("sim-lab");
  lab.id = `${id}-ended`;
  lab.className = "lab made";
  const { engine, wasm, labStyle, code, style, worker, llvm, pack, bytes } = listing.dataset;
  const compiler = JSON.stringify({ code, style, worker, llvm, pack, bytes });
  Object.assign(lab.dataset, { engine, wasm, style: labStyle, compiler });
  lab.append(figure);
  listing.after(lab);
  return lab;
}

function labOf(engine: Engine, program: string, { snapshots, model, files }: EndOfRun) {
  const { name } = model;
  const all = { ...files, ...model.files };
  const { states, left, camera } = shownStates(engine, name, all, [...snapshots]);
  const last = states.length - 1;
  const module: LabModule = {
    lab: {
      title: `Where your run of ${program}.cpp ended`,
      model: { name, texts: {}, assets: {} },
      height,
      camera,
      toggles: ["contacts", "forces", "joints", "frames", "transparent"],
      overlays: [],
      controls: [
        {
          type: "select",
          label: "Snapshot",
          options: states.map(([label], run) => ({ label, run })),
          value: last,
        },
      ],
      readouts: [],
      plots: [],
      speed: 1,
      predict: null,
      goal: null,
      ghost: null,
      editable: null,
    },
    scripts: states.map(
      ([, state]) =>
        (world: Scope) =>
          put(state, world),
    ),
  };
  return { module, files: all, left };
}

type Data = Record<string, number[] | number>;

function put({ time, fields }: Snapshot, world: Scope): void {
  const data = world["data"] as Data;
  data["time"] = time;
  for (const [field, numbers] of fields) {
    numbers.forEach((number, i) => ((data[field] as number[])[i] = number));
  }
}

/** Those of the model, and from where all geoms of the last one are seen that have an end. */
function shownStates(
  engine: Engine,
  name: string,
  files: ModelFiles,
  snapshots: readonly (readonly [string, Snapshot])[],
): { readonly states: typeof snapshots; readonly left: string; readonly camera: CameraPlace } {
  const simulation = engine.load(name, files);
  try {
    const states = snapshots.filter(([, state]) => fits(state, simulation.world));
    const last = states.at(-1);
    const others = snapshots.filter((one) => !states.includes(one)).map(([label]) => label);
    const left = others.length > 0 ? `Left out: “${others.join("”, “")}”, which ${misfit}` : "";
    if (!last) throw new Refusal(`There is nothing to look at. ${left}`);
    put(last[1], simulation.world);
    simulation.forward();
    return { states, left, camera: { ...outlook, ...surroundings(simulation.world) } };
  } finally {
    simulation.free();
  }
}

/** Has a sentence for the reader. */
class Refusal extends Error {
  override readonly name = "Refusal";
}

const misfit =
  "has numbers that are not finite, or is of another model than the one that the program loaded last.";

/** What is not finite is no number in a record. */
function fits({ fields }: Snapshot, world: Scope): boolean {
  const data = world["data"] as Readonly<Record<string, ArrayLike<number>>>;
  return [...fields].every(
    ([field, numbers]) => data[field]?.length === numbers.length && numbers.every(Number.isFinite),
  );
}

function surroundings(world: Scope): Pick<CameraPlace, "target" | "distance"> {
  const { geom_rbound: radii } = world["model"] as { readonly geom_rbound: ArrayLike<number> };
  const { geom_xpos: centers } = world["data"] as { readonly geom_xpos: ArrayLike<number> };
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  for (let geom = 0; geom < radii.length; ++geom) {
    const radius = radii[geom]!;
    if (radius === 0) continue; // a plane
    for (let axis = 0; axis < 3; ++axis) {
      const center = centers[3 * geom + axis]!;
      least[axis] = Math.min(least[axis]!, center - radius);
      most[axis] = Math.max(most[axis]!, center + radius);
    }
  }
  if (least[0] === Infinity) return { target: [0, 0, 0], distance: 1 };
  const middle = (axis: 0 | 1 | 2): number => (least[axis]! + most[axis]!) / 2;
  const diagonal = Math.hypot(...most.map((end, axis) => end - least[axis]!));
  return {
    target: [middle(0), middle(1), middle(2)],
    distance: diagonal / 2 / Math.sin(halfView),
  };
}
