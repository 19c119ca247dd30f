/** What the keys of a lab do; the list of keys is made of the same. */
import type { Action } from "../../engine/scene.js";
import { make } from "../markup/element.js";
import type { Shortcut } from "./keys.js";
import type { Player } from "./player.js";
import type { Transport } from "./transport.js";

/** Parts of the view's height that an arrow key moves it by. */
const nudge = 0.04;
const zoom = 0.05;

export interface ShortcutTargets {
  readonly player: Player;
  readonly transport: Transport;
  moveCamera(action: Action, dx: number, dy: number): void;
  nextView(): void;
  fillScreen(): void;
  showKeys(): void;
}

export function everywhere(targets: ShortcutTargets): readonly Shortcut[] {
  const { player, transport } = targets;
  return [
    key([" ", "k"], "Space, K", "play or pause", () => player.toggle()),
    key(["."], ".", "one step", () => player.step(1)),
    key([">", "Shift+."], "Shift + .", "ten steps", () => player.step(10)),
    key(["0", "Home"], "0, Home", "back to the start", () => player.reset()),
    key(["["], "[", "slower", () => transport.shiftSpeed(-1)),
    key(["]"], "]", "faster", () => transport.shiftSpeed(1)),
    key(["v"], "V", "next view", () => targets.nextView()),
    key(["f"], "F", "whole screen", () => targets.fillScreen()),
    key(["?"], "?", "these keys", () => targets.showKeys()),
  ];
}

export function inView(targets: ShortcutTargets): readonly Shortcut[] {
  const ways = [
    ["ArrowLeft", -nudge, 0],
    ["ArrowRight", nudge, 0],
    ["ArrowUp", 0, -nudge],
    ["ArrowDown", 0, nudge],
  ] as const;
  return [
    ...ways.flatMap(([arrow, dx, dy]) => [
      key([`Shift+${arrow}`], "", "", () => targets.moveCamera("moveVertical", dx, dy)),
      key([arrow], "", "", () => targets.moveCamera("rotateVertical", dx, dy)),
    ]),
    key(["+", "="], "+", "nearer", () => targets.moveCamera("zoom", 0, zoom)),
    key(["-"], "−", "further away", () => targets.moveCamera("zoom", 0, -zoom)),
  ];
}

/** The list for readers. */
export function listOf(shortcuts: readonly Shortcut[]): Node[] {
  const named = shortcuts.filter(({ shown }) => shown !== "");
  const rows = [
    ...named.map(({ shown, what }) => [shown, what] as const),
    ["Arrows", "on the view: turn it; with Shift: move it"] as const,
    ["Drag", "turn; right button or Shift: move; two fingers: zoom and move"] as const,
    ["Ctrl + drag", "pull a body (⌘ on a Mac)"] as const,
    ["Wheel", "zoom, with Ctrl (⌘) or once the view has the focus"] as const,
    ["Double click", "the lesson’s view"] as const,
  ];
  const list = make("dl", { class: "lab-keys" });
  for (const [shown, what] of rows) {
    list.append(make("dt", {}, make("kbd", {}, shown)), make("dd", {}, what));
  }
  return [list];
}

function key(keys: readonly string[], shown: string, what: string, act: () => void): Shortcut {
  return { keys, shown, what, act };
}
