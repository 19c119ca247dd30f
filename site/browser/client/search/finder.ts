// Finds sections: MiniSearch over the index of the site, which is loaded when it is first wanted.
//
// All words must be there, whole, as a beginning or nearly so; where no section has all of them,
// those that have some are found.

import MiniSearch from "minisearch";

import type { Page, Section } from "./pages.js";
import { run } from "./scripts.js";
import { folded, partsOf, soughtOf, wordsOf } from "./words.js";

export interface Hit {
  readonly page: Page;
  readonly section: Section;
  /** The words of the section that were found, folded. */
  readonly words: ReadonlySet<string>;
}

interface Entry {
  readonly id: number;
  readonly title: string;
  readonly page: string;
  readonly text: string;
  readonly code: string;
}

const chunk = 15; // sections that are read before the page is given a moment
const mostSought = 300; // characters: a link may bring any number

export class Finder {
  readonly #places: { page: Page; section: Section }[] = [];
  readonly #index = new MiniSearch<Entry>({
    fields: ["title", "page", "text", "code"],
    tokenize: (text) => wordsOf(text).flatMap(partsOf),
    processTerm: folded,
    searchOptions: {
      tokenize: soughtOf,
      boost: { title: 4, page: 2, text: 1, code: 0.6 },
      prefix: (term) => term.length > 1,
      fuzzy: (term) => (term.length > 3 ? 0.2 : false),
      weights: { prefix: 0.6, fuzzy: 0.2 },
    },
  });

  /** Rejects where the index cannot be loaded. When it is tried `again`, it may have another name. */
  static async load(again: boolean): Promise<Finder> {
    if (again) await run("search.js");
    await run(window.mjcourse!.index);
    const finder = new Finder();
    await finder.#read(window.mjcourse?.pages ?? []);
    return finder;
  }

  /** The best first. */
  find(all: string): Hit[] {
    const text = all.slice(0, mostSought);
    const wanted = folded(text.trim());
    const isNamed = (id: number): boolean => folded(this.#titleOf(id)) === wanted;
    const boostDocument = (id: unknown): number => (isNamed(id as number) ? 4 : 1);
    const whole = this.#index.search(text, { combineWith: "AND", boostDocument });
    const found = whole.length > 0 ? whole : this.#index.search(text, { boostDocument });
    return found.map(({ id, match }) => ({
      ...this.#places[id as number]!,
      words: new Set(Object.keys(match)),
    }));
  }

  #titleOf(id: number): string {
    const { page, section } = this.#places[id]!;
    return section.title || page.title;
  }

  async #read(pages: readonly Page[]): Promise<void> {
    this.#places.push(
      ...pages.flatMap((page) => page.sections.map((section) => ({ page, section }))),
    );
    const entries = this.#places.map(({ page, section: { title, text, code } }, id) => {
      return { id, title, page: `${page.number} ${page.title}`, text, code };
    });
    await this.#index.addAllAsync(entries, { chunkSize: chunk });
  }
}
