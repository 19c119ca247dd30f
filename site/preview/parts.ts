// The page as it came from the server, beside the page as it is.
//
// Scripts and the reader change what they are shown: a lab runs, a quiz has answers, a callout is
// open. So a new page is never held against the page on the screen, but against the one that came
// before it; and only what differs between these two is replaced on the screen.

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

  /** The comments and elements of the lesson's text, in their order, each element as it is shown. */
  *text(): Generator<Comment | Element> {
    for (const node of this.#page.querySelector(".prose")?.childNodes ?? []) {
      if (node instanceof Comment) yield node;
      const shown = node instanceof Element ? this.#shown.get(node) : undefined;
      if (shown) yield shown;
    }
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
    const young = [...after.children];
    const pairs = samePairs(old, young);
    let at = 0;
    let next = 0;
    for (const [i, j] of [...pairs, [old.length, young.length] as const]) {
      const kept = old[i];
      const anchor = kept ? this.#shown.get(kept)! : this.#behind(old, shown);
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
