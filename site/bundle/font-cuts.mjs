// Into what pieces the fonts are cut, and why there.
//
// A browser loads a piece when a page has a character in its range. So the first piece of a font
// holds what nearly every page has, the next ones what some have, and a last one, which is not named
// here, all the rest: together they cover what the whole font covers, and nothing is lost. A
// combining mark stands in the same piece as the letters it goes on, or it would not find its place.

import { rangesOf } from "./unicode-range.mjs";

const span = (first, last) => {
  const [a, b] = [first, last].map((c) => c.codePointAt(0));
  return Array.from({ length: b - a + 1 }, (_, i) => String.fromCodePoint(a + i)).join("");
};
const ascii = span(" ", "~");
const letters = span("a", "z") + span("A", "Z");
const greek = span("α", "ω") + "ϑϕϖϱϵ";

// Line ends, tabs and the like, which have no glyph but are looked up in a font all the same.
const invisible = span("\0", "\u001f") + "\u00ad" + span("\u200b", "\u200f") + "\u2060\ufeff";

// English prose about physics, and code.
const prose = rangesOf(
  invisible + ascii + "\u00a0\u2009\u202f" + "’‘“”–—…·•×−±°²³µ½§©→←↑↓≈≤≥" + "\u0304\u0308\u0329",
);

// Names of Western Europe.
const western = rangesOf(span("ß", "ö") + span("ø", "ÿ") + "ÄÅÉÖØÜŁłŠšŽž√");

// Digits, names of functions, accents, and the signs that a page of mechanics has; U+E020 is the
// stroke that KaTeX sets ≠ with.
const formula = rangesOf(
  invisible +
    span("0", "9") +
    span("a", "z") +
    "()[]{}|/,.;:!?'=+<>^~ \u00a0−×⋅±≤≥\ue020≈∝∞∂∇∈→←⇒…⋯′∥∣⟨⟩⊕⊖⊗⊤Δ∘√∗ℓ˙¨ˉˆ˜⃗",
);
const large = rangesOf("()[]∑∫");

export const pieces = {
  "source-serif-4-latin-wght-normal": [prose, western],
  "source-serif-4-latin-wght-italic": [prose, western],
  "source-sans-3-latin-wght-normal": [prose, western],
  "source-sans-3-latin-wght-italic": [prose, western],
  "source-code-pro-latin-wght-normal": [prose],
  "KaTeX_Main-Regular": [formula],
  "KaTeX_Main-Bold": [rangesOf(letters + "1Λ")],
  "KaTeX_Math-Italic": [rangesOf(letters), rangesOf(greek)],
  "KaTeX_Math-BoldItalic": [rangesOf(letters), rangesOf(greek)],
  "KaTeX_Size1-Regular": [large],
  "KaTeX_Size2-Regular": [large],
};

// The weights in which the stylesheet sets text. A bold italic is rare, so a page without one loads
// the regular italic alone, which is half as large as all weights together.
export const weights = { normal: ["400 650"], italic: ["400", "500 650"] };

// What browsers turn on by themselves, and the two that the stylesheet asks for.
export const features = [
  ...["ccmp", "locl", "mark", "mkmk", "rlig", "calt", "clig", "kern", "liga", "rclt", "rvrn"],
  ...["tnum", "lnum"],
];
