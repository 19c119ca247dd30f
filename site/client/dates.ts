// When a lesson was changed, as the reader writes dates. The day is the same for everybody: it is
// that of who made the change.

export function localizeDates(): void {
  for (const time of document.querySelectorAll<HTMLTimeElement>(".history time")) {
    const form = new Intl.DateTimeFormat(undefined, { dateStyle: "long", timeZone: "UTC" });
    time.textContent = form.format(new Date(time.dateTime));
    time.lang = form.resolvedOptions().locale;
  }
}
