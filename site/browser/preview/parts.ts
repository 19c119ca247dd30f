// The page as it came from the server, beside the page as it is.
//
// Scripts and the reader change what they are shown: a lab runs, a quiz has answers, a callout is
// open. So a new page is never held against the page on the screen, but against the one that came
// before it; and only what differs between these two is replaced on the screen.

import type { Change } from "./state.js";

// What is gone through part by part; everything else is replaced as a whole.
const containers = "body, main, article, .prose, .lesson-head, .lesson-foot, .masthead, .site-head";

// Of two containers, what is in them may differ.
function isSame(a: Element, b: Element): boolean {
  return a.matches(containers) || b.matches(containers) ? keyOf(a) === keyOf(b) : a.isEqualNode(b);
}

function keyOf(element: Element): string {
  const isContainer = element.matches(containers);
  return isContainer ? `${element.tagName} ${element.className}` : element.outerHTML;
}

/** The pairs of indices at which the longest common subsequence of two lists stands. */
export function commonPairs(
  before: readonly string[],
  after: readonly string[],
): [number, number][] {
  const length = Array.from({ length: before.length + 1 }, () => new Uint32Array(after.length + 1));
  for (let i = before.length - 1; i >= 0; i--) {
    for (let j = after.length - 1; j >= 0; j--) {
      length[i]![j] =
        before[i] === after[j]
          ? length[i + 1]![j + 1]! + 1
          : Math.max(length[i + 1]![j]!, length[i]![j + 1]!);
    }
  }
  const pairs: [number, number][] = [];
  for (let i = 0, j = 0; i < before.length && j < after.length;) {
    if (before[i] === after[j]) pairs.push([i++, j++]);
    else if (length[i + 1]![j]! >= length[i]![j + 1]!) i++;
    else j++;
  }
  return pairs;
}

/** The same of parts. A save changes little: what is alike at both ends needs no search. */
function samePairs(old: readonly Element[], young: readonly Element[]): [number, number][] {
  const most = Math.min(old.length, young.length);
  let head = 0;
  while (head < most && isSame(old[head]!, young[head]!)) head++;
  let tail = 0;
  while (tail < most - head && isSame(old.at(-1 - tail)!, young.at(-1 - tail)!)) tail++;
  const middle = (all: readonly Element[]): string[] =>
    all.slice(head, all.length - tail).map(keyOf);
  return [
    ...Array.from({ length: head }, (_, i): [number, number] => [i, i]),
    ...commonPairs(middle(old), middle(young)).map(([i, j]): [number, number] => [
      head + i,
      head + j,
    ]),
    ...Array.from({ length: tail }, (_, i): [number, number] => [
      old.length - tail + i,
      young.length - tail + i,
    ]),
  ];
}

function alike(a: Element, b: Element): boolean {
  return a.tagName === b.tagName && a.className === b.className;
}

/** What the author opened or typed, in a part that is replaced by a newer form of itself. */
function carryOver(from: Element, to: Element): void {
  const open = [...from.querySelectorAll("details")];
  const folds = [...to.querySelectorAll("details")];
  if (from instanceof HTMLDetailsElement && to instanceof HTMLDetailsElement) to.open = from.open;
  if (open.length !== folds.length) return;
  folds.forEach((fold, index) => (fold.open = open[index]!.open));
}

/** From `first` on, without `end`. */
function* nodesBetween(first: ChildNode, end: ChildNode): Generator<ChildNode> {
  for (let node = first; node !== end; node = node.nextSibling!) yield node;
}

function elementsOf(nodes: Iterable<Node>): Element[] {
  return [...nodes].filter((node) => node instanceof Element);
}

export class Parts {
  #page: Document;
  /** Elements of the page as it came → those on the screen. */
  #shown = new WeakMap<Element, Element>();

  /** At once when the document was read, before any script has changed it. */
  constructor() {
    this.#page = document.cloneNode(true) as Document;
    this.#pair(this.#page.body, document.body);
  }

  /** Puts in place what `page` has otherwise; gives what was put. */
  replace(page: Document): Element[] {
    const put: Element[] = [];
    this.#replaceIn(this.#page.body, page.body, document.body, put);
    this.#page = page;
    return put;
  }

  /** The same of what is another in the lesson's text. */
  change({ first, count, html }: Change): Element[] {
    const template = this.#page.createElement("template");
    template.innerHTML = html;
    const marks = this.#marks();
    const end = marks[first + count]!;
    const old = [...nodesBetween(marks[first]!, end)];
    const next = end.nextElementSibling;
    const prose = end.parentElement!;
    const shown = this.#shown.get(prose)!;
    const anchor = next ? this.#shown.get(next)! : this.#behind([...prose.children], shown);
    const put: Element[] = [];
    this.#replaceRun(elementsOf(old), [...template.content.children], shown, anchor, put);
    for (const node of old) prose.removeChild(node);
    end.before(template.content);
    return put;
  }

  /** The first element of each part of the lesson's text, as it is shown; undefined where a part
   *  shows nothing. */
  text(): (Element | undefined)[] {
    const marks = this.#marks();
    return marks.slice(0, -1).map((mark, index) => {
      const [came] = elementsOf(nodesBetween(mark, marks[index + 1]!));
      return came && this.#shown.get(came);
    });
  }

  /** The comments before each part of the lesson's text, and the one at its end. */
  #marks(): Comment[] {
    const nodes = [...(this.#page.querySelector(".prose")?.childNodes ?? [])];
    const comments = nodes.filter((node) => node instanceof Comment);
    return comments.filter(({ data }) => data.startsWith("lines"));
  }

  #pair(came: Element, shown: Element): void {
    this.#shown.set(came, shown);
    if (!came.matches(containers)) return;
    [...came.children].forEach((child, index) => this.#pair(child, shown.children[index]!));
  }

  #put(came: Element, parent: Element, before: Element | null, put: Element[]): Element {
    const shown = document.importNode(came, true);
    this.#pair(came, shown);
    parent.insertBefore(shown, before);
    put.push(shown);
    return shown;
  }

  #replaceIn(before: Element, after: Element, shown: Element, put: Element[]): void {
    const old = [...before.children];
    this.#replaceRun(old, [...after.children], shown, this.#behind(old, shown), put);
  }

  /** Of children of `shown` that stand one after the other, before `end`. */
  #replaceRun(
    old: readonly Element[],
    young: readonly Element[],
    shown: Element,
    end: Element | null,
    put: Element[],
  ): void {
    const pairs = samePairs(old, young);
    let at = 0;
    let next = 0;
    for (const [i, j] of [...pairs, [old.length, young.length] as const]) {
      const kept = old[i];
      const anchor = kept ? this.#shown.get(kept)! : end;
      this.#replaceSome(old.slice(at, i), young.slice(next, j), shown, anchor, put);
      if (kept) this.#keep(kept, young[j]!, put);
      at = i + 1;
      next = j + 1;
    }
  }

  /** Where the last of `old` ends: scripts may have put something of their own behind it. */
  #behind(old: readonly Element[], parent: Element): Element | null {
    const last = old.at(-1);
    return last ? this.#shown.get(last)!.nextElementSibling : parent.firstElementChild;
  }

  #replaceSome(
    old: readonly Element[],
    young: readonly Element[],
    parent: Element,
    before: Element | null,
    put: Element[],
  ): void {
    old.forEach((gone, index) => {
      const came = young[index];
      const shown = this.#shown.get(gone)!;
      if (came) {
        const instead = this.#put(came, parent, shown, put);
        if (alike(gone, came)) carryOver(shown, instead);
      }
      shown.remove();
    });
    for (const came of young.slice(old.length)) this.#put(came, parent, before, put);
  }

  #keep(kept: Element, came: Element, put: Element[]): void {
    const shown = this.#shown.get(kept)!;
    this.#shown.set(came, shown);
    if (came.matches(containers)) this.#replaceIn(kept, came, shown, put);
  }
}
