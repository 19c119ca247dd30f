/** One of several settings; where the lesson chose none, none is chosen. */
import type { Select } from "../lab-module.js";
import { make } from "../markup/element.js";
import type { ControlView, Operate } from "./control-view.js";

const none = "";

export function selectView({ label, options }: Select, operate: Operate): ControlView {
  const blank = make("option", { value: none, disabled: true, hidden: true }, "choose…");
  const choices = options.map((option, i) => make("option", { value: i }, option.label));
  const select = make("select", {}, blank, ...choices);
  select.addEventListener("change", () => operate(Number(select.value)));
  return {
    element: make("label", { class: "lab-choice" }, label, select),
    wide: false,
    show(index) {
      select.value = typeof index === "number" ? String(index) : none;
    },
  };
}
