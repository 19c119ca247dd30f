// Follows the reader of a lesson, quietly: the furthest section that was reached, and whether the
// lesson is done.
//
// It is done once its end was reached and all its questions were answered rightly, or when the
// reader says so. A reader who says that it is not is believed, until something of it is answered or
// reached anew.

import { decoded } from "../decoded.js";
import { keys, remember } from "../storage.js";
import { recallReading, rememberReading, type Reading } from "./readings.js";
import { showSigns } from "./signs.js";

/** A heading counts as reached once it is in the upper part of the window. */
const reached = "0px 0px -35% 0px";

class Follower {
  readonly #links = [...document.querySelectorAll<HTMLAnchorElement>("nav.contents a[href^='#']")];
  readonly #say = document.createElement("span");
  readonly #button = document.createElement("button");
  #reading: Reading;

  constructor(lesson: HTMLElement, foot: Element) {
    const before = recallReading(location.pathname);
    const start = { place: 0, section: "", heading: "", ended: false, done: false };
    this.#reading = { ...start, ...before, name: lesson.dataset["name"] ?? document.title };
    this.#keep({});
    this.#addButton(foot);
    this.#observe(foot);
    lesson.addEventListener("judged", () => this.#settle());
  }

  #observe(foot: Element): void {
    const observer = new IntersectionObserver(
      (entries) => {
        for (const { target, isIntersecting } of entries) {
          if (isIntersecting) this.#reach(target.id);
        }
      },
      { rootMargin: reached },
    );
    for (const { hash } of this.#links) {
      const heading = document.getElementById(decoded(hash.slice(1)));
      if (heading) observer.observe(heading);
    }
    new IntersectionObserver((entries) => {
      if (!entries.some((entry) => entry.isIntersecting) || this.#reading.ended) return;
      this.#keep({ ended: true });
      this.#settle();
    }).observe(foot);
  }

  #reach(id: string): void {
    const index = this.#links.findIndex((link) => decoded(link.hash.slice(1)) === id);
    if (index < this.#reading.place) return;
    this.#keep({ place: index + 1, section: id, heading: plainText(this.#links[index]!) });
  }

  #settle(): void {
    const open = document.querySelector('form.question:not([data-verdict="right"])');
    if (this.#reading.ended && !open && !this.#reading.done) this.#keep({ done: true });
  }

  #keep(change: Partial<Reading>): void {
    this.#reading = { ...this.#reading, ...change };
    rememberReading(location.pathname, this.#reading);
    if ("done" in change || "ended" in change) showSigns();
    this.#label();
  }

  #addButton(foot: Element): void {
    const row = document.createElement("p");
    row.className = "done-mark";
    this.#say.setAttribute("role", "status");
    this.#button.type = "button";
    this.#button.className = "plain-button";
    this.#button.addEventListener("click", () => this.#keep({ done: !this.#reading.done }));
    row.append(this.#say, this.#button);
    foot.querySelector("nav.turn")?.before(row);
  }

  #label(): void {
    const { done } = this.#reading;
    this.#say.textContent = done ? "This lesson is done." : "";
    this.#button.textContent = done ? "Mark as not done" : "Mark as done";
  }
}

/** Without the formulas' second form, for screen readers. */
function plainText(element: Element): string {
  const copy = element.cloneNode(true) as Element;
  for (const twice of copy.querySelectorAll(".katex-mathml")) twice.remove();
  return copy.textContent.trim();
}

export function followReading(lesson: HTMLElement, foot: Element): void {
  remember(keys.last(new URL("..", location.href).pathname), location.pathname);
  new Follower(lesson, foot);
}
