// Where each part of a lesson's text comes from, and what is the matter with it.

import type { Diagnostic, State } from "./state.js";

type Marks = State["marks"];

interface Part {
  readonly element: Element;
  readonly first: number; // lines of the lesson's file
  last: number;
  running: boolean;
}

/** What shows nothing by itself, as a program's output, belongs to the part above. */
function partsOf(elements: readonly (Element | undefined)[], marks: Marks): Part[] {
  const parts: Part[] = [];
  for (const [index, [first, last, running]] of marks.entries()) {
    const element = elements[index];
    const above = parts.at(-1);
    if (element) {
      parts.push({ element, first, last, running });
    } else if (above) {
      above.last = last;
      above.running ||= running;
    }
  }
  return parts;
}

/** Of a text whose parts begin with `elements`: marks what runs, and puts a flag above each part with
 *  a mistake, which `open` is told of. */
export function markParts(
  elements: readonly (Element | undefined)[],
  { source, diagnostics, marks }: State,
  open: (diagnostic: Diagnostic) => void,
): void {
  for (const flag of document.querySelectorAll(".preview-flag")) flag.remove();
  const found = new Map<Element, Diagnostic[]>();
  const parts = partsOf(elements, marks);
  for (const diagnostic of diagnostics) {
    const { file, line } = diagnostic.place;
    const part = parts.findLast(({ first }) => first <= line);
    if (file !== source || !part || line > part.last) continue;
    found.set(part.element, [...(found.get(part.element) ?? []), diagnostic]);
  }
  for (const { element, running } of parts) {
    element.toggleAttribute("data-preview-running", running);
    element.toggleAttribute("data-preview-wrong", found.has(element));
    for (const diagnostic of found.get(element) ?? []) element.before(flagOf(diagnostic, open));
  }
}

function flagOf(diagnostic: Diagnostic, open: (diagnostic: Diagnostic) => void): Element {
  const flag = document.createElement("button");
  flag.type = "button";
  flag.className = "preview-flag";
  flag.textContent = `${diagnostic.severity}, line ${diagnostic.place.line}: ${diagnostic.message}`;
  flag.addEventListener("click", () => open(diagnostic));
  return flag;
}
