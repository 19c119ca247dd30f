// The search's button, and the way to what it opens, which is loaded at its first use. The button is
// made here because without the script it could do nothing.

import { run, type Dialogs } from "./scripts.js";
import { takeTyped } from "./typed-ahead.js";

const button = document.createElement("button");
let loading: Promise<Dialogs> | undefined;

async function load(): Promise<Dialogs> {
  await run("search.js");
  await run(window.mjcourse!.code);
  const dialogs = window.mjcourse!.dialogs!;
  await dialogs.styled;
  return dialogs;
}

async function open(show: (dialogs: Dialogs) => void): Promise<void> {
  try {
    show(await (loading ??= load()));
  } catch {
    loading = undefined; // the next time may be a better one
    document.body.classList.add("without-search");
    button.title = button.textContent = "Search: not loaded, try again";
    button.focus();
  }
}

/** Without `words`, what was looked for last is still there. */
export function openSearch(words?: string): void {
  const typed = takeTyped();
  void open((dialogs) => dialogs.openSearch(words, typed.end())).finally(typed.end);
}

export function openKeys(): void {
  void open((dialogs) => dialogs.openKeys());
}

/** At once on 404.html and search.html, which are of little use without it. */
export function loadWhereNeeded(): void {
  if (document.querySelector("article.missing, article.search-place")) void open(() => undefined);
}

export function addSearchButton(): void {
  button.type = "button";
  button.className = "search-button";
  button.title = "Search (Ctrl + K)";
  button.setAttribute("aria-keyshortcuts", "Control+K");
  button.textContent = "Search";
  button.addEventListener("click", () => openSearch());
  document.querySelector("header.site-head > .masthead")?.append(button);
}
