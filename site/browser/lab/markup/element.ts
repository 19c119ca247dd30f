/** Makes elements. A policy of the page forbids style attributes and inline handlers; attributes that
 * are set here are plain ones. */

type Attributes = Readonly<Record<string, string | number | boolean>>;
type Tags = HTMLElementTagNameMap;

/** False leaves an attribute out, true gives it without a value. */
export function make<Tag extends keyof Tags>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: readonly (Node | string)[]
): Tags[Tag] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== false) element.setAttribute(name, value === true ? "" : String(value));
  }
  element.append(...children);
  return element;
}

/** The children of text that the generator made of Markdown. */
export function fromHtml(html: string): DocumentFragment {
  return document.createRange().createContextualFragment(html);
}

/** A new id, for labels and descriptions. */
export function newId(): string {
  return `lab-part-${++ids}`;
}
let ids = 0;

/** Writes a text only where it is another: the browser lays out what it is told of. */
export function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}
