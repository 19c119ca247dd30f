/** A zip archive as the files in it: those that generator/page/zip.h writes, stored or deflated. */
import { inflate } from "../lab/run/deflate.js";

const endSignature = 0x06054b50;
const entrySignature = 0x02014b50;
const endBytes = 22;
const stored = 0;
const deflated = 8;

/** Bytes that a file of ours may have: models with meshes have some million. */
const most = 1 << 28;

export type Files = ReadonlyMap<string, Uint8Array<ArrayBuffer>>;

/** By their paths. Throws for what is no such archive. */
export async function unzip(archive: ArrayBuffer): Promise<Files> {
  const view = new DataView(archive);
  const files = new Map<string, Uint8Array<ArrayBuffer>>();
  const end = endOf(view);
  let at = view.getUint32(end + 16, true);
  for (let left = view.getUint16(end + 10, true); left > 0; --left) {
    if (view.getUint32(at, true) !== entrySignature) throw new RangeError("not a zip's entry");
    const [nameBytes, extra, comment] = [28, 30, 32].map((place) =>
      view.getUint16(at + place, true),
    ) as [number, number, number];
    const name = new TextDecoder().decode(new Uint8Array(archive, at + 46, nameBytes));
    files.set(name, await contentOf(view, at));
    at += 46 + nameBytes + extra + comment;
  }
  return files;
}

/** A comment may follow it. */
function endOf(view: DataView): number {
  for (let at = view.byteLength - endBytes; at >= 0; --at) {
    if (view.getUint32(at, true) === endSignature) return at;
  }
  throw new RangeError("not a zip archive");
}

/** Of the entry at `at` of the directory. */
async function contentOf(view: DataView, at: number): Promise<Uint8Array<ArrayBuffer>> {
  const method = view.getUint16(at + 10, true);
  const bytes = view.getUint32(at + 20, true);
  const own = view.getUint32(at + 42, true);
  const begin = own + 30 + view.getUint16(own + 26, true) + view.getUint16(own + 28, true);
  const content = new Uint8Array(view.buffer.slice(begin, begin + bytes) as ArrayBuffer);
  if (method === stored) return content;
  if (method !== deflated) throw new RangeError(`a zip's method ${method}`);
  return inflate(content, most);
}
