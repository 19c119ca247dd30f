// A page's stylesheets. A new one takes the place of the old one once it is loaded, so the page never
// stands there without; of the site's own, which is edited beside the page, only rules are replaced.

import { giveRules } from "./sheet.js";

const own = /assets\/site-\w+\.css$/;

function sheetsIn(page: Document): HTMLLinkElement[] {
  return [...page.querySelectorAll<HTMLLinkElement>("link[rel=stylesheet]")].filter(
    (link) => !link.getAttribute("href")!.startsWith("/.preview/"),
  );
}

function addressOf(link: HTMLLinkElement): string {
  return link.getAttribute("href")!;
}

function wornIn(page: Document): string {
  const names = sheetsIn(page).map((link) => own.exec(addressOf(link))?.[0]);
  return names.find((name) => name !== undefined) ?? "";
}

export class Styles {
  #worn = wornIn(document);
  /** Its rules, where its link has others. */
  #rules: CSSStyleSheet | undefined;

  /** Which form of the site's own is in force, below the root. */
  get worn(): string {
    return this.#worn;
  }

  /** The stylesheets that `page` has beside the site's own. */
  take(page: Document): void {
    const old = sheetsIn(document);
    const wanted = sheetsIn(page).map(addressOf);
    const isWanted = (link: HTMLLinkElement): boolean =>
      own.test(addressOf(link)) || wanted.includes(addressOf(link));
    const gone = old.filter((link) => !isWanted(link));
    const remove = (): void => gone.forEach((link) => link.remove());
    const news = wanted.filter(
      (address) => !own.test(address) && !old.some((link) => addressOf(link) === address),
    );
    if (news.length === 0) remove();
    for (const address of news) this.#load(address, old.at(-1), remove);
  }

  /** Puts the form `newest`, whose text is `css`, in force. */
  wear(newest: string, css: string): void {
    const link = sheetsIn(document).find((one) => own.test(addressOf(one)));
    if (!link?.sheet) return;
    this.#worn = newest;
    try {
      const young = new CSSStyleSheet();
      young.replaceSync(css);
      giveRules(link.sheet, this.#rules ?? link.sheet, young);
      this.#rules = young;
    } catch {
      this.#rules = undefined;
      this.#load(addressOf(link).replace(own, newest), link, () => link.remove());
    }
  }

  #load(href: string, behind: Element | undefined, then: () => void): void {
    const link = document.createElement("link");
    link.rel = "stylesheet";
    link.href = href;
    link.addEventListener("load", then);
    behind?.after(link);
  }
}
