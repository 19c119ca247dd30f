/**
 * WASI preview 1 over files in memory: what clang, the linker and a reader's program ask of their
 * system. Enter with wasi(), whose functions are the imports of `wasi_snapshot_preview1`.
 *
 * Nothing of the browser's is behind it: no network, no storage. Where a call gives an error, it is
 * one of the numbers of WASI.
 */
import { isOutOfMemory } from "./exhausted.js";
import { folderOf, normalized, type File, type Files } from "./files.js";

/** A program called exit(). */
export class Exit extends Error {
  override readonly name = "Exit";
  constructor(readonly code: number) {
    super(`exit ${code}`);
  }
}

export type Stream = "out" | "err";

export interface System {
  readonly args: readonly string[];
  readonly env?: Readonly<Record<string, string>>;
  readonly files: Files;
  readonly memory: () => WebAssembly.Memory;
  /** What is written to a stream; the bytes may be kept. */
  readonly write: (stream: Stream, bytes: Uint8Array) => void;
  /** What exit() does; by default it throws an Exit. */
  readonly exit?: (code: number) => never;
  /** In bytes; by default a file is as large as it will. */
  readonly largestFile?: number;
  /** Hears of one that would be larger. Where this returns, the call fails. */
  readonly full?: () => void;
}

type Imports = Readonly<Record<string, (...args: never[]) => number>>;

const Errno = {
  success: 0,
  badf: 8,
  exist: 20,
  inval: 28,
  isdir: 31,
  noent: 44,
  nospc: 51,
  nosys: 52,
  notdir: 54,
  notempty: 55,
  notsup: 58,
  spipe: 70,
} as const;

const FileType = { unknown: 0, characterDevice: 2, directory: 3, regular: 4 } as const;

/** Bits of path_open. */
const Open = { create: 1, directory: 2, exclusive: 4, truncate: 8 } as const;
const rightToWrite = 64n;
const allRights = 0x1fffffffn;
/** A terminal can neither be sought in nor told of. */
const seekRights = 0x24n;

interface Descriptor {
  readonly stream?: Stream | "in";
  readonly folder?: string;
  readonly path?: string;
  readonly file?: File;
  place: number;
  readonly append?: boolean;
  names?: readonly string[];
}

export function wasi(system: System): Imports {
  return { ...new Process(system).imports(), ...refused };
}

/** What no program of ours needs. */
const refused = Object.fromEntries(
  [
    "path_link",
    "path_symlink",
    "fd_allocate",
    "sock_accept",
    "sock_recv",
    "sock_send",
    "sock_shutdown",
  ].map((name) => [name, () => Errno.notsup]),
);

class Process {
  readonly #open = new Map<number, Descriptor>([
    [0, { stream: "in", place: 0 }],
    [1, { stream: "out", place: 0 }],
    [2, { stream: "err", place: 0 }],
    [3, { folder: "/", place: 0 }],
  ]);
  #next = 4;
  #slept = 0n;
  readonly #inodes = new Map<string, bigint>();
  #view = new DataView(new ArrayBuffer(0));
  #bytes = new Uint8Array(0);

  constructor(private readonly system: System) {}

  imports(): Imports {
    const args = this.#strings(this.system.args);
    const variables = Object.entries(this.system.env ?? {}).map((pair) => pair.join("="));
    const env = this.#strings(variables);
    return {
      args_sizes_get: args.sizes,
      args_get: args.get,
      environ_sizes_get: env.sizes,
      environ_get: env.get,
      ...this.#clocks(),
      ...this.#descriptors(),
      ...this.#paths(),
      proc_exit: (code: number) => {
        if (this.system.exit) this.system.exit(code);
        throw new Exit(code);
      },
      sched_yield: () => Errno.success,
      random_get: (at: number, length: number) => {
        this.#look();
        const most = 65536; // that one call of the browser's gives
        for (let i = 0; i < length; i += most) {
          crypto.getRandomValues(this.#bytes.subarray(at + i, at + Math.min(i + most, length)));
        }
        return Errno.success;
      },
    };
  }

  get #memory(): WebAssembly.Memory {
    return this.system.memory();
  }

  /** The memory as it is now: it may have grown since the last call. */
  #look(): DataView {
    const { buffer } = this.#memory;
    if (this.#view.buffer !== buffer) {
      this.#view = new DataView(buffer);
      this.#bytes = new Uint8Array(buffer);
    }
    return this.#view;
  }

  #text(at: number, length: number): string {
    this.#look();
    return new TextDecoder().decode(this.#bytes.slice(at, at + length));
  }

  #strings(list: readonly string[]) {
    const encoded = list.map((text) => new TextEncoder().encode(`${text}\0`));
    return {
      sizes: (count: number, size: number) => {
        const view = this.#look();
        view.setUint32(count, encoded.length, true);
        view.setUint32(
          size,
          encoded.reduce((sum, { length }) => sum + length, 0),
          true,
        );
        return Errno.success;
      },
      get: (places: number, texts: number) => {
        const view = this.#look();
        let at = texts;
        encoded.forEach((bytes, i) => {
          view.setUint32(places + 4 * i, at, true);
          this.#bytes.set(bytes, at);
          at += bytes.length;
        });
        return Errno.success;
      },
    };
  }

  #clocks(): Imports {
    return {
      clock_time_get: (clock: number, _precision: bigint, out: number) => {
        this.#look().setBigUint64(out, this.#now(clock), true);
        return Errno.success;
      },
      clock_res_get: (_clock: number, out: number) => {
        this.#look().setBigUint64(out, 1000n, true);
        return Errno.success;
      },
      poll_oneoff: (subscriptions: number, events: number, count: number, ready: number) => {
        const view = this.#look();
        for (let i = 0; i < count; ++i) {
          const event = events + 32 * i;
          const subscription = subscriptions + 48 * i;
          this.#sleep(subscription);
          view.setBigUint64(event, view.getBigUint64(subscription, true), true);
          view.setUint16(event + 8, Errno.success, true);
          view.setUint8(event + 10, view.getUint8(subscription + 8));
        }
        view.setUint32(ready, count, true);
        return Errno.success;
      },
    };
  }

  /** In nanoseconds; clock 0 is that of the wall. */
  #now(clock: number): bigint {
    const milliseconds = clock === 0 ? Date.now() : performance.now();
    return BigInt(Math.round(milliseconds * 1e6)) + this.#slept;
  }

  /** A worker cannot wait without burning its time, so sleeping moves the clocks forward instead. */
  #sleep(subscription: number): void {
    const view = this.#look();
    const isClock = view.getUint8(subscription + 8) === 0;
    if (!isClock) return;
    const time = view.getBigUint64(subscription + 24, true);
    const isAbsolute = (view.getUint16(subscription + 40, true) & 1) !== 0;
    const rest = isAbsolute ? time - this.#now(view.getUint32(subscription + 16, true)) : time;
    if (rest > 0n) this.#slept += rest;
  }

  #descriptors(): Imports {
    const file = (fd: number) => this.#open.get(fd)?.file;
    return {
      fd_close: (fd: number) => (this.#open.delete(fd) ? Errno.success : Errno.badf),
      fd_fdstat_get: (fd: number, out: number) => this.#describe(fd, out),
      fd_fdstat_set_flags: () => Errno.success,
      fd_filestat_get: (fd: number, out: number) => {
        const found = this.#open.get(fd);
        if (!found) return Errno.badf;
        if (found.stream) return this.#stat(out, FileType.characterDevice, 0, "");
        if (found.file) return this.#stat(out, FileType.regular, found.file.size, found.path!);
        return this.#statPath(found.folder!, out);
      },
      fd_filestat_set_size: (fd: number, size: bigint) => {
        const found = file(fd);
        if (!found) return Errno.badf;
        if (size < 0n) return Errno.inval;
        if (!this.#makeRoom(found, Number(size))) return Errno.nospc;
        if (size < found.size) found.data.fill(0, Number(size), found.size);
        found.size = Number(size);
        return Errno.success;
      },
      fd_filestat_set_times: () => Errno.success,
      fd_sync: () => Errno.success,
      fd_datasync: () => Errno.success,
      fd_advise: () => Errno.success,
      fd_read: (fd: number, vectors: number, count: number, out: number) => {
        const found = this.#open.get(fd);
        if (!found) return Errno.badf;
        if (found.folder !== undefined) return Errno.isdir;
        const read = found.file ? this.#read(found.file, found.place, vectors, count) : 0;
        found.place += read;
        this.#look().setUint32(out, read, true);
        return Errno.success;
      },
      fd_pread: (fd: number, vectors: number, count: number, place: bigint, out: number) => {
        const found = file(fd);
        if (!found) return Errno.badf;
        if (place < 0n) return Errno.inval;
        this.#look().setUint32(out, this.#read(found, Number(place), vectors, count), true);
        return Errno.success;
      },
      fd_write: (fd: number, vectors: number, count: number, out: number) => {
        const found = this.#open.get(fd);
        if (!found || (!found.file && !found.stream)) return Errno.badf;
        const bytes = joined(this.#vectors(vectors, count));
        if (found.file) {
          if (found.append) found.place = found.file.size;
          if (!this.#writeAt(found.file, found.place, bytes)) return Errno.nospc;
          found.place += bytes.length;
        } else if (found.stream !== "in") this.system.write(found.stream!, bytes);
        this.#look().setUint32(out, bytes.length, true);
        return Errno.success;
      },
      fd_pwrite: (fd: number, vectors: number, count: number, place: bigint, out: number) => {
        const found = file(fd);
        if (!found) return Errno.badf;
        if (place < 0n) return Errno.inval;
        const bytes = joined(this.#vectors(vectors, count));
        if (!this.#writeAt(found, Number(place), bytes)) return Errno.nospc;
        this.#look().setUint32(out, bytes.length, true);
        return Errno.success;
      },
      fd_seek: (fd: number, offset: bigint, whence: number, out: number) =>
        this.#seek(fd, Number(offset), whence, out),
      fd_tell: (fd: number, out: number) => this.#seek(fd, 0, 1, out),
      fd_renumber: (from: number, to: number) => {
        const found = this.#open.get(from);
        if (!found) return Errno.badf;
        this.#open.set(to, found);
        this.#open.delete(from);
        return Errno.success;
      },
      fd_prestat_get: (fd: number, out: number) => {
        if (fd !== 3) return Errno.badf;
        const view = this.#look();
        view.setUint32(out, 0, true);
        view.setUint32(out + 4, 1, true);
        return Errno.success;
      },
      fd_prestat_dir_name: (_fd: number, at: number) => {
        this.#look().setUint8(at, "/".charCodeAt(0));
        return Errno.success;
      },
      fd_readdir: (fd: number, at: number, length: number, cookie: bigint, out: number) =>
        this.#readFolder(fd, at, length, Number(cookie), out),
    };
  }

  #paths(): Imports {
    const { files } = this.system;
    return {
      path_open: (
        fd: number,
        _lookup: number,
        at: number,
        length: number,
        how: number,
        rights: bigint,
        _inherited: bigint,
        flags: number,
        out: number,
      ) => this.#openPath(this.#path(fd, at, length), how, rights, flags, out),
      path_filestat_get: (fd: number, _flags: number, at: number, length: number, out: number) =>
        this.#statPath(this.#path(fd, at, length), out),
      path_filestat_set_times: () => Errno.success,
      path_create_directory: (fd: number, at: number, length: number) => {
        const path = this.#path(fd, at, length);
        if (files.isFolder(path) || files.get(path)) return Errno.exist;
        files.addFolder(path);
        return Errno.success;
      },
      path_readlink: (fd: number, at: number, length: number) => {
        const path = this.#path(fd, at, length);
        return files.get(path) || files.isFolder(path) ? Errno.inval : Errno.noent;
      },
      path_unlink_file: (fd: number, at: number, length: number) => {
        const path = this.#path(fd, at, length);
        if (!files.get(path)) return files.isFolder(path) ? Errno.isdir : Errno.noent;
        files.remove(path);
        return Errno.success;
      },
      path_remove_directory: (fd: number, at: number, length: number) => {
        const path = this.#path(fd, at, length);
        if (!files.isFolder(path)) return Errno.noent;
        if (files.list(path).length > 0) return Errno.notempty;
        files.removeFolder(path);
        return Errno.success;
      },
      path_rename: (
        fd: number,
        at: number,
        length: number,
        newFd: number,
        newAt: number,
        newLength: number,
      ) => {
        const path = this.#path(fd, at, length);
        const found = files.own(path);
        if (!found) return Errno.noent;
        files.put(this.#path(newFd, newAt, newLength), found.data.subarray(0, found.size));
        files.remove(path);
        return Errno.success;
      },
    };
  }

  #path(fd: number, at: number, length: number): string {
    const path = this.#text(at, length);
    if (path.startsWith("/")) return normalized(path);
    const { folder } = this.#open.get(fd) ?? {};
    return normalized(`${folder ?? ""}/${path}`);
  }

  #openPath(path: string, how: number, rights: bigint, flags: number, out: number): number {
    const { files } = this.system;
    const writes = (rights & rightToWrite) !== 0n;
    const exclusive = (how & Open.create) !== 0 && (how & Open.exclusive) !== 0;
    let file = files.get(path);
    if (!file && files.isFolder(path)) {
      if (exclusive) return Errno.exist;
      return writes ? Errno.isdir : this.#give({ folder: path, place: 0 }, out);
    }
    if ((how & Open.directory) !== 0) return file ? Errno.notdir : Errno.noent;
    if (file && exclusive) return Errno.exist;
    if (!file) {
      if ((how & Open.create) === 0 || !files.isFolder(folderOf(path))) return Errno.noent;
      files.put(path, "");
      file = files.get(path)!;
    }
    if (writes || (how & Open.truncate) !== 0) file = files.own(path)!;
    if ((how & Open.truncate) !== 0) Object.assign(file, { data: new Uint8Array(0), size: 0 });
    return this.#give({ file, path, place: 0, append: (flags & 1) !== 0 }, out);
  }

  #give(descriptor: Descriptor, out: number): number {
    this.#open.set(this.#next, descriptor);
    this.#look().setUint32(out, this.#next++, true);
    return Errno.success;
  }

  #describe(fd: number, out: number): number {
    const found = this.#open.get(fd);
    if (!found) return Errno.badf;
    const view = this.#look();
    const type = found.file ? FileType.regular : FileType.directory;
    const rights = found.stream ? allRights & ~seekRights : allRights;
    view.setUint8(out, found.stream ? FileType.characterDevice : type);
    view.setUint16(out + 2, found.append ? 1 : 0, true);
    view.setBigUint64(out + 8, rights, true);
    view.setBigUint64(out + 16, rights, true);
    return Errno.success;
  }

  #statPath(path: string, out: number): number {
    const { files } = this.system;
    const file = files.get(path);
    if (file) return this.#stat(out, FileType.regular, file.size, path);
    return files.isFolder(path) ? this.#stat(out, FileType.directory, 0, path) : Errno.noent;
  }

  #stat(out: number, type: number, size: number, path: string): number {
    const view = this.#look();
    this.#bytes.fill(0, out, out + 64);
    view.setBigUint64(out + 8, this.#inode(path), true);
    view.setUint8(out + 16, type);
    view.setBigUint64(out + 24, 1n, true);
    view.setBigUint64(out + 32, BigInt(size), true);
    return Errno.success;
  }

  /** clang takes two paths with one number for the same file. */
  #inode(path: string): bigint {
    const known = this.#inodes.get(path);
    if (known !== undefined) return known;
    const inode = BigInt(this.#inodes.size + 1);
    this.#inodes.set(path, inode);
    return inode;
  }

  #vectors(at: number, count: number): Uint8Array[] {
    const view = this.#look();
    return Array.from({ length: count }, (_, i) => {
      const begin = view.getUint32(at + 8 * i, true);
      return this.#bytes.subarray(begin, begin + view.getUint32(at + 8 * i + 4, true));
    });
  }

  #read(file: File, place: number, at: number, count: number): number {
    let read = 0;
    for (const room of this.#vectors(at, count)) {
      const from = Math.min(place + read, file.size);
      const bytes = file.data.subarray(from, Math.min(from + room.length, file.size));
      room.set(bytes);
      read += bytes.length;
      if (bytes.length < room.length) break;
    }
    return read;
  }

  /** Says whether it could. */
  #writeAt(file: File, place: number, bytes: Uint8Array): boolean {
    if (!this.#makeRoom(file, place + bytes.length)) return false;
    file.data.set(bytes, place);
    file.size = Math.max(file.size, place + bytes.length);
    return true;
  }

  #makeRoom(file: File, size: number): boolean {
    const { largestFile = Infinity, full } = this.system;
    if (size <= largestFile) return grow(file, size);
    full?.();
    return false;
  }

  #seek(fd: number, offset: number, whence: number, out: number): number {
    const found = this.#open.get(fd);
    if (!found) return Errno.badf;
    if (!found.file) return Errno.spipe;
    const place = [0, found.place, found.file.size][whence]! + offset;
    if (!(place >= 0)) return Errno.inval;
    found.place = place;
    this.#look().setBigUint64(out, BigInt(place), true);
    return Errno.success;
  }

  #readFolder(fd: number, at: number, length: number, cookie: number, out: number): number {
    const found = this.#open.get(fd);
    if (found?.folder === undefined) return Errno.badf;
    found.names ??= this.system.files.list(found.folder);
    this.#look();
    let written = 0;
    for (let i = cookie; i < found.names.length && written < length; ++i) {
      const entry = this.#entry(found.folder, found.names[i]!, i);
      const part = entry.subarray(0, length - written);
      this.#bytes.set(part, at + written);
      written += part.length;
    }
    this.#view.setUint32(out, written, true);
    return Errno.success;
  }

  #entry(folder: string, name: string, index: number): Uint8Array {
    const text = new TextEncoder().encode(name);
    const entry = new Uint8Array(24 + text.length);
    const view = new DataView(entry.buffer);
    const path = normalized(`${folder}/${name}`);
    view.setBigUint64(0, BigInt(index + 1), true);
    view.setBigUint64(8, this.#inode(path), true);
    view.setUint32(16, text.length, true);
    view.setUint8(20, this.system.files.get(path) ? FileType.regular : FileType.directory);
    entry.set(text, 24);
    return entry;
  }
}

function joined(pieces: readonly Uint8Array[]): Uint8Array {
  const whole = new Uint8Array(pieces.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const piece of pieces) {
    whole.set(piece, at);
    at += piece.length;
  }
  return whole;
}

/** Says whether there is memory for it. */
function grow(file: File, size: number): boolean {
  if (size <= file.data.length) return true;
  try {
    const data = new Uint8Array(Math.max(size, 2 * file.data.length, 4096));
    data.set(file.data.subarray(0, file.size));
    file.data = data;
    return true;
  } catch (error) {
    if (!isOutOfMemory(error)) throw error;
    return false;
  }
}
