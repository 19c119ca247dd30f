// A font's own name, as an operating system would show it, replaced by another of the same length,
// which leaves everything else where it is. See fonts.mjs for why.

const names = { Source: "Course", KaTeX: "Maths" };
const copyright = new Set([0, 7, 13]); // name IDs: copyright, trademark and licence stay

// `font` is a TrueType file; gives a copy. A table is found in the directory of tables that follows
// the 12 bytes of the header; "name" is a list of records and the text to which they point.
export function rename(font) {
  const renamed = Buffer.from(font);
  const table = tableAt(renamed, "name");
  const count = renamed.readUInt16BE(table + 2);
  const texts = table + renamed.readUInt16BE(table + 4);
  for (let record = table + 6; record < table + 6 + 12 * count; record += 12) {
    if (copyright.has(renamed.readUInt16BE(record + 6))) continue;
    const start = texts + renamed.readUInt16BE(record + 10);
    const text = renamed.subarray(start, start + renamed.readUInt16BE(record + 8));
    for (const [name, other] of Object.entries(names)) {
      replace(text, Buffer.from(name), Buffer.from(other)); // an old Macintosh's text
      replace(text, wide(name), wide(other));
    }
  }
  return renamed;
}

function tableAt(font, tag) {
  const count = font.readUInt16BE(4);
  for (let entry = 12; entry < 12 + 16 * count; entry += 16) {
    if (font.toString("latin1", entry, entry + 4) === tag) return font.readUInt32BE(entry + 8);
  }
  throw new Error(`the font has no table "${tag}"`);
}

const wide = (text) => Buffer.from(text, "utf16le").swap16();

function replace(text, name, other) {
  for (let at = text.indexOf(name); at >= 0; at = text.indexOf(name, at + 1)) other.copy(text, at);
}
