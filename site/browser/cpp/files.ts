/**
 * Files in memory, by absolute path: all that clang, the linker and a reader's program see of a file
 * system. A layer may lie over another one, which many share and nobody writes: what is written or
 * removed stays in the upper one.
 */
export interface File {
  /** Has room for more than `size` bytes where the file was written. */
  data: Uint8Array;
  size: number;
}

export class Files {
  readonly #files = new Map<string, File>();
  readonly #folders = new Set(["/"]);
  readonly #removed = new Set<string>();

  constructor(private readonly below?: Files) {}

  /** Adds a file, in place of one that has this path, and its folders. Bytes are this layer's from then on. */
  put(path: string, data: string | Uint8Array): void {
    const bytes = typeof data === "string" ? new TextEncoder().encode(data) : data;
    const absolute = normalized(path);
    this.#files.set(absolute, { data: bytes, size: bytes.length });
    this.#removed.delete(absolute);
    this.addFolder(folderOf(absolute));
  }

  addFolder(path: string): void {
    for (let folder = path; !this.#folders.has(folder); folder = folderOf(folder)) {
      this.#folders.add(folder);
    }
  }

  get(path: string): File | undefined {
    if (this.#removed.has(path)) return undefined;
    return this.#files.get(path) ?? this.below?.get(path);
  }

  /** To write into: a copy where it lies in a layer below. */
  own(path: string): File | undefined {
    const own = this.#files.get(path);
    const found = own ?? this.get(path);
    if (found === undefined || own !== undefined) return own;
    const copy = { data: found.data.slice(0, found.size), size: found.size };
    this.#files.set(path, copy);
    return copy;
  }

  /** The content; it is gone with the next write. */
  bytes(path: string): Uint8Array | undefined {
    const found = this.get(normalized(path));
    return found?.data.subarray(0, found.size);
  }

  isFolder(path: string): boolean {
    return this.#folders.has(path) || (this.below?.isFolder(path) ?? false);
  }

  remove(path: string): void {
    this.#files.delete(path);
    if (this.below?.get(path)) this.#removed.add(path);
  }

  removeFolder(path: string): void {
    this.#folders.delete(path);
  }

  /** Of all layers. */
  paths(): string[] {
    const below = this.below?.paths() ?? [];
    return [...new Set([...below, ...this.#files.keys()])].filter((path) => this.get(path));
  }

  folders(): string[] {
    return [...(this.below?.folders() ?? []), ...this.#folders];
  }

  /** The names in a folder. */
  list(folder: string): string[] {
    const inside = folder === "/" ? "/" : `${folder}/`;
    const names = new Set<string>();
    const add = (path: string) => {
      if (path.startsWith(inside)) names.add(path.slice(inside.length).split("/")[0]!);
    };
    this.paths().forEach(add);
    this.folders().forEach(add);
    names.delete("");
    return [...names];
  }
}

/** An absolute path without `.`, `..` and doubled slashes. */
export function normalized(path: string): string {
  const steps: string[] = [];
  for (const step of path.split("/")) {
    if (step === "..") steps.pop();
    else if (step !== "" && step !== ".") steps.push(step);
  }
  return `/${steps.join("/")}`;
}

export function folderOf(path: string): string {
  return path.slice(0, path.lastIndexOf("/")) || "/";
}
