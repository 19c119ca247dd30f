/** What the reader sees of one control of a lesson. */
import type { ControlValue } from "../run/controls.js";

export interface ControlView {
  /** The content of its place in the list. */
  readonly element: HTMLElement;
  /** Whether it takes a line of its own. */
  readonly wide: boolean;
  /** Shows `value`, which the reader did not just set here. */
  show?(value: ControlValue): void;
}

/** Told what the reader did with it. */
export type Operate = (value: ControlValue) => void;
