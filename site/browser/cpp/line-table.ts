/**
 * From which line of a source the code at an offset of a module comes: the line numbers that clang
 * writes and the linker keeps (DWARF 4, section 6.2; offsets are of the code section's content, as in
 * WebAssembly's "DWARF for WebAssembly"). Enter with LineTable.of().
 */

interface Row {
  readonly address: number;
  /** Nothing where the code is none of the file's, or ends. */
  readonly line: number | undefined;
}

export class LineTable {
  private constructor(
    private readonly codeBegin: number,
    private readonly rows: readonly Row[],
  ) {}

  /** Of the lines of `file`, which is named by its path's end. Nothing where the module has none. */
  static of(module: Uint8Array, file: string): LineTable | undefined {
    const code = section(module, (id) => id === codeSection);
    const lines = section(module, (_id, name) => name === ".debug_line");
    if (!code || !lines) return undefined;
    const rows: Row[] = [];
    const reader = new Reader(module, lines.begin);
    while (reader.at < lines.end) rows.push(...unitRows(reader, file, code.end - code.begin));
    rows.sort((a, b) => a.address - b.address);
    return new LineTable(code.begin, rows);
  }

  /** `offset` is in the module, of an instruction. */
  lineAt(offset: number): number | undefined {
    const address = offset - this.codeBegin;
    const row = this.rows.findLast((one) => one.address <= address);
    return row?.line;
  }
}

const codeSection = 10;

interface Section {
  readonly begin: number;
  readonly end: number;
}

/** Where the content lies of the first that is wanted; a custom section has a name before it. */
function section(
  module: Uint8Array,
  isWanted: (id: number, name: string) => boolean,
): Section | undefined {
  const reader = new Reader(module, 8);
  while (reader.at < module.length) {
    const id = reader.u8();
    const size = reader.leb();
    const end = reader.at + size;
    const name = id === 0 ? reader.text(reader.leb()) : "";
    if (isWanted(id, name)) return { begin: reader.at, end };
    reader.at = end;
  }
  return undefined;
}

/** What the head of a unit says of its program. */
interface Head {
  readonly file: number;
  readonly step: number;
  readonly lineBase: number;
  readonly lineRange: number;
  readonly operands: readonly number[];
}

/** Of one unit: it is read to its end, whatever it has. */
function unitRows(reader: Reader, file: string, codeSize: number): Row[] {
  const end = reader.u32() + reader.at;
  const rows: Row[] = [];
  if (reader.u16() === 4) {
    const head = readHead(reader, file);
    while (reader.at < end) rows.push(...sequence(reader, end, head, codeSize));
  }
  reader.at = end;
  return rows;
}

function readHead(reader: Reader, file: string): Head {
  const begin = reader.u32() + reader.at;
  const step = reader.u8();
  reader.at += 2; // operations of an instruction, and whether each begins a statement
  const lineBase = (reader.u8() << 24) >> 24;
  const lineRange = reader.u8();
  const operands = Array.from({ length: reader.u8() - 1 }, () => reader.u8());
  while (reader.cString() !== ""); // folders
  const files: string[] = [];
  for (let name = reader.cString(); name !== ""; name = reader.cString()) {
    files.push(name);
    for (let i = 0; i < 3; ++i) reader.leb(); // folder, time, size
  }
  reader.at = begin;
  const number = files.findIndex((name) => `/${name}`.endsWith(`/${file}`)) + 1;
  return { file: number, step, lineBase, lineRange, operands };
}

/** The rows of one function: none where the linker has left it out, which then begins at no code. */
function sequence(reader: Reader, end: number, head: Head, codeSize: number): Row[] {
  const rows: Row[] = [];
  const first = head.operands.length + 1;
  let [address, line, file] = [0, 1, 1];
  // Line 0 is code that the compiler has added, which counts as the line before.
  const add = (of: number) => {
    if (line > 0) rows.push({ address, line: of === head.file ? line : undefined });
  };
  const advance = (count: number) => (address += count * head.step);
  const isKept = () => {
    const begin = rows[0]?.address ?? 0;
    return begin > 0 && begin < codeSize;
  };

  while (reader.at < end) {
    const opcode = reader.u8();
    if (opcode >= first) {
      const adjusted = opcode - first;
      advance(Math.floor(adjusted / head.lineRange));
      line += head.lineBase + (adjusted % head.lineRange);
      add(file);
      continue;
    }
    switch (opcode) {
      case 0: {
        const next = reader.leb() + reader.at;
        const extended = reader.u8();
        if (extended === 2) address = reader.u32();
        reader.at = next;
        if (extended !== 1) break;
        rows.push({ address, line: undefined });
        return isKept() ? rows : [];
      }
      case 1:
        add(file);
        break;
      case 2:
        advance(reader.leb());
        break;
      case 3:
        line += reader.signedLeb();
        break;
      case 4:
        file = reader.leb();
        break;
      case 8:
        advance(Math.floor((255 - first) / head.lineRange));
        break;
      case 9:
        address += reader.u16();
        break;
      default: // of columns and of statements
        for (let i = 0; i < head.operands[opcode - 1]!; ++i) reader.leb();
    }
  }
  return [];
}

/** Numbers and texts of a module, one behind the other. */
class Reader {
  readonly #view: DataView;

  constructor(
    private readonly bytes: Uint8Array,
    public at: number,
  ) {
    this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  u8(): number {
    return this.#view.getUint8(this.at++);
  }

  u16(): number {
    this.at += 2;
    return this.#view.getUint16(this.at - 2, true);
  }

  u32(): number {
    this.at += 4;
    return this.#view.getUint32(this.at - 4, true);
  }

  leb(): number {
    return this.#leb()[0];
  }

  signedLeb(): number {
    const [value, bits, last] = this.#leb();
    return (last & 0x40) === 0 ? value : value - 2 ** bits;
  }

  text(length: number): string {
    this.at += length;
    return new TextDecoder().decode(this.bytes.subarray(this.at - length, this.at));
  }

  cString(): string {
    const text = this.text(this.bytes.indexOf(0, this.at) - this.at);
    ++this.at;
    return text;
  }

  /** The value without a sign, how many bits it has, and its last byte. */
  #leb(): [number, number, number] {
    for (let value = 0, bits = 0; ;) {
      const byte = this.u8();
      value += (byte & 127) * 2 ** bits;
      bits += 7;
      if (byte < 128) return [value, bits, byte];
    }
  }
}
