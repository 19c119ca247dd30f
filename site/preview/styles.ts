// A new stylesheet takes the place of the old one once it is loaded, so the page never stands there
// without.

function sheets(page: Document): HTMLLinkElement[] {
  return [...page.querySelectorAll<HTMLLinkElement>("link[rel=stylesheet]")].filter(
    (link) => !link.getAttribute("href")!.startsWith("/.preview/"),
  );
}

export function replaceStyles(page: Document): void {
  const old = sheets(document);
  const wanted = sheets(page).map((link) => link.getAttribute("href")!);
  const is = (href: string) => (link: HTMLLinkElement) => link.getAttribute("href") === href;
  let behind = old[0];
  for (const href of wanted) {
    const there = old.find(is(href));
    if (!there) {
      const link = document.createElement("link");
      link.rel = "stylesheet";
      link.href = href;
      const gone = old.filter((one) => !wanted.some((other) => is(other)(one)));
      link.addEventListener("load", () => gone.forEach((one) => one.remove()));
      behind?.after(link);
      behind = link;
    } else {
      behind = there;
    }
  }
  if (wanted.length >= old.length) return;
  for (const link of old) if (!wanted.some((href) => is(href)(link))) link.remove();
}
