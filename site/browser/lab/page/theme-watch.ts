/** What is drawn on a canvas must be drawn again when the page's colours change. */

const listeners = new Set<() => void>();

/** Called after the reader's theme or the system's scheme or contrast changed. */
export function onThemeChange(listener: () => void): void {
  if (listeners.size === 0) watch();
  listeners.add(listener);
}

function watch(): void {
  const tell = (): void => {
    for (const listener of listeners) listener();
  };
  for (const query of ["(prefers-color-scheme: dark)", "(prefers-contrast: more)"]) {
    matchMedia(query).addEventListener("change", tell);
  }
  const root = document.documentElement;
  new MutationObserver(tell).observe(root, { attributeFilter: ["data-theme"] });
}
