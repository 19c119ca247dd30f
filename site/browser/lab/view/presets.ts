/** Where a view is seen from: the lesson's place, and three that are always worth a look. */
import type { CameraPlace } from "../lab-module.js";

export const presets = ["Lesson’s view", "Front", "Side", "Top"] as const;
export type Preset = (typeof presets)[number];

/** Degrees. MuJoCo's azimuth 90 looks along y, 180 against x; straight down has no sideways, so Top
 * keeps a little. */
const angles: Readonly<Record<Preset, Partial<CameraPlace>>> = {
  "Lesson’s view": {},
  Front: { azimuth: 180, elevation: 0 },
  Side: { azimuth: 90, elevation: 0 },
  Top: { azimuth: 90, elevation: -89.9 },
};

export function seenFrom(lesson: CameraPlace, preset: Preset): CameraPlace {
  return { ...lesson, ...angles[preset] };
}
