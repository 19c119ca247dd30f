/** The controls of a lesson, in its order. */
import type { Control } from "../lab-module.js";
import { make } from "../markup/element.js";
import type { ControlValue } from "../run/controls.js";
import { buttonView } from "./button.js";
import type { ControlView, Operate } from "./control-view.js";
import { selectView } from "./select.js";
import { sliderView } from "./slider.js";
import { toggleView } from "./toggle.js";

export class Controls {
  readonly element = make("ul", { class: "controls" });
  readonly #views: readonly ControlView[];

  constructor(controls: readonly Control[], operate: (index: number, value: ControlValue) => void) {
    this.#views = controls.map((control, i) => viewOf(control, (value) => operate(i, value)));
    for (const { element, wide } of this.#views) {
      this.element.append(make("li", { class: wide && "wide" }, element));
    }
    this.element.hidden = controls.length === 0;
  }

  show(values: readonly ControlValue[]): void {
    this.#views.forEach((view, i) => view.show?.(values[i]!));
  }
}

function viewOf(control: Control, operate: Operate): ControlView {
  switch (control.type) {
    case "button":
    case "keyframe":
      return buttonView(control.label, operate);
    case "slider":
      return sliderView(control, operate);
    case "toggle":
      return toggleView(control, operate);
    case "select":
      return selectView(control, operate);
  }
}
