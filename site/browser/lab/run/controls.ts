/** What each kind of control does, and with which value it begins. */
import type { Control } from "../lab-module.js";
import type { Track } from "./track.js";

/** A slider's number, a toggle's truth, a select's index; null for what has no value. */
export type ControlValue = number | boolean | null;

/** The value that a reset gives the control; null where it gives none. */
export function initialValue(control: Control): ControlValue {
  switch (control.type) {
    case "slider":
    case "select":
      return control.value;
    case "toggle":
      return control.value || null;
    case "button":
    case "keyframe":
      return null;
  }
}

/** Runs the script of the control; mj_forward is the caller's. */
export function act(track: Track, control: Control, value: ControlValue): void {
  const { scripts, simulation } = track;
  switch (control.type) {
    case "button":
      scripts.run(control.run);
      break;
    case "slider":
      scripts.write(control.write, Number(value));
      break;
    case "toggle":
      scripts.run(value === true ? control.on : control.off);
      break;
    case "select":
      scripts.run(control.options[Number(value)]!.run);
      break;
    case "keyframe":
      simulation.resetToKeyframe(control.key);
      break;
  }
}

/** `value` as the control can have it; null when it can have nothing of the kind. */
export function fitting(control: Control, value: ControlValue): ControlValue {
  if (control.type === "toggle") return typeof value === "boolean" ? value : null;
  if (typeof value !== "number") return null;
  if (control.type === "slider") return Math.min(control.max, Math.max(control.min, value));
  const chosen = control.type === "select" && control.options[value] !== undefined;
  return chosen ? value : null;
}
