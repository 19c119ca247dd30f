// The compiler takes its memory in larger steps. Enter with withLargerSteps().
//
// As it comes, it grows its memory by 64 KiB some thousand times a program. V8 counts the whole memory
// anew at each growth, and collects garbage at every fifth: nearly a third of a compilation. The step is a
// constant of its allocator, dlmalloc in wasi-libc, which nothing from outside can set. So it is
// changed in the bytes, where dlmalloc begins to work and stores its parameters side by side: its page
// size and its step, of 4 bytes each, as one number, and before that no limit to two others.

const pageSize = 64 << 10;
// The largest power of two that needs no more bytes than the constant in its place.
const step = 4 << 20;

// `program` as bytes of WebAssembly. Throws where it has an unknown allocator.
export function withLargerSteps(program) {
  const larger = Buffer.from(program);
  const wanted = stores(pageSize);
  let count = 0;
  for (let at = larger.indexOf(wanted); at >= 0; at = larger.indexOf(wanted, at + 1)) {
    if (!isBehindLimits(larger, at)) continue;
    stores(step).copy(larger, at);
    ++count;
  }
  // malloc() and the like call it, inlined.
  if (count > 0) return larger;
  throw new Error(
    "the compiler for the page (@yowasp/clang) has another allocator than " +
      "site/bundle/allocation-step.mjs knows; look there whether it still takes memory in small steps",
  );
}

// i64.const, and i64.store with its alignment.
function stores(size) {
  return Buffer.from([0x42, ...signedLeb((BigInt(size) << 32n) | BigInt(pageSize)), 0x37, 0x02]);
}

// Before it: i64.const -1, i64.store, an address of 5 bytes, i32.const 0.
function isBehindLimits(program, at) {
  const begin = program.subarray(at - 11, at - 7);
  return begin.equals(limits) && program.subarray(at - 2, at).equals(zero);
}
const limits = Buffer.from([0x42, 0x7f, 0x37, 0x02]);
const zero = Buffer.from([0x41, 0x00]);

// A positive number in signed LEB128.
function signedLeb(number) {
  const bytes = [];
  for (; number >= 64n; number >>= 7n) bytes.push(Number(number & 127n) | 128);
  return [...bytes, Number(number)];
}
