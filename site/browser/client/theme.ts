// Light, dark, or as the system says: the reader's choice is remembered on this site.
//
// applyTheme() runs while the head is read, before anything is painted. addThemeButton() runs once
// the page is there; the button is made here because without the script it could do nothing.

import { keys, recall, remember } from "./storage.js";

type Theme = "light" | "dark";

function isTheme(value: string | null | undefined): value is Theme {
  return value === "light" || value === "dark";
}

function current(): Theme {
  const chosen = document.documentElement.dataset["theme"];
  if (isTheme(chosen)) return chosen;
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

export function applyTheme(): void {
  const theme = recall(keys.theme);
  if (isTheme(theme)) document.documentElement.dataset["theme"] = theme;
}

export function addThemeButton(): void {
  const place = document.querySelector("header.site-head > .masthead");
  if (!place) return;
  const button = document.createElement("button");
  button.type = "button";
  button.className = "theme-button";
  const label = (): void => {
    const next = current() === "dark" ? "light" : "dark";
    button.setAttribute("aria-label", `Use the ${next} theme`);
    button.title = `Use the ${next} theme`;
  };
  button.addEventListener("click", () => {
    const next: Theme = current() === "dark" ? "light" : "dark";
    document.documentElement.dataset["theme"] = next;
    remember(keys.theme, next);
    label();
  });
  label();
  place.append(button);
}
