// A new stylesheet takes the place of the old one once it is loaded, so the page never stands there
// without.

function sheetsIn(page: Document): HTMLLinkElement[] {
  return [...page.querySelectorAll<HTMLLinkElement>("link[rel=stylesheet]")].filter(
    (link) => !link.getAttribute("href")!.startsWith("/.preview/"),
  );
}

function addresses(page: Document): string[] {
  return sheetsIn(page).map((link) => link.getAttribute("href")!);
}

export class Styles {
  /** What the newest page names; of these the site's own stylesheet may have been edited since. */
  #named = addresses(document);

  /** From here on those that `page` names. */
  take(page: Document): void {
    this.#named = addresses(page);
  }

  /** Puts in place what is another; `site` is the newest form of the site's own, below the root. */
  renew(site: string): void {
    const wanted = this.#named.map((href) => href.replace(/assets\/site-\w+\.css$/, site));
    const old = sheetsIn(document);
    const gone = old.filter((link) => !wanted.includes(link.getAttribute("href")!));
    const remove = (): void => gone.forEach((link) => link.remove());
    let behind = old[0];
    let waits = false;
    for (const href of wanted) {
      let link = old.find((one) => one.getAttribute("href") === href);
      if (!link) {
        link = document.createElement("link");
        link.rel = "stylesheet";
        link.href = href;
        link.addEventListener("load", remove);
        behind?.after(link);
        waits = true;
      }
      behind = link;
    }
    if (!waits) remove();
  }
}
