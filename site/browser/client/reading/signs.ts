// Small signs that tell, in the list of lessons and on the home page's cards, how each lesson stands.

import { recallReading, stateOf, words } from "./readings.js";

/** Again when something changed. */
export function showSigns(): void {
  const links = document.querySelectorAll<HTMLAnchorElement>(
    "nav.lessons ol ol a, section.level .card h3 a",
  );
  for (const link of links) {
    link.querySelector(".reading-sign")?.remove();
    const state = stateOf(recallReading(link.pathname));
    if (state !== "new") link.append(signOf(state, words[state]));
  }
}

function signOf(state: string, text: string): Element {
  const sign = document.createElement("span");
  sign.className = `reading-sign ${state}`;
  const alternative = document.createElement("span");
  alternative.className = "unseen";
  alternative.textContent = ` (${text})`;
  sign.append(alternative);
  return sign;
}
