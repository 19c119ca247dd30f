// An edition: the site as one build made it, and what the browser keeps of it, in a cache of its own.
//
// Its manifest (generator/page/edition_manifest.h) has a hash of each file. What comes from the network
// is held against that, so whatever is in the cache is of this edition.

import { decoded } from "../client/decoded.js";

/** Paths are below the site's root. */
interface Manifest {
  /** What a reader needs first, wherever he goes then. */
  readonly core: readonly string[];
  /** What is large and kept only where the reader has asked for it: no lesson needs it to be read. */
  readonly asked: readonly string[];
  /** SHA-256, its first 16 digits. */
  readonly files: Readonly<Record<string, readonly [hash: string, bytes: number]>>;
}

export interface Found {
  readonly response: Response;
  /** It is the file of this edition. */
  readonly own: boolean;
}

const digits = 16;
/** Is no file's path. */
const allMark = ".all";

async function hashOf(bytes: ArrayBuffer): Promise<string> {
  const hash = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  const text = Array.from(hash, (byte) => byte.toString(16).padStart(2, "0")).join("");
  return text.slice(0, digits);
}

/** As it came, but whole: what a host says of its packing is true of the packed bytes alone. */
function whole(response: Response, bytes: ArrayBuffer): Response {
  const headers = new Headers(response.headers);
  headers.delete("content-encoding");
  headers.delete("content-length");
  return new Response(bytes, { status: response.status, headers });
}

/** The names of the caches of the site at `root`. Several sites may share one origin. */
export async function cachesOf(root: string): Promise<string[]> {
  const names = await caches.keys();
  return names.filter((name) => name.startsWith(`mjcourse ${root} `));
}

export class Edition {
  private constructor(
    private readonly root: string,
    readonly cacheName: string,
    private readonly cache: Cache,
    private readonly manifest: Manifest,
  ) {}

  /** `name` is the path of its manifest. Throws where that cannot be had. */
  static async open(root: string, name: string): Promise<Edition> {
    const cacheName = `mjcourse ${root} ${name}`;
    const cache = await caches.open(cacheName);
    let response = await cache.match(root + name);
    if (!response) {
      response = await fetch(root + name);
      if (!response.ok) throw new Error(`${response.status} for ${name}`);
      await cache.put(root + name, response.clone());
    }
    return new Edition(root, cacheName, cache, (await response.json()) as Manifest);
  }

  get core(): readonly string[] {
    return this.manifest.core;
  }

  /** All but what is asked for by itself. */
  get paths(): string[] {
    return Object.keys(this.manifest.files).filter((path) => !this.isAsked(path));
  }

  get asked(): readonly string[] {
    return this.manifest.asked;
  }

  isAsked(path: string): boolean {
    return this.manifest.asked.includes(path);
  }

  sizes(): Record<string, number> {
    const { files } = this.manifest;
    return Object.fromEntries(Object.entries(files).map(([path, [, bytes]]) => [path, bytes]));
  }

  /** The file at an address, as hosts understand it; undefined for all that this edition has not. */
  pathOf(address: string): string | undefined {
    const plain = address.replace(/[?#].*$/s, "");
    if (!plain.startsWith(this.root)) return undefined;
    const path = decoded(plain.slice(this.root.length));
    return [path, `${path}index.html`, `${path}.html`].find((one) => this.has(one));
  }

  has(path: string): boolean {
    return Object.hasOwn(this.manifest.files, path);
  }

  private addressOf(path: string): string {
    return this.root + path.split("/").map(encodeURIComponent).join("/");
  }

  kept(path: string): Promise<Response | undefined> {
    return this.cache.match(this.addressOf(path));
  }

  async keptPaths(): Promise<string[]> {
    const requests = await this.cache.keys();
    const paths = requests.map(({ url }) => decoded(url.slice(this.root.length)));
    return paths.filter((path) => this.has(path));
  }

  /** From the network. Throws where there is none. */
  async fetch(path: string): Promise<Found> {
    // What the browser has of an earlier day is asked for anew.
    const response = await fetch(this.addressOf(path), { cache: "no-cache" });
    const bytes = await response.arrayBuffer();
    const own = response.ok && (await hashOf(bytes)) === this.manifest.files[path]?.[0];
    return { response: whole(response, bytes), own };
  }

  /** Keeps it where it is the file of this edition. */
  async putOwn(path: string, response: Response): Promise<void> {
    const bytes = await response.arrayBuffer();
    if ((await hashOf(bytes)) !== this.manifest.files[path]?.[0]) return;
    await this.put(path, whole(response, bytes));
  }

  /** Throws where there is no room. `response` is still whole afterwards. */
  async put(path: string, response: Response): Promise<void> {
    await this.cache.put(this.addressOf(path), response.clone());
  }

  async drop(path: string): Promise<void> {
    await this.cache.delete(this.addressOf(path));
  }

  /** The reader wants all of it, and of editions to come as well. */
  async wantAll(wanted: boolean): Promise<void> {
    if (wanted) await this.cache.put(this.root + allMark, new Response(""));
    else await this.drop(allMark);
  }

  async isAllWanted(): Promise<boolean> {
    return (await this.kept(allMark)) !== undefined;
  }

  /** Takes what `former` has and is the same here. Gives what is to be had anew, as it was kept there. */
  async takeOver(former: Edition): Promise<string[]> {
    const stale: string[] = [];
    for (const path of await former.keptPaths()) {
      if (!this.has(path) || (await this.kept(path))) continue;
      const response = await former.kept(path);
      const same = former.manifest.files[path]?.[0] === this.manifest.files[path]?.[0];
      if (same && response) await this.put(path, response);
      else stale.push(path);
    }
    return stale;
  }
}
