// The files of the search, which come when they are wanted.
//
// They are added as elements and not fetched: a page that was opened from the disk may do nothing
// else. Each leaves what it has in one object of the window.

import type { Page } from "./pages.js";

export interface Dialogs {
  /** Until their stylesheet is there, or will not come. */
  readonly styled: Promise<unknown>;
  /** Without `words`, what was looked for last stays; unless something was `typed` on the way. */
  openSearch(words?: string, typed?: string): void;
  openKeys(): void;
}

interface SearchScripts {
  /** All three below the site's root. */
  readonly code: string;
  readonly styles: string;
  readonly index: string;
  dialogs?: Dialogs;
  pages?: readonly Page[];
}

declare global {
  interface Window {
    mjcourse?: SearchScripts;
  }
}

/** Of a file of the site. */
export function addressOf(path: string): string {
  return `${document.documentElement.dataset["root"] ?? ""}${path}`;
}

/** Until it is there. */
export function add(element: HTMLElement): Promise<unknown> {
  return new Promise((resolve, reject) => {
    element.onload = resolve;
    element.onerror = reject;
    document.head.append(element);
  });
}

/** Runs the script `path` of the site. */
export function run(path: string): Promise<unknown> {
  const script = document.createElement("script");
  script.src = addressOf(path);
  return add(script);
}
