// The keys of every page. A single character acts only where nothing takes what is typed, where no
// dialog is open, and where the reader has not switched single keys off. What a lab does with a key
// while it has the focus goes first, as its listener is nearer.

import { openKeys, openSearch } from "./search/opener.js";
import { singleKeys } from "./single-keys.js";

// A select finds its options by their first letters; a checkbox does nothing with a character.
const typed =
  "input:not([type=checkbox], [type=radio], [type=range]), textarea, select, " +
  "[contenteditable]:not([contenteditable=false])";

function turn(way: "prev" | "next"): void {
  document.querySelector<HTMLAnchorElement>(`a[rel=${way}]`)?.click();
}

const single = new Map<string, () => void>([
  ["/", () => openSearch()],
  ["?", () => openKeys()],
  ["[", () => turn("prev")],
  ["]", () => turn("next")],
]);

function actionOf(event: KeyboardEvent): (() => void) | undefined {
  const { key } = event;
  const [target] = event.composedPath(); // in an editor's shadow root, too
  const isTyped = target instanceof Element && target.closest(typed) !== null;
  const command = event.ctrlKey !== event.metaKey && !event.altKey && !event.shiftKey;
  if (command && key.toLowerCase() === "k") return () => openSearch();
  // On many keyboards a bracket is typed with AltGr, which some systems tell as Ctrl and Alt.
  const held =
    event.metaKey || ((event.ctrlKey || event.altKey) && !event.getModifierState("AltGraph"));
  if (held || isTyped || !singleKeys()) return undefined;
  return document.querySelector("dialog[open]") ? undefined : single.get(key);
}

export function listenToKeys(): void {
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.isComposing || event.repeat) return;
    const act = actionOf(event);
    if (!act) return;
    event.preventDefault();
    act();
  });
}
