// The compiler imports its memory, so that one can be kept between its runs. Enter with
// withImportedMemory().
//
// As it comes, each run has a memory of its own, and most of a small program's time goes into pages that
// nobody touched before (browser/cpp/tool.ts). So the module's own memory becomes an import, env.memory. Its
// allocator, dlmalloc in wasi-libc, takes for free what lies between two constants, __heap_base and
// __heap_end, the size of the memory that the module comes with. A kept memory may be larger: the second
// constant becomes a variable, which is exported as heap_end and is to be set before a run.

const importSection = 2;
const memorySection = 5;
const globalSection = 6;
const exportSection = 7;
const codeSection = 10;

const pageSize = 64 << 10;
// Where dlmalloc begins to work and where it compares.
const uses = 4;

// `program` as bytes of WebAssembly. Throws where it has an unknown allocator or memory.
export function withImportedMemory(program) {
  const sections = sectionsOf(program);
  const body = (id) => sections.find((section) => section.id === id)?.body ?? unknown();
  const pages = pagesOf(body(memorySection));
  const count = unsigned(body(globalSection)).value;
  const changed = new Map([
    [importSection, appended(body(importSection), memoryImport(pages))],
    [memorySection, undefined],
    [globalSection, appended(body(globalSection), variable(pages * pageSize))],
    [exportSection, appended(body(exportSection), heapEndExport(count))],
    [codeSection, withVariable(body(codeSection), pages * pageSize, count)],
  ]);
  const kept = sections.map(({ id, body }) => ({
    id,
    body: changed.has(id) ? changed.get(id) : body,
  }));
  const written = kept
    .filter(({ body }) => body)
    .flatMap(({ id, body }) => [Buffer.from([id, ...leb(body.length)]), body]);
  return Buffer.concat([program.subarray(0, 8), ...written]);
}

function sectionsOf(program) {
  const sections = [];
  for (let at = 8; at < program.length;) {
    const size = unsigned(program, at + 1);
    const end = size.end + size.value;
    sections.push({ id: program[at], body: program.subarray(size.end, end) });
    at = end;
  }
  return sections;
}

// With which its one memory begins.
function pagesOf(section) {
  if (section[0] !== 1) unknown();
  return unsigned(section, 2).value;
}

function appended(section, entry) {
  const count = unsigned(section);
  return Buffer.concat([Buffer.from(leb(count.value + 1)), section.subarray(count.end), entry]);
}

const text = (word) => [word.length, ...Buffer.from(word)];

// Of any maximum.
const memoryImport = (pages) =>
  Buffer.from([...text("env"), ...text("memory"), 0x02, 0x00, ...leb(pages)]);

// A mutable i32.
const variable = (value) => Buffer.from([0x7f, 0x01, 0x41, ...paddedLeb(value), 0x0b]);

const heapEndExport = (index) => Buffer.from([...text("heap_end"), 0x03, ...leb(index)]);

// Each i32.const becomes a global.get of as many bytes: the linker pads what it fills in.
function withVariable(code, value, index) {
  const changed = Buffer.from(code);
  const constant = Buffer.from([0x41, ...paddedLeb(value)]);
  const get = Buffer.from([0x23, ...paddedLeb(index)]);
  let found = 0;
  for (let at = changed.indexOf(constant); at >= 0; at = changed.indexOf(constant, at + 1)) {
    get.copy(changed, at);
    ++found;
  }
  if (found !== uses) unknown();
  return changed;
}

function unknown() {
  throw new Error(
    "the compiler for the page (@yowasp/clang) takes its memory otherwise than " +
      "site/bundle/imported-memory.mjs knows; look there how its allocator finds the end of it",
  );
}

// The unsigned LEB128 that begins at `at`.
function unsigned(bytes, at = 0) {
  let value = 0;
  for (let shift = 0; ; shift += 7) {
    const byte = bytes[at++];
    value += (byte & 127) * 2 ** shift;
    if (byte < 128) return { value, end: at };
  }
}

function leb(number) {
  const bytes = [];
  for (; number >= 128; number >>>= 7) bytes.push((number & 127) | 128);
  return [...bytes, number];
}

// In five bytes; as a signed number, too, if it is below 2^31.
function paddedLeb(number) {
  return [0, 7, 14, 21].map((shift) => ((number >>> shift) & 127) | 128).concat(number >>> 28);
}
