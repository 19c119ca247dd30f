// News of versions. A browser has six connections to one server, so all its tabs share one, which a
// worker holds; where there are no shared workers, each tab has its own.

type Tell = (news: News) => void;

/** A version's number, or that nobody answers. */
export type News = number | "gone";

/** What the worker does, and each tab without one. */
export function listen(tell: Tell): void {
  const events = new EventSource("/.preview/events");
  events.onmessage = ({ data }) => tell(Number(data));
  events.onerror = () => tell("gone"); // the browser tries again by itself
}

export function hearNews(tell: Tell): void {
  if (!("SharedWorker" in window)) {
    listen(tell);
    return;
  }
  const worker = new SharedWorker("/.preview/worker.js", "mjcourse preview");
  worker.port.onmessage = ({ data }) => tell(data as News);
}
