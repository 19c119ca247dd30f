/**
 * Debian's clang as a quick stand-in for the page's own: the same compiler as machine code, which gives
 * the same objects many times as fast. Enter with nativeClang().
 *
 * It gets the very arguments of the page's compiler, and sees the same files under the same paths: a
 * virtual file system shows it the pack's headers, which lie in FOLDER/root/, and the program's own, and
 * nothing else. It must not be trusted blindly, as it may be of another version: FOLDER has a program with the
 * object that the page's compiler makes of it, which is compared at each start, and more are compared
 * where they are compiled (compared-clang.ts). Where clang says anything, its words do not count, and the
 * page's own compiler is asked.
 *
 * FOLDER (made by make-native.ts) holds root/, probe.cpp and probe.o.
 */
import { spawnSync } from "node:child_process";
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";

import { compileArguments, programFolder } from "../browser/cpp/flags.js";

/** Of the same release as the page's (@yowasp/clang in package.json). */
export const nativeCompiler = "/usr/lib/llvm-22/bin/clang";

/** What lies in root/. */
const shownFolders = ["/usr/include", "/include", "/prepared", "/runtime"];

/** An object may be 32 MiB, in blocks of 512 bytes: what the build's sandbox has as its limit (process/sandbox.h).
 * Of a program with an array of gigabytes, the page's compiler has no memory for a larger one. */
const mostBlocks = 65536;
const bounded = 'ulimit -f $0 && exec "$@"';
/** Of a compiler that loops: the page's own then ends for want of stack or memory. */
const mostMilliseconds = 60_000;

/** Large pages, and memory that is asked for seldom: a tenth of the time. */
const malloc = "glibc.malloc.hugetlb=1:glibc.malloc.top_pad=67108864";

export class NativeClang {
  /** `root` has the pack's headers; `work` is a folder for this alone. */
  constructor(
    private readonly root: string,
    private readonly work: string,
  ) {}

  /** What clang makes with the command line `args`, over `sources` by their paths; nothing where it says anything. */
  make(
    args: readonly string[],
    sources: ReadonlyMap<string, Uint8Array>,
    most = mostBlocks,
  ): Uint8Array | undefined {
    mkdirSync(this.work, { recursive: true });
    try {
      const out = path.join(this.work, "out");
      const own = path.join(this.work, "own");
      for (const [name, content] of sources) {
        mkdirSync(path.dirname(path.join(own, name)), { recursive: true });
        writeFileSync(path.join(own, name), content);
      }
      const overlay = path.join(this.work, "overlay.json");
      writeFileSync(overlay, this.#overlay(own, [...sources.keys()]));
      const words = args.slice(2); // behind clang++ -cc1
      words[words.indexOf("-o") + 1] = out;
      const { status, stdout, stderr } = spawnSync(
        "/bin/sh",
        ["-c", bounded, `${most}`, nativeCompiler, "-cc1", "-ivfsoverlay", overlay, ...words],
        { env: { GLIBC_TUNABLES: tunables() }, timeout: mostMilliseconds, killSignal: "SIGKILL" },
      );
      const isSilent = status === 0 && stdout.length + stderr.length === 0;
      return isSilent ? readFileSync(out) : undefined;
    } finally {
      rmSync(this.work, { recursive: true });
    }
  }

  #overlay(own: string, names: readonly string[]): string {
    const folder = (name: string, place: string) => ({
      type: "directory-remap",
      name,
      "external-contents": place,
    });
    const owned = new Set(names.map((name) => name.slice(0, name.indexOf("/", 1))));
    return JSON.stringify({
      version: 0,
      "use-external-names": "false",
      "redirecting-with": "redirect-only",
      roots: [
        ...shownFolders.map((name) => folder(name, path.join(this.root, name))),
        ...[...owned].map((name) => folder(name, path.join(own, name))),
      ],
    });
  }
}

/** Nothing where there is none in `folder`, or it makes another object of the probe. */
export function nativeClang(folder: string, work: string): NativeClang | undefined {
  try {
    const clang = new NativeClang(path.join(folder, "root"), work);
    const expected = readFileSync(path.join(folder, "probe.o"));
    const made = clang.make(
      probeArguments,
      probeSource(readFileSync(path.join(folder, "probe.cpp"))),
    );
    return made && isSameObject(made, expected) ? clang : undefined;
  } catch {
    return undefined;
  }
}

export const probePath = `${programFolder}/probe.cpp`;
export const probeArguments = compileArguments(probePath, "/object/probe.o", {
  include: `${programFolder}/include`,
  prepared: true,
  withLines: false,
});
export const probeSource = (text: Uint8Array) => new Map([[probePath, text]]);

/** But for the name of the compiler. */
export function isSameObject(one: Uint8Array, other: Uint8Array): boolean {
  return Buffer.compare(withoutProducers(one), withoutProducers(other)) === 0;
}

/** `object` without the section that says which compiler made it. The linker puts those of all objects
 * together, so a program that is linked of the rest has the page's compiler there. */
export function withoutProducers(object: Uint8Array): Uint8Array {
  const customSection = 0;
  const parts = [object.subarray(0, 8)];
  for (let at = 8; at < object.length;) {
    const size = leb(object, at + 1);
    const end = size.next + size.value;
    const name = leb(object, size.next);
    const isProducers =
      object[at] === customSection &&
      new TextDecoder().decode(object.subarray(name.next, name.next + name.value)) === "producers";
    if (!isProducers) parts.push(object.subarray(at, end));
    at = end;
  }
  return Buffer.concat(parts);
}

/** An unsigned number in LEB128, and where the next byte is. */
function leb(bytes: Uint8Array, at: number): { readonly value: number; readonly next: number } {
  let value = 0;
  for (let shift = 0, next = at; ; shift += 7) {
    const byte = bytes[next++]!;
    value += (byte & 127) * 2 ** shift;
    if (byte < 128) return { value, next };
  }
}

function tunables(): string {
  const own = process.env["GLIBC_TUNABLES"];
  return own ? `${own}:${malloc}` : malloc;
}
