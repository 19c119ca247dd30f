// The index of the search, as generator/page/search_index.h writes it.

export interface Section {
  /** Empty for what stands before a page's first heading. */
  readonly title: string;
  readonly anchor: string;
  readonly text: string;
  readonly code: string;
}

export interface Page {
  readonly kind: "lesson" | "glossary" | "api" | "model";
  /** Of a lesson. */
  readonly number: string;
  readonly title: string;
  /** Below the site's root. */
  readonly href: string;
  readonly sections: readonly Section[];
}

/** How a list of results calls the page. */
export function nameOf({ kind, number, title }: Page): string {
  if (kind === "model") return `Model ${title}`;
  return number === "" ? title : `${number} ${title}`;
}
