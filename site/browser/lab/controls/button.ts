/** A button of the lesson, and one that puts the model into a keyframe: both act and keep no value. */
import { make } from "../markup/element.js";
import type { ControlView, Operate } from "./control-view.js";

export function buttonView(label: string, operate: Operate): ControlView {
  const element = make("button", { type: "button", class: "lab-button" }, label);
  element.addEventListener("click", () => operate(null));
  return { element, wide: false };
}
