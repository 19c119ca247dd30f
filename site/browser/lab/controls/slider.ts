/** A slider with its value in words. It acts while it is dragged. */
import type { Slider } from "../lab-module.js";
import { make, newId, setText } from "../markup/element.js";
import { fixed } from "../run/fixed.js";
import type { ControlView, Operate } from "./control-view.js";

/** A browser counts steps in decimal numbers, to the last digit. So an end that rounding has put
 * beyond the last step by less than this part of one would not be reached. */
const hair = 1e-12;

/** The end is a whole number of steps away: the generator sees to it, but for a millionth of a step
 * (generator/lesson/blocks/read_control.cpp). This is a step of which that is so but for rounding. */
function wholeStep({ min, max, step }: Slider): number {
  const way = max - min;
  return (way / Math.round(way / step)) * (1 - hair);
}

function reachesEnd(input: HTMLInputElement, max: number): boolean {
  input.value = String(max);
  return input.valueAsNumber === max;
}

export function sliderView(slider: Slider, operate: Operate): ControlView {
  const { label, min, max, step, digits, unit } = slider;
  const id = newId();
  const input = make("input", { type: "range", id, min, max, step });
  if (!reachesEnd(input, max)) input.step = String(wholeStep(slider));
  const output = make("span", { class: "number" });
  const name = make("label", { for: id }, label);
  const element = make("div", { class: "lab-slider" }, name, output, input);

  const say = (value: number): void => {
    const text = unit === "" ? fixed(value, digits) : `${fixed(value, digits)} ${unit}`;
    setText(output, text);
    input.setAttribute("aria-valuetext", text);
  };
  input.addEventListener("input", () => {
    const chosen = input.valueAsNumber;
    const value = [min, max].find((end) => Math.abs(end - chosen) < step / 2) ?? chosen;
    say(value);
    operate(value);
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
