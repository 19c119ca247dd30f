// The script of the home page: the way back to where the reader left off, or on to the next lesson. It
// stands right behind the line that it fills, so that nothing moves.

import { keys, recall } from "../storage.js";
import { recallReading, type Reading } from "./readings.js";

interface Place {
  readonly path: string;
  readonly name: string;
  readonly reading?: Reading | undefined;
}

/** The lessons that the page lists before that line; none in a long course. */
const listed = (): HTMLAnchorElement[] => [
  ...document.querySelectorAll<HTMLAnchorElement>("nav.lessons ol ol a"),
];

const nameOf = (link: Element): string => link.textContent.replace(/\s+/g, " ").trim();

/** The next lesson behind the one at `path` that is not done; none leads out of the course itself. */
function nextBehind(path: string): Place | undefined {
  const links = listed();
  const at = links.findIndex((link) => link.pathname === path);
  const beside = links[at]?.closest(".beside") ?? null;
  for (const link of at < 0 ? [] : links.slice(at + 1)) {
    const reading = recallReading(link.pathname);
    if (link.closest(".beside") !== beside || reading?.done) continue;
    return { path: link.pathname, name: nameOf(link), reading };
  }
  return undefined;
}

function placeToContinue(): Place | undefined {
  const root = new URL(".", location.href).pathname;
  const path = recall(keys.last(root));
  const reading = path?.startsWith(root) ? recallReading(path) : undefined;
  if (path === null || !reading) return undefined;
  if (reading.done) return nextBehind(path);
  const links = listed();
  const gone = links.length > 0 && !links.some((link) => link.pathname === path);
  return gone ? undefined : { path, name: reading.name, reading };
}

function show(line: Element): void {
  const place = placeToContinue();
  if (!place) return;
  const { path, name, reading } = place;
  const link = document.createElement("a");
  link.href = path;
  link.hash = reading?.section ?? "";
  link.textContent = name + (reading?.heading ? `, ${reading.heading}` : "");
  line.replaceChildren("Continue: ", link);
}

show(document.querySelector("header.home-head > .continue")!);
