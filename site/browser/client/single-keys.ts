// Whether the site's keys that need no Ctrl act; the reader's choice is remembered on this site.

import { recall, remember } from "./storage.js";

const key = "single-keys";

export function singleKeys(): boolean {
  return recall(key) !== "off";
}

export function setSingleKeys(act: boolean): void {
  remember(key, act ? null : "off");
}
