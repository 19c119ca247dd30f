// Where each part of a lesson's text comes from, and what is the matter with it.

import type { Diagnostic } from "./state.js";

interface Part {
  readonly element: Element;
  readonly first: number; // lines of the lesson's file
  last: number;
  running: boolean;
}

/** From the text's comments and elements in their order: a comment is about what follows it, and
 *  what shows nothing by itself, as a program's output, belongs to the part above. */
function partsOf(text: Iterable<Comment | Element>): Part[] {
  const parts: Part[] = [];
  let mark: { first: number; last: number; running: boolean } | undefined;
  const merge = (): void => {
    const above = parts.at(-1);
    if (!mark || !above) return;
    above.last = mark.last;
    above.running ||= mark.running;
  };
  for (const node of text) {
    if (node instanceof Comment) {
      const lines = /^lines (\d+)-(\d+)( running)?$/.exec(node.data);
      if (!lines) continue;
      merge();
      mark = { first: Number(lines[1]), last: Number(lines[2]), running: lines[3] !== undefined };
    } else if (mark) {
      parts.push({ element: node, ...mark });
      mark = undefined;
    }
  }
  merge();
  return parts;
}

/** Marks what runs, and puts a flag above each part with a mistake, which `open` is told of. */
export function markParts(
  text: Iterable<Comment | Element>,
  source: string,
  diagnostics: readonly Diagnostic[],
  open: (diagnostic: Diagnostic) => void,
): void {
  for (const flag of document.querySelectorAll(".preview-flag")) flag.remove();
  const found = new Map<Element, Diagnostic[]>();
  const parts = partsOf(text);
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
