// The search: a field over a list of what is found while the reader types. The focus stays in the
// field; the arrows choose in the list, Enter opens what is chosen.

import { make } from "../element.js";
import { Finder } from "./finder.js";
import { countOf, groupsOf } from "./results.js";

const listId = "search-results";
const hint = "Lessons, terms, models, MuJoCo’s names, code.";

export class SearchDialog {
  readonly #root = document.documentElement.dataset["root"] ?? "";
  readonly #field = make("input", {
    type: "text",
    role: "combobox",
    "aria-label": "Search this course",
    "aria-autocomplete": "list",
    "aria-controls": listId,
    "aria-expanded": "false",
    autocomplete: "off",
    autocapitalize: "off",
    spellcheck: "false",
    enterkeyhint: "go",
  });
  readonly #status = make("p", { role: "status", class: "search-status" });
  readonly #all = make("a", { class: "search-all", hidden: "" }, "As a page");
  readonly #list = make("div", { role: "listbox", id: listId, "aria-label": "Results" });
  readonly #dialog = make("dialog", { class: "search", "aria-label": "Search" });
  #finder: Promise<Finder> | undefined;
  #failed = false;
  #chosen: HTMLElement | undefined;

  /** `openKeys` shows the list of keys. */
  constructor(openKeys: () => void) {
    const close = make("button", { type: "button", class: "search-close" }, "Close");
    const keys = make("button", { type: "button", class: "search-keys" }, "Keys of this site");
    close.addEventListener("click", () => this.#dialog.close());
    keys.addEventListener("click", () => {
      this.#dialog.close();
      openKeys();
    });
    this.#field.addEventListener("input", () => void this.#find());
    this.#field.addEventListener("keydown", (event) => this.#press(event));
    this.#list.addEventListener("click", (event) => this.#leave(event));
    this.#dialog.addEventListener("click", ({ target }) => {
      if (target === this.#dialog) this.#dialog.close(); // beside the dialog
    });
    this.#dialog.append(
      make("div", { class: "search-head" }, this.#field, close),
      make("div", { class: "search-foot" }, this.#status, this.#all, keys),
      this.#list,
    );
    document.body.append(this.#dialog);
  }

  /** Without `words`, what was looked for last stays there, and gives way to what is `typed`. */
  open(words?: string, typed = ""): void {
    if (words !== undefined) this.#field.value = words;
    if (!this.#dialog.open) this.#dialog.showModal();
    this.#field.focus();
    this.#field.select();
    if (typed !== "") this.#field.setRangeText(typed, 0, this.#field.value.length, "end");
    void this.#find();
  }

  async #find(): Promise<void> {
    try {
      this.#finder ??= Finder.load(this.#failed);
      const waiting = setTimeout(() => this.#say("Loading …"), 300);
      const finder = await this.#finder.finally(() => clearTimeout(waiting));
      this.#show(finder);
    } catch {
      this.#finder = undefined;
      this.#failed = true;
      this.#say("What the search looks through could not be loaded. Type on to try again.");
    }
  }

  #show(finder: Finder): void {
    const words = this.#field.value.trim();
    const hits = words === "" ? [] : finder.find(words);
    this.#list.replaceChildren(...groupsOf(hits, this.#root, listId));
    this.#list.scrollTop = 0;
    this.#field.setAttribute("aria-expanded", String(hits.length > 0));
    this.#choose(this.#options[0]);
    this.#all.hidden = hits.length === 0;
    this.#all.href = `${this.#root}search.html?q=${encodeURIComponent(words)}`;
    if (words === "") this.#say(hint);
    else this.#say(hits.length > 0 ? countOf(hits) : `Nothing is found for “${words}”.`);
  }

  get #options(): HTMLElement[] {
    return [...this.#list.querySelectorAll<HTMLElement>("[role=option]")];
  }

  #say(words: string): void {
    if (this.#status.textContent !== words) this.#status.textContent = words;
  }

  #choose(option: HTMLElement | undefined): void {
    this.#chosen?.setAttribute("aria-selected", "false");
    option?.setAttribute("aria-selected", "true");
    option?.scrollIntoView({ block: "nearest" });
    if (option) this.#field.setAttribute("aria-activedescendant", option.id);
    else this.#field.removeAttribute("aria-activedescendant");
    this.#chosen = option;
  }

  #press(event: KeyboardEvent): void {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (event.isComposing || (step === undefined && event.key !== "Enter")) return;
    event.preventDefault();
    if (step === undefined) return this.#chosen?.click();
    const options = this.#options;
    const now = options.findIndex((option) => option === this.#chosen);
    this.#choose(options.at((now + step) % options.length));
  }

  /** What is found may be on the page that is open. */
  #leave(event: MouseEvent): void {
    const stays = event.ctrlKey || event.metaKey || event.shiftKey;
    if (!stays && event.target instanceof Element && event.target.closest("a")) {
      this.#dialog.close();
    }
  }
}
