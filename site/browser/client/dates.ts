// When a lesson was changed, as the reader writes dates. The day is the same for everybody: it is
// that of the change's author.

import { whenNear } from "./near.js";

/** Once they are near: the first use of a browser's calendar takes longer than all else of a page. */
export function localizeDates(): void {
  const history = document.querySelector("footer.lesson-foot > .history");
  if (history) whenNear(history, () => localize(history));
}

function localize(history: Element): void {
  const form = new Intl.DateTimeFormat(undefined, { dateStyle: "long", timeZone: "UTC" });
  for (const time of history.querySelectorAll("time")) {
    time.textContent = form.format(new Date(time.dateTime));
    time.lang = form.resolvedOptions().locale;
  }
}
