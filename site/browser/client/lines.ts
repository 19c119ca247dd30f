// Links to the lines of programs: `#NAME-L12`. They stand in the margin and are empty, as their numbers
// come from the stylesheet, so what is selected or copied is the program alone. Those who use a keyboard
// or hear the page meet one for each program, and go to the others with the arrow keys.

import { decoded } from "./decoded.js";

const keys: Record<string, (at: number, last: number) => number> = {
  ArrowUp: (at) => at - 1,
  ArrowDown: (at) => at + 1,
  Home: () => 0,
  End: (_, last) => last,
};

function linksOf(name: string, code: Element): HTMLAnchorElement[] {
  const lines = code.textContent.trimEnd().split("\n");
  return lines.map((_, i) => {
    const link = document.createElement("a");
    link.id = `${name}-L${i + 1}`;
    link.href = `#${link.id}`;
    link.tabIndex = -1;
    link.ariaHidden = "true";
    link.ariaLabel = `Line ${i + 1}`;
    return link;
  });
}

function number(figure: Element): void {
  const code = figure.querySelector("pre.code > code");
  if (!code || code.querySelector(".lines")) return;
  const links = linksOf(figure.id.replace("example-", ""), code);
  const margin = document.createElement("span");
  margin.className = "lines";
  margin.append(...links);
  let at = 0;
  const reach = (next: number): void => {
    links[at]!.tabIndex = -1;
    links[at]!.ariaHidden = "true";
    at = next;
    links[at]!.tabIndex = 0;
    links[at]!.ariaHidden = null;
  };
  reach(0);
  margin.addEventListener("keydown", (event) => {
    const next = links[keys[event.key]?.(at, links.length - 1) ?? -1];
    if (!next) return;
    event.preventDefault();
    reach(links.indexOf(next));
    next.focus();
  });
  code.prepend(margin);
}

/** Links that lead to programs where there is no script lead to their lines where there is one. */
export function leadToLines(): void {
  for (const link of document.querySelectorAll<HTMLAnchorElement>("a[data-line]")) {
    link.hash = link.hash.replace("#example-", "#") + `-L${link.dataset["line"]}`;
  }
}

/** Of the programs in `root`, which may be one itself. */
export function numberLines(root: Document | Element = document): void {
  if (root instanceof Element && root.matches(".example[id]")) number(root);
  for (const figure of root.querySelectorAll(".example[id]")) number(figure);
  // The browser has looked for this line already, when it was not there.
  const sought = document.getElementById(decoded(location.hash.slice(1)));
  if (root === document && sought?.closest(".lines")) location.replace(location.hash);
}
