// What was found good once, and stays so until something changes: the user's cache holds a file for it,
// named by a hash of all that it depends on. Other checkouts find it, too. What nobody asked for during
// two months goes.
//
// Enter at new Stamps("tidy").

import { createHash } from "node:crypto";
import {
  existsSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  rmSync,
  statSync,
  utimesSync,
  writeFileSync,
} from "node:fs";
import { homedir } from "node:os";
import { join } from "node:path";

const unusedFor = 60 * 24 * 3600 * 1000; // ms

export class Stamps {
  #folder;

  constructor(name) {
    this.name = name;
    const cache = process.env.XDG_CACHE_HOME || join(homedir(), ".cache");
    this.#folder = join(cache, "mjcourse", name);
    mkdirSync(this.#folder, { recursive: true });
    for (const file of readdirSync(this.#folder).map((one) => join(this.#folder, one))) {
      const { mtimeMs } = statSync(file, { throwIfNoEntry: false }) ?? {};
      if (mtimeMs < Date.now() - unusedFor) rmSync(file, { force: true });
    }
  }

  // The name of what depends on `parts`, strings and bytes.
  static of(...parts) {
    const hash = createHash("sha256");
    for (const part of parts) hash.update(part);
    return hash.digest("hex");
  }

  has(stamp) {
    const file = join(this.#folder, stamp);
    if (!existsSync(file)) return false;
    utimesSync(file, new Date(), new Date());
    return true;
  }

  // What was put there; nothing where nothing was.
  get(stamp) {
    return this.has(stamp) ? readFileSync(join(this.#folder, stamp), "utf8") : undefined;
  }

  // The seconds that each took last time, several at once; nothing where that is not known.
  get pace() {
    const file = join(this.#folder, "pace");
    return existsSync(file) ? Number(readFileSync(file, "utf8")) : undefined;
  }
  set pace(seconds) {
    writeFileSync(join(this.#folder, "pace"), String(seconds));
  }

  // `what` is the stamp's content, which get() gives; it should tell a reader of the folder what was done.
  put(stamp, what) {
    writeFileSync(join(this.#folder, stamp), what);
  }
}
