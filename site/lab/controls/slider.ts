/** A slider with its value in words. It acts while it is dragged. */
import type { Slider } from "../lab-module.js";
import { make, newId, setText } from "../markup/element.js";
import { fixed } from "../run/fixed.js";
import type { ControlView, Operate } from "./control-view.js";

export function sliderView(slider: Slider, operate: Operate): ControlView {
  const { label, min, max, step, digits, unit } = slider;
  const id = newId();
  const input = make("input", { type: "range", id, min, max, step });
  const output = make("span", { class: "number" });
  const name = make("label", { for: id }, label);
  const element = make("div", { class: "lab-slider" }, name, output, input);

  const say = (value: number): void => {
    const text = unit === "" ? fixed(value, digits) : `${fixed(value, digits)} ${unit}`;
    setText(output, text);
    input.setAttribute("aria-valuetext", text);
  };
  input.addEventListener("input", () => {
    say(input.valueAsNumber);
    operate(input.valueAsNumber);
  });
  return {
    element,
    wide: true,
    show(value) {
      if (typeof value !== "number") return;
      // Not while it is dragged: the thumb would be torn from under the finger.
      if (!input.matches(":active")) input.value = String(value);
      say(value);
    },
  };
}
