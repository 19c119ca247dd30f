// search.html: all that is found, as a page whose address holds the words, so that a link, a bookmark
// or the browser's own field of addresses can look for something.

import { make } from "../element.js";
import { Finder, type Hit } from "./finder.js";
import { byPage, countOf, sectionOf } from "./results.js";
import type { Page } from "./pages.js";

const perStep = 8; // pages, of those found

export class SearchPage {
  readonly #root = document.documentElement.dataset["root"] ?? "";
  readonly #field = make("input", {
    type: "search",
    name: "q",
    "aria-label": "Search this course",
    autocapitalize: "off",
    spellcheck: "false",
    enterkeyhint: "search",
  });
  readonly #status = make("p", { role: "status", class: "search-status" });
  readonly #list = make("div");
  readonly #more = make("button", { type: "button", hidden: "" }, "More results");
  #finder: Promise<Finder> | undefined;
  #failed = false;
  #rest: [Page, Hit[]][] = [];

  /** In `place`, which says until then how to do without. */
  constructor(place: Element) {
    const form = make("form", { role: "search" }, this.#field, make("button", {}, "Search"));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.#keepWords();
      void this.#find();
    });
    this.#field.addEventListener("input", () => void this.#find());
    this.#field.addEventListener("change", () => this.#keepWords());
    this.#more.addEventListener("click", () => this.#showMore());
    place.querySelector(".by-hand")?.replaceWith(form, this.#status, this.#list, this.#more);
    this.open(new URLSearchParams(location.search).get("q") ?? "");
  }

  /** Without `words`, what was looked for last stays. */
  open(words?: string, typed = ""): void {
    if (words !== undefined) this.#field.value = words;
    this.#field.focus();
    this.#field.select();
    if (typed !== "") this.#field.setRangeText(typed, 0, this.#field.value.length, "end");
    void this.#find();
  }

  #keepWords(): void {
    const address = new URL(location.href);
    address.searchParams.set("q", this.#field.value.trim());
    history.replaceState(history.state, "", address);
  }

  async #find(): Promise<void> {
    if (!this.#finder && this.#field.value.trim() === "") return;
    try {
      this.#finder ??= Finder.load(this.#failed);
      this.#show(await this.#finder);
    } catch {
      this.#finder = undefined;
      this.#failed = true;
      this.#status.textContent =
        "What the search looks through could not be loaded. Search once more to try again.";
    }
  }

  #show(finder: Finder): void {
    const words = this.#field.value.trim();
    const hits = words === "" ? [] : finder.find(words);
    this.#rest = [...byPage(hits)];
    this.#list.replaceChildren();
    this.#showMore();
    if (words === "") this.#status.textContent = "";
    else if (hits.length === 0) this.#status.textContent = `Nothing is found for “${words}”.`;
    else this.#status.textContent = countOf(hits);
  }

  #showMore(): void {
    const shown = this.#rest.splice(0, perStep);
    this.#list.append(...shown.map(([page, hits]) => sectionOf(page, hits, this.#root)));
    this.#more.hidden = this.#rest.length === 0;
  }
}
