// Where the site lies. This script is in its `assets/`, so that is known on every page, also on one
// that is shown at an address where there is none (404.html).

const own = document.currentScript;

/** Ends with a slash. */
export const root = own instanceof HTMLScriptElement ? new URL("..", own.src).href : "";

/** Whether no other copy of this script has the page: 404.html asks for it in several folders. */
export function claimPage(): boolean {
  const { dataset } = document.documentElement;
  if (dataset["root"] !== undefined) return false;
  dataset["root"] = root;
  return true;
}
