// What was found, as a list: page by page, in each its sections.

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

/** The best of them; links that can be chosen, whose ids begin with `id`. */
export function groupsOf(hits: readonly Hit[], root: string, id: string): HTMLElement[] {
  const pages = new Map<Page, Hit[]>();
  for (const hit of hits) {
    const own = pages.get(hit.page);
    if (own) own.push(hit);
    else if (pages.size < mostPages) pages.set(hit.page, [hit]);
  }
  return [...pages].map(([page, own], index) => {
    const label = make("p", { class: "search-page", id: `${id}-${index}` }, nameOf(page));
    const options = own
      .slice(0, mostSections)
      .map((hit, place) => option(hit, root, `${id}-${index}-${place}`));
    return make("div", { role: "group", "aria-labelledby": label.id }, label, ...options);
  });
}

function option({ page, section, words }: Hit, root: string, id: string): HTMLElement {
  const { title, anchor, text, code } = section;
  const inCode = !hasAny(text, words) && hasAny(code, words);
  const piece = snippet(inCode ? code : text, words);
  return make(
    "a",
    {
      role: "option",
      id,
      class: "search-result",
      tabindex: "-1",
      "aria-selected": "false",
      href: `${root}${page.href}${anchor === "" ? "" : `#${anchor}`}`,
    },
    make("span", { class: "search-title" }, ...marked(title || page.title, words)),
    " ",
    inCode ? make("code", {}, ...piece) : make("span", {}, ...piece),
  );
}
