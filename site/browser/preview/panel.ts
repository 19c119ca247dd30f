// The panel at the page's lower edge: whether the page is up to date, and all that is wrong.

import type { Diagnostic, Place, State } from "./state.js";

const styles = `
  :host { position: fixed; inset: auto 0 0 auto; z-index: 1000; max-width: min(60rem, 100vw);
    display: grid; justify-items: end; font: 0.875rem/1.5 var(--sans, sans-serif);
    color: var(--ink, CanvasText); pointer-events: none; }
  :host > * { pointer-events: auto; }
  @media print { :host { display: none; } }
  button, a { font: inherit; color: inherit; }
  .status { margin: 0.5rem; padding: 0.25rem 0.75rem; border: 1px solid var(--edge, GrayText);
    border-radius: 1rem; background: var(--paper, Canvas); cursor: pointer; }
  .status.wrong { color: var(--wrong, red); font-weight: 600; border-color: currentColor; }
  .list { box-sizing: border-box; max-height: 45vh; overflow: auto; width: 100%; padding: 0.5rem 1rem;
    background: var(--paper, Canvas); border: 1px solid var(--wrong, red); border-width: 2px 0 0 2px; }
  .list:empty { display: none; }
  article { margin: 0.5rem 0 1rem; scroll-margin: 0.5rem; }
  article:focus { outline: 2px solid var(--accent, Highlight); outline-offset: 4px; }
  pre { margin: 0.25rem 0 0; padding: 0.5rem; overflow-x: auto; background: var(--ground, Canvas);
    font: 0.8125rem/1.45 var(--mono, monospace); }
  article button { padding: 0 0.5rem; border: 1px solid var(--edge, GrayText); border-radius: 0.25rem;
    background: none; cursor: pointer; }
  summary { cursor: pointer; padding: 0.25rem 0; }
`;

function element<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  className: string,
  ...content: (string | Node)[]
): HTMLElementTagNameMap[Name] {
  const made = document.createElement(name);
  if (className) made.className = className;
  made.append(...content);
  return made;
}

function count(number: number, what: string): string {
  return `${number} ${what}${number === 1 ? "" : "s"}`;
}

export class Panel {
  readonly #host = document.createElement("div");
  readonly #status = element("button", "status", "…");
  readonly #list = element("section", "list");
  #articles = new Map<Diagnostic, HTMLElement>();
  #shown = ""; // the diagnostics of the last state
  #wanted = true; // whether the author wants to see them

  constructor() {
    this.#host.className = "preview-panel";
    const root = this.#host.attachShadow({ mode: "open" });
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(styles);
    root.adoptedStyleSheets = [sheet];
    this.#status.type = "button";
    this.#status.setAttribute("aria-live", "polite");
    this.#status.addEventListener("click", () => {
      this.#wanted = !this.#wanted;
      this.#unfold();
    });
    this.#list.setAttribute("aria-label", "What is wrong");
    root.append(this.#list, this.#status);
    document.body.append(this.#host);
  }

  show(state: State): void {
    const { diagnostics, drafts, running } = state;
    const text = JSON.stringify([diagnostics, drafts]);
    const wrong = diagnostics.length > 0;
    const said = wrong ? count(diagnostics.length, "error") : "up to date";
    this.#status.textContent = running ? `running… ${wrong ? said : ""}`.trim() : said;
    this.#status.classList.toggle("wrong", wrong);
    if (text === this.#shown) return;
    this.#shown = text;
    this.#articles.clear();
    const here = diagnostics.filter((one) => one.here);
    const others = diagnostics.filter((one) => !one.here);
    this.#list.replaceChildren(
      ...here.map((one) => this.#articleOf(one, state)),
      ...this.#folded(count(others.length, "error") + " elsewhere in the course", others, state),
      ...draftsOf(state),
    );
    this.#unfold();
  }

  gone(): void {
    this.#status.textContent = "the preview has ended; this page is as it was last";
  }

  open(diagnostic: Diagnostic): void {
    this.#wanted = true;
    this.#unfold();
    const article = this.#articles.get(diagnostic);
    article?.closest("details")?.toggleAttribute("open", true);
    article?.focus();
    article?.scrollIntoView({ block: "nearest" });
  }

  #unfold(): void {
    this.#list.hidden = !this.#wanted || this.#list.childElementCount === 0;
    this.#status.setAttribute("aria-expanded", String(!this.#list.hidden));
  }

  #folded(title: string, diagnostics: readonly Diagnostic[], state: State): HTMLElement[] {
    if (diagnostics.length === 0) return [];
    const articles = diagnostics.map((one) => this.#articleOf(one, state));
    return [element("details", "", element("summary", "", title), ...articles)];
  }

  #articleOf(diagnostic: Diagnostic, state: State): HTMLElement {
    const article = element("article", "");
    article.tabIndex = -1;
    if (diagnostic.place.file) article.append(...placeOf(diagnostic.place, state));
    article.append(element("pre", "", diagnostic.text.trimEnd()));
    this.#articles.set(diagnostic, article);
    return article;
  }
}

function placeOf(place: Place, { course, link }: State): (string | HTMLElement)[] {
  const { file, line, column } = place;
  const where = line > 0 ? `${file}:${line}` : file;
  const open = element("a", "", where);
  open.href = link
    .replace("{file}", encodeURI(`${course}/${file}`))
    .replace("{line}", String(line || 1))
    .replace("{column}", String(column || 1));
  const copy = element("button", "", "Copy");
  copy.type = "button";
  copy.title = `Copy ${where}`;
  copy.addEventListener("click", () => {
    void navigator.clipboard.writeText(where).then(() => (copy.textContent = "Copied"));
  });
  return [open, " ", copy];
}

function draftsOf({ drafts }: State): HTMLElement[] {
  if (drafts.length === 0) return [];
  const links = drafts.flatMap(({ href, title }) => {
    const link = element("a", "", title);
    link.href = href;
    return [link, " "];
  });
  return [element("p", "", "Drafts, which the site leaves out: ", ...links)];
}
