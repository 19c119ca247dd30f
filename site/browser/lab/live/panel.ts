/** What stands below the view: what is asked, the controls, the readings, the curves, what is shown,
 * the menus, the editor. */
import { Controls } from "../controls/controls.js";
import { make } from "../markup/element.js";
import type { LabDescription } from "../lab-module.js";
import { EditPanel } from "../panel/edit-panel.js";
import { Goal } from "../panel/goal.js";
import { Overlays } from "../panel/overlays.js";
import { Predict } from "../panel/predict.js";
import { Readouts } from "../panel/readouts.js";
import { taskForm } from "../panel/task.js";
import { Plot } from "../plot/plot.js";
import { PushForm } from "../view/push-form.js";
import type { Player } from "./player.js";

export class Panel {
  readonly element = make("div", { class: "lab-body lab-live" });
  readonly push: PushForm;
  readonly edit: EditPanel | undefined;
  readonly #player: Player;
  readonly #predict: Predict | undefined;
  readonly #goal: Goal | undefined;
  readonly #controls: Controls;
  readonly #readouts: Readouts;
  readonly #plots: readonly Plot[];
  readonly #overlays: Overlays;
  /** A prediction is being measured. */
  #asked = false;

  /** `menus` are the openers of the last row; `rebuilt` is called when the model is another one. */
  constructor(player: Player, menus: readonly Node[], rebuilt: () => void) {
    const { run } = player;
    const { lab } = run;
    this.#player = player;
    this.#predict = lab.predict === null ? undefined : new Predict(lab.predict, () => this.#ask());
    this.#goal = lab.goal === null ? undefined : new Goal(lab.goal);
    this.#controls = new Controls(lab.controls, (index, value) => player.operate(index, value));
    this.#readouts = new Readouts(lab.readouts);
    this.#plots = lab.plots.map((plot, i) => new Plot(plot, run.samples[i]!));
    this.#overlays = new Overlays(lab.toggles, (name, on) => {
      run.visualization.showOverlay(name, on);
      player.changed();
    });
    this.push = new PushForm(player);
    this.edit = editPanel(lab, run, rebuilt);
    const row = make("div", { class: "lab-menus" }, ...menus, this.push.opener);
    const tasks = [this.#predict?.element, this.#goal?.element];
    const label = lab.readouts.length === 0 ? [] : [make("p", { class: "lab-label" }, "Readings")];
    const plots = this.#plots.map(({ element }) => element);
    const readings = [...label, this.#readouts.element, ...plots];
    const rest = [this.#overlays.element, row, this.push.element, this.edit?.element];
    const parts = [...tasks, this.#controls.element, ...readings, ...rest];
    this.element.append(...parts.filter((part) => part !== undefined));
  }

  refresh(): void {
    const { run, playing } = this.#player;
    const { lab } = run;
    this.#controls.show(run.settings);
    this.#readouts.show(lab.readouts.map((_, i) => run.printed(i)));
    this.#overlays.show(run.visualization.overlays);
    this.#goal?.show(run.goalReached);
    this.#plots.forEach((plot, i) => {
      plot.show(run.samples[i]!, run.time);
      if (!playing) plot.tell(run.samples[i]!, run.time);
    });
    this.#followPrediction();
  }

  #ask(): void {
    this.#asked = true;
    this.#player.run.predict();
    this.#player.play();
  }

  #followPrediction(): void {
    const { run } = this.#player;
    if (!this.#asked || run.predicting) return;
    this.#asked = false;
    if (run.measured === undefined) this.#predict!.forget();
    else this.#predict!.answer(run.measured);
  }
}

function editPanel(lab: LabDescription, run: Player["run"], rebuilt: () => void) {
  if (lab.editable === null) return undefined;
  const tasks = lab.editable.tasks.map((task, i) => taskForm(run, task, i));
  return new EditPanel(run, tasks, rebuilt);
}
