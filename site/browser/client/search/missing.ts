// 404.html, which hosts show at any address where there is no page, at any depth. Its links are those
// of a page at the site's root, so they are put right here; and the search is offered, filled with
// the words of the address. It is loaded with the search, which other pages need not.

import { decoded } from "../decoded.js";
import { make } from "../element.js";

/** "generalised coordinates" of "…/1-state/1.2-generalised-coordinates.html". */
function wordsOf(address: string): string {
  const last = address.split("/").findLast((part) => part !== "") ?? "";
  const words = last.replace(/\.[a-z]+$/i, "").match(/[\p{L}\p{N}_]+/gu) ?? [];
  return words.filter((word) => /\p{L}{2}/u.test(word)).join(" ");
}

function mend(name: "href" | "src", root: string): void {
  for (const element of document.body.querySelectorAll(`[${name}]`)) {
    const address = element.getAttribute(name)!;
    if (!address.startsWith("#")) element.setAttribute(name, new URL(address, root).href);
  }
}

export function mendMissingPage(page: Element, openSearch: (words: string) => void): void {
  const root = document.documentElement.dataset["root"] ?? "";
  mend("href", root);
  mend("src", root);
  document.body.classList.add("mended");
  const path = location.href.startsWith(root) ? location.href.slice(root.length) : "";
  const words = wordsOf(decoded(path.replace(/[?#].*$/, "")));
  const label = words === "" ? "Search the course" : `Search for “${words}”`;
  const search = make("button", { type: "button" }, label);
  search.addEventListener("click", () => openSearch(words));
  page.append(make("p", {}, search));
}
