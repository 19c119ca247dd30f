/** A checkbox with the look of a switch. */
import type { Toggle } from "../lab-module.js";
import { make } from "../markup/element.js";
import type { ControlView, Operate } from "./control-view.js";

export function toggleView({ label, value }: Toggle, operate: Operate): ControlView {
  const input = make("input", { type: "checkbox", role: "switch", class: "lab-switch" });
  input.checked = value;
  input.addEventListener("change", () => operate(input.checked));
  return {
    element: make("label", { class: "lab-check" }, input, label),
    wide: false,
    show(on) {
      input.checked = on === true;
    },
  };
}
