// Marks, in the list of contents, the section that is being read.

import { decoded } from "./decoded.js";

// A heading counts as reached once it is this far from the top of the window, in pixels.
const reached = 160;

interface Section {
  heading: HTMLElement;
  link: HTMLAnchorElement;
}

function sections(): Section[] {
  const links = document.querySelectorAll<HTMLAnchorElement>("nav.contents a[href^='#']");
  return [...links].flatMap((link) => {
    const heading = document.getElementById(decoded(link.hash.slice(1)));
    return heading ? [{ heading, link }] : [];
  });
}

let all: Section[] | undefined;
let marked: HTMLAnchorElement | undefined;
let waiting = false;

function mark(): void {
  waiting = false;
  const now = all?.findLast(({ heading }) => heading.getBoundingClientRect().top < reached);
  if (now?.link === marked) return;
  marked?.removeAttribute("aria-current");
  marked = now?.link;
  marked?.setAttribute("aria-current", "true");
}

// With the next frame, when the browser knows where everything stands.
function markSoon(): void {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(mark);
}

/** Again when headings or links came or went. */
export function followContents(): void {
  if (!all) addEventListener("scroll", markSoon, { passive: true });
  all = sections();
  markSoon();
}
