/** Files as a zip archive, deflated. The date of each is zip's first day, as the generator has it. */
import { deflate } from "../lab/run/deflate.js";
import { crc32 } from "./crc32.js";
import type { Files } from "./unzip.js";

const version = 20; // deflated files
const utf8Names = 1 << 11;
const deflated = 8;
const firstDay = (1 << 5) | 1; // January 1, 1980
const plainFile = 0o100644 << 16; // as Unix has it
const unix = 3 << 8;

export async function zip(files: Files): Promise<Blob> {
  const parts: Uint8Array<ArrayBuffer>[] = [];
  const directory: Uint8Array<ArrayBuffer>[] = [];
  let at = 0;
  for (const [path, content] of files) {
    const name = new TextEncoder().encode(path);
    const packed = await deflate(content);
    const shared = fields(
      [version, utf8Names, deflated, 0, firstDay],
      [crc32(content), packed.length, content.length],
      [name.length, 0],
    );
    const head = [signature(0x04034b50), shared, name, packed];
    directory.push(
      signature(0x02014b50),
      fields([unix | version], [], []),
      shared,
      fields([0, 0, 0], [plainFile, at], []),
      name,
    );
    parts.push(...head);
    at += lengthOf(head);
  }
  const end = fields([0, 0, files.size, files.size], [lengthOf(directory), at], [0]);
  return new Blob([...parts, ...directory, signature(0x06054b50), end], {
    type: "application/zip",
  });
}

/** Numbers of two bytes, then of four, then of two. */
function fields(
  first: readonly number[],
  second: readonly number[],
  third: readonly number[],
): Uint8Array<ArrayBuffer> {
  const bytes = new DataView(
    new ArrayBuffer(2 * (first.length + third.length) + 4 * second.length),
  );
  let at = 0;
  const short = (value: number): void => {
    bytes.setUint16(at, value, true);
    at += 2;
  };
  const long = (value: number): void => {
    bytes.setUint32(at, value, true);
    at += 4;
  };
  first.forEach(short);
  second.forEach(long);
  third.forEach(short);
  return new Uint8Array(bytes.buffer);
}

function signature(value: number): Uint8Array<ArrayBuffer> {
  return fields([], [value], []);
}

function lengthOf(parts: readonly Uint8Array[]): number {
  return parts.reduce((sum, { length }) => sum + length, 0);
}
