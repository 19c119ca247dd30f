// When a lesson was changed, as the reader writes dates. The day is the same for everybody: it is
// that of who made the change.

// Ahead of what is in sight, in pixels.
const near = "300px";

/** Once they are near: the first use of a browser's calendar takes longer than all else of a page. */
export function localizeDates(): void {
  const history = document.querySelector(".history");
  if (!history) return;
  const observer = new IntersectionObserver(
    ([entry]) => {
      if (!entry?.isIntersecting) return;
      observer.disconnect();
      localize(history);
    },
    { rootMargin: near },
  );
  observer.observe(history);
}

function localize(history: Element): void {
  const form = new Intl.DateTimeFormat(undefined, { dateStyle: "long", timeZone: "UTC" });
  for (const time of history.querySelectorAll("time")) {
    time.textContent = form.format(new Date(time.dateTime));
    time.lang = form.resolvedOptions().locale;
  }
}
