// As much of a font file as we look into: its characters and their widths, its names, its measures.

import subsetFont from "subset-font";

export class Font {
  #bytes;
  #tables = new Map();

  // Of a WOFF2 file; of a variable font, as it is at `weight`.
  static async of(woff2, weight) {
    const whole = { keepAllGlyphs: true, targetFormat: "truetype" };
    if (weight) whole.variationAxes = { wght: weight };
    return new Font(await subsetFont(woff2, undefined, whole));
  }

  constructor(bytes) {
    this.#bytes = bytes;
    for (let entry = 12; entry < 12 + 16 * bytes.readUInt16BE(4); entry += 16) {
      const [at, length] = [bytes.readUInt32BE(entry + 8), bytes.readUInt32BE(entry + 12)];
      this.#tables.set(bytes.toString("latin1", entry, entry + 4), bytes.subarray(at, at + length));
    }
  }

  // What a line's height is made of.
  get measures() {
    const [head, hhea, os2] = ["head", "hhea", "OS/2"].map((tag) => this.#tables.get(tag));
    return [
      head.readUInt16BE(18), // units in an em
      ...[4, 6, 8].map((at) => hhea.readInt16BE(at)), // ascent, descent, gap
      ...[68, 70, 72, 74, 76].map((at) => os2.readInt16BE(at)), // the same twice more
    ].join(" ");
  }

  // The names by which the font presents itself: family, style, full name and their kin.
  get names() {
    const table = this.#tables.get("name");
    const names = [];
    for (let at = 6; at < 6 + 12 * table.readUInt16BE(2); at += 12) {
      const [platform, , , id, length, offset] = [0, 2, 4, 6, 8, 10].map((i) =>
        table.readUInt16BE(at + i),
      );
      if ([0, 7, 13].includes(id)) continue; // copyright, trademark, licence
      const start = table.readUInt16BE(4) + offset;
      const text = Buffer.from(table.subarray(start, start + length));
      names.push(platform === 1 ? text.toString("latin1") : text.swap16().toString("utf16le"));
    }
    return names;
  }

  // The code points that have a glyph.
  get characters() {
    return new Set(this.#glyphs.keys());
  }

  // How wide each code point's glyph is, in ems.
  get widths() {
    const [head, hhea, hmtx] = ["head", "hhea", "hmtx"].map((tag) => this.#tables.get(tag));
    const last = hhea.readUInt16BE(34) - 1; // the glyphs after it are as wide as this one
    const em = head.readUInt16BE(18);
    const width = (glyph) => hmtx.readUInt16BE(4 * Math.min(glyph, last)) / em;
    return new Map([...this.#glyphs].map(([code, glyph]) => [code, width(glyph)]));
  }

  // The glyph of each code point that has one.
  get #glyphs() {
    const cmap = this.#tables.get("cmap");
    const glyphs = new Map();
    for (let at = 4; at < 4 + 8 * cmap.readUInt16BE(2); at += 8) {
      const table = cmap.subarray(cmap.readUInt32BE(at + 4));
      const unicode = cmap.readUInt16BE(at) !== 1; // not an old Macintosh's
      const segments = { 4: segmentsOf4, 12: segmentsOf12 }[table.readUInt16BE(0)];
      if (!unicode || !segments) continue;
      for (const [first, last, glyph] of segments(table)) {
        for (let code = first; code <= last; ++code) {
          if (glyph(code) !== 0) glyphs.set(code, glyph(code));
        }
      }
    }
    return glyphs;
  }
}

// Segments of a cmap subtable: first and last code point, and what gives a code point's glyph.
function* segmentsOf4(table) {
  const length = table.readUInt16BE(6); // twice the number of segments
  for (let i = 0; i < length; i += 2) {
    const [last, first, delta] = [14 + i, 16 + length + i, 16 + 2 * length + i].map((at) =>
      table.readUInt16BE(at),
    );
    const indirect = 16 + 3 * length + i;
    const offset = table.readUInt16BE(indirect);
    if (first === 0xffff) continue;
    yield [
      first,
      last,
      (code) => {
        if (offset === 0) return (code + delta) & 0xffff;
        const glyph = table.readUInt16BE(indirect + offset + 2 * (code - first));
        return glyph === 0 ? 0 : (glyph + delta) & 0xffff;
      },
    ];
  }
}

function* segmentsOf12(table) {
  for (let at = 16; at < 16 + 12 * table.readUInt32BE(12); at += 12) {
    const [first, last, glyph] = [at, at + 4, at + 8].map((i) => table.readUInt32BE(i));
    yield [first, last, (code) => glyph + code - first];
  }
}
