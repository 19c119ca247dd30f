/**
 * What passes from the generator to the page: the module that it writes for each lab
 * (generator/page/blocks/lab_module.cpp), and the marks that it leaves in the lesson for the script to find.
 *
 * The module is `labs/NUMBER-INDEX-HASH.js`. Its `lab` is JSON; wherever an author's script or
 * expression belongs, there is its index in `scripts`. So the page evaluates no text.
 */
import type { Scope } from "../../press/script/world.js";

/** An author's script, or an expression whose value it returns. The author's text is whole lines of
 * the function: the first and the last line are the generator's. */
export type Script = (world: Scope) => unknown;

/** Index in `LabModule.scripts`. */
export type ScriptIndex = number;

export interface LabModule {
  readonly lab: LabDescription;
  readonly scripts: readonly Script[];
}

export interface LabDescription {
  readonly title: string;
  readonly model: ModelSource;
  /** Of the live view, in CSS pixels. */
  readonly height: number;
  readonly camera: CameraPlace;
  /** The overlays that the reader may switch. */
  readonly toggles: readonly string[];
  /** The overlays that are on from the start, MuJoCo's own choice among them. */
  readonly overlays: readonly string[];
  readonly controls: readonly Control[];
  readonly readouts: readonly Readout[];
  readonly plots: readonly Plot[];
  /** Simulated seconds in a second, 0.1 to 4. */
  readonly speed: number;
  readonly predict: Predict | null;
  readonly goal: Goal | null;
  readonly ghost: Ghost | null;
  readonly editable: Editable | null;
}

export interface ModelSource {
  /** The file to load: "joint_zoo.xml". */
  readonly name: string;
  /** The text of that file and of the MJCF files that it includes, by name. */
  readonly texts: Readonly<Record<string, string>>;
  /** Meshes, textures and height fields by name: addresses relative to the module. */
  readonly assets: Readonly<Record<string, string>>;
}

/** MuJoCo's free camera: degrees, degrees, metres, metres. */
export interface CameraPlace {
  readonly azimuth: number;
  readonly elevation: number;
  readonly distance: number;
  readonly target: readonly [number, number, number];
}

/** After a control's script, forward() is called, in the build as in the page. */
export type Control = Button | Slider | Toggle | Select | Keyframe;

export interface Button {
  readonly type: "button";
  readonly label: string;
  readonly run: ScriptIndex;
}

export interface Slider {
  readonly type: "slider";
  readonly label: string;
  /** What it is bound to, as text: "data.ctrl[0]". */
  readonly bind: string;
  /** Gives the value. */
  readonly read: ScriptIndex;
  /** Sets it to `value`, a name in the world that is given to this script alone. */
  readonly write: ScriptIndex;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  /** Null: it starts with what `read` gives. */
  readonly value: number | null;
  readonly digits: number;
  readonly unit: string;
}

export interface Toggle {
  readonly type: "toggle";
  readonly label: string;
  readonly on: ScriptIndex;
  readonly off: ScriptIndex;
  readonly value: boolean;
}

export interface Select {
  readonly type: "select";
  readonly label: string;
  readonly options: readonly { readonly label: string; readonly run: ScriptIndex }[];
  /** The option whose script runs at every reset. Null: none does, and none is chosen. */
  readonly value: number | null;
}

export interface Keyframe {
  readonly type: "keyframe";
  readonly label: string;
  readonly key: number;
}

export interface Trace {
  readonly label: string;
  readonly value: ScriptIndex;
}

export interface Readout extends Trace {
  readonly digits: number;
  readonly unit: string;
}

export interface Plot {
  readonly ylabel: string;
  /** Seconds. */
  readonly window: number;
  readonly ymin: number | null;
  readonly ymax: number | null;
  /** At most four: they wear the four data colours, in order. */
  readonly traces: readonly Trace[];
}

/** The reader guesses `value`; then, from a reset, `run` runs and `seconds` are simulated. */
export interface Predict {
  /** HTML, as are all texts below that are not labels. */
  readonly question: string;
  readonly run: ScriptIndex | null;
  readonly seconds: number;
  readonly value: ScriptIndex;
  readonly digits: number;
  readonly unit: string;
  /** How far off a good guess may be. */
  readonly tolerance: number;
  readonly explanation: string;
}

export interface Goal {
  readonly text: string;
  /** True when the reader has done it. */
  readonly done: ScriptIndex;
}

/** A second run from the same start, for which `run` ran once after the reset; controls act on
 * both. It is drawn as a shadow of the first, its traces dashed. */
export interface Ghost {
  readonly label: string;
  readonly run: ScriptIndex;
}

/** The reader edits the MJCF of the main file. */
export interface Editable {
  /** Each is a number that the reader gives and the compiled model judges, once the goal is reached
   * if there is one. */
  readonly tasks: readonly Task[];
}

export interface Task {
  readonly question: string;
  readonly value: ScriptIndex;
  readonly tolerance: number;
  readonly unit: string;
}
