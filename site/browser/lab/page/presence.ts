/** Whether a lab can be seen: some part of it is in the window, or nearly, and the window in front. */

const margin = "60px";

export class Presence {
  readonly #observer: IntersectionObserver;
  readonly #changed: () => void;
  readonly #inWindow = new Set<Element>();

  /** `changed` is called whenever another part can be seen, or one no more. */
  constructor(changed: () => void) {
    this.#changed = changed;
    this.#observer = new IntersectionObserver((entries) => this.#look(entries), {
      rootMargin: margin,
    });
    document.addEventListener("visibilitychange", changed);
  }

  watch(...parts: readonly Element[]): void {
    for (const part of parts) this.#observer.observe(part);
  }

  close(): void {
    this.#observer.disconnect();
    document.removeEventListener("visibilitychange", this.#changed);
  }

  get seen(): boolean {
    return this.#inWindow.size > 0 && document.visibilityState === "visible";
  }

  sees(part: Element): boolean {
    return this.#inWindow.has(part) && document.visibilityState === "visible";
  }

  #look(entries: readonly IntersectionObserverEntry[]): void {
    for (const { target, isIntersecting } of entries) {
      if (isIntersecting) this.#inWindow.add(target);
      else this.#inWindow.delete(target);
    }
    this.#changed();
  }
}
