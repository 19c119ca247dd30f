// Sets of characters, as CSS's unicode-range writes them: lists of [first, last] in rising order.

export const everything = [[0, 0x10ffff]];

// "U+0-FF, U+131"; CSS's wildcards are not used by those who write ours.
export function parseRanges(text) {
  const ranges = text.split(",").map((part) => {
    const [first, last = first] = part.trim().slice(2).split("-");
    return [parseInt(first, 16), parseInt(last, 16)];
  });
  return ranges.sort(([a], [b]) => a - b);
}

export function formatRanges(ranges) {
  const hex = (code) => code.toString(16).toUpperCase();
  return ranges.map(([a, b]) => (a === b ? `U+${hex(a)}` : `U+${hex(a)}-${hex(b)}`)).join(",");
}

// The set of these characters.
export function rangesOf(characters) {
  const codes = [...new Set(characters)].map((c) => c.codePointAt(0)).sort((a, b) => a - b);
  const ranges = [];
  for (const code of codes) {
    if (ranges.length > 0 && ranges.at(-1)[1] === code - 1) ranges.at(-1)[1] = code;
    else ranges.push([code, code]);
  }
  return ranges;
}

export function without(ranges, taken) {
  let left = ranges;
  for (const [first, last] of taken) {
    left = left.flatMap(([a, b]) => {
      if (last < a || first > b) return [[a, b]];
      const below = first > a ? [[a, first - 1]] : [];
      const above = last < b ? [[last + 1, b]] : [];
      return [...below, ...above];
    });
  }
  return left;
}

export function common(ranges, others) {
  return without(ranges, without(everything, others));
}

// Each character of the set, up to the end of the plane of mathematical alphabets: no font of ours
// has any beyond it.
export function charactersOf(ranges) {
  const characters = [];
  for (const [first, last] of common(ranges, [[0, 0x1ffff]])) {
    for (let code = first; code <= last; ++code) {
      if (code < 0xd800 || code > 0xdfff) characters.push(String.fromCodePoint(code));
    }
  }
  return characters.join("");
}
