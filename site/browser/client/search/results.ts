// What was found, page by page, in each its sections: as a list to choose from, or to read.

import { make } from "../element.js";
import type { Hit } from "./finder.js";
import { nameOf, type Page } from "./pages.js";
import { hasAny, marked, snippet } from "./snippet.js";

const mostPages = 12;
const mostSections = 4; // of a page

/** How many hits there are, in words. */
export function countOf(hits: readonly Hit[]): string {
  const pages = new Set(hits.map(({ page }) => page)).size;
  const count = (number: number, one: string): string => `${number} ${one}${number > 1 ? "s" : ""}`;
  return `${count(hits.length, "result")} on ${count(pages, "page")}`;
}

/** The hits of each page, the page with the best first. */
export function byPage(hits: readonly Hit[]): Map<Page, Hit[]> {
  const pages = new Map<Page, Hit[]>();
  for (const hit of hits) {
    const own = pages.get(hit.page);
    if (own) own.push(hit);
    else pages.set(hit.page, [hit]);
  }
  return pages;
}

/** All hits of a page, to read. */
export function sectionOf(page: Page, hits: readonly Hit[], root: string): HTMLElement {
  const items = hits.map((hit) => {
    return make(
      "li",
      {},
      make("a", { class: "search-result", href: href(hit, root) }, ...inside(hit)),
    );
  });
  return make("section", {}, make("h2", {}, nameOf(page)), make("ul", {}, ...items));
}

/** The best of them; links that can be chosen, whose ids begin with `id`. */
export function groupsOf(hits: readonly Hit[], root: string, id: string): HTMLElement[] {
  return [...byPage(hits)].slice(0, mostPages).map(([page, own], index) => {
    const label = make("p", { class: "search-page", id: `${id}-${index}` }, nameOf(page));
    const options = own
      .slice(0, mostSections)
      .map((hit, place) => option(hit, root, `${id}-${index}-${place}`));
    return make("div", { role: "group", "aria-labelledby": label.id }, label, ...options);
  });
}

function href({ page, section: { anchor } }: Hit, root: string): string {
  return `${root}${page.href}${anchor === "" ? "" : `#${anchor}`}`;
}

// Its title, and a piece of its text around what was found.
function inside({ page, section, words }: Hit): (Node | string)[] {
  const { title, text, code } = section;
  const inCode = !hasAny(text, words) && hasAny(code, words);
  const piece = snippet(inCode ? code : text, words);
  return [
    make("span", { class: "search-title" }, ...marked(title || page.title, words)),
    " ",
    inCode ? make("code", {}, ...piece) : make("span", {}, ...piece),
  ];
}

function option(hit: Hit, root: string, id: string): HTMLElement {
  return make(
    "a",
    {
      role: "option",
      id,
      class: "search-result",
      tabindex: "-1",
      "aria-selected": "false",
      href: href(hit, root),
    },
    ...inside(hit),
  );
}
