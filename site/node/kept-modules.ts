/**
 * The modules that were linked last, by the SHA-256 of their bytes, for the runs that ask for them.
 * Enter with KeptModules.keep(). What was not asked for longest goes first.
 */
import { createHash } from "node:crypto";

const mostModules = 4;
const mostBytes = 64 << 20;

export class KeptModules {
  /** In the order of their last use. */
  readonly #modules = new Map<string, Uint8Array>();

  /** Gives the name by which to find it. The last one is kept whatever its size. */
  keep(module: Uint8Array): string {
    const name = createHash("sha256").update(module).digest("hex");
    this.#use(name, this.#modules.get(name) ?? module.slice());
    while (this.#modules.size > 1 && this.#isFull()) this.#dropOldest();
    return name;
  }

  find(name: string): Uint8Array | undefined {
    const module = this.#modules.get(name);
    if (module) this.#use(name, module);
    return module;
  }

  #use(name: string, module: Uint8Array): void {
    this.#modules.delete(name);
    this.#modules.set(name, module);
  }

  #isFull(): boolean {
    const bytes = [...this.#modules.values()].reduce((sum, { length }) => sum + length, 0);
    return this.#modules.size > mostModules || bytes > mostBytes;
  }

  #dropOldest(): void {
    const [oldest] = this.#modules.keys();
    this.#modules.delete(oldest!);
  }
}
