// A list that its reader puts in order: each item has two buttons, and a grip to be dragged by.
//
// What moves past another is always the other: the item that is held or whose button was pressed
// stays in the document, and so keeps the focus and the pointer.

export class Sortable {
  readonly #list: HTMLUListElement;
  readonly #shuffled: readonly string[];
  readonly #moved: (place: number, count: number) => void;

  /** `name` is the form field that holds the items' letters; `moved` hears of each move. */
  constructor(list: HTMLUListElement, name: string, moved: (place: number, count: number) => void) {
    this.#list = list;
    this.#moved = moved;
    this.#shuffled = this.#items.map(letterOf);
    list.classList.add("sortable");
    for (const item of this.#items) this.#equip(item, name);
    this.#mark();
  }

  /** Lets the items stand as `letters` say; without them, as they were at first. */
  arrange(letters: readonly string[] = this.#shuffled): void {
    const items = this.#items;
    const known = [...letters].sort().join() === items.map(letterOf).sort().join();
    if (!known) return;
    for (const letter of letters) this.#list.append(items.find((i) => letterOf(i) === letter)!);
    this.#mark();
  }

  get #items(): HTMLLIElement[] {
    return [...this.#list.querySelectorAll("li")].filter((item) => item.parentNode === this.#list);
  }

  #equip(item: HTMLLIElement, name: string): void {
    const field = document.createElement("input");
    field.type = "hidden";
    field.name = name;
    field.value = letterOf(item);
    const grip = document.createElement("span");
    grip.className = "grip";
    grip.addEventListener("pointerdown", (event) => this.#drag(item, grip, event));
    item.prepend(grip);
    item.append(this.#button(item, "up"), this.#button(item, "down"), field);
  }

  #button(item: HTMLLIElement, way: "up" | "down"): HTMLButtonElement {
    const button = document.createElement("button");
    button.type = "button";
    button.className = `move ${way}`;
    button.id = `${item.id}-${way}`;
    // Its own label and the item's text: "Move up" and what.
    button.setAttribute("aria-label", `Move ${way}`);
    button.setAttribute("aria-labelledby", `${button.id} ${item.id}-text`);
    button.addEventListener("click", () => {
      if (this.#step(item, way)) this.#settle(item);
    });
    return button;
  }

  /** Lets the neighbour on that side change places with `item`; false at the end of the list. */
  #step(item: HTMLLIElement, way: "up" | "down"): boolean {
    if (way === "up") {
      const above = item.previousElementSibling;
      if (above) item.after(above);
      return above !== null;
    }
    const below = item.nextElementSibling;
    if (below) item.before(below);
    return below !== null;
  }

  #drag(item: HTMLLIElement, grip: HTMLElement, start: PointerEvent): void {
    if (start.button !== 0) return;
    start.preventDefault(); // selects no text
    grip.setPointerCapture(start.pointerId);
    item.classList.add("dragged");
    const before = this.#items.indexOf(item);
    const follow = (event: PointerEvent): void => {
      while (pastMiddle(event.clientY, item.previousElementSibling, -1)) this.#step(item, "up");
      while (pastMiddle(event.clientY, item.nextElementSibling, 1)) this.#step(item, "down");
    };
    const release = new AbortController();
    const end = (): void => {
      release.abort();
      item.classList.remove("dragged");
      if (this.#items.indexOf(item) !== before) this.#settle(item);
    };
    grip.addEventListener("pointermove", follow, { signal: release.signal });
    grip.addEventListener("lostpointercapture", end, { signal: release.signal });
  }

  #settle(item: HTMLLIElement): void {
    this.#mark();
    const items = this.#items;
    this.#moved(items.indexOf(item) + 1, items.length);
  }

  /** A button at the end of its way stays where it is, so that it keeps the focus. */
  #mark(): void {
    const items = this.#items;
    items.forEach((item, place) => {
      const ends = { ".up": place === 0, ".down": place === items.length - 1 };
      for (const [selector, end] of Object.entries(ends)) {
        item.querySelector(selector)?.setAttribute("aria-disabled", String(end));
      }
    });
  }
}

const letterOf = (item: HTMLLIElement): string => item.dataset["letter"] ?? "";

/** Whether `y` is beyond the middle of `neighbour`, which lies above (-1) or below (1). */
function pastMiddle(y: number, neighbour: Element | null, side: -1 | 1): boolean {
  if (!neighbour) return false;
  const { top, height } = neighbour.getBoundingClientRect();
  return (y - (top + height / 2)) * side > 0;
}
