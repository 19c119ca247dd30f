/** Numbers as generator/evaluate/answers/inline_value.h prints them into the text. */
import { fixed } from "../lab/run/fixed.js";

/** Digits of %g and of %e where none are said. */
const usualDigits = 6;

/** More than a double can have alike with a tie. */
const guardDigits = 30;

/**
 * `format` is as a lesson writes it behind the colon: "d", ".4f", "e", ".3g"; "" prints whole numbers
 * plainly and others with six digits. Zero has no sign, whatever it was rounded from.
 */
export function inText(value: number, format: string): string {
  const kind = format.at(-1) ?? "";
  const asked = /\.(\d+)/.exec(format)?.[1];
  const digits = asked === undefined ? usualDigits : Number(asked);
  if (kind === "d" || (kind === "" && Number.isInteger(value))) return fixed(value, 0);
  if (kind === "f") return fixed(value, digits);
  const text = kind === "e" ? exponential(value, digits) : general(value, digits);
  return /[1-9]/.test(text.split("e")[0]!) ? text : text.replace(/^-/, "");
}

/** C writes two digits of the exponent at least. A tie goes to the even digit, which toExponential()
 * does not know: what is cut off of a tie is a five. */
function exponential(value: number, digits: number): string {
  const [exact, exponent] = value.toExponential(digits + guardDigits).split("e") as [
    string,
    string,
  ];
  const kept = exact.slice(0, -guardDigits).replace(/\.$/, "");
  const isTie = /^50*$/.test(exact.slice(-guardDigits));
  const text = isTie && /[02468]$/.test(kept) ? `${kept}e${exponent}` : value.toExponential(digits);
  return text.replace(/e([+-])(\d)$/, "e$10$2");
}

/** As %g: the shorter way, and no zeros at the end. */
function general(value: number, digits: number): string {
  const precision = Math.max(digits, 1);
  const text = exponential(value, precision - 1);
  const exponent = Number(text.split("e")[1]);
  if (exponent < -4 || exponent >= precision) return text.replace(/\.?0*e/, "e");
  const plain = fixed(value, precision - 1 - exponent);
  return plain.includes(".") ? plain.replace(/\.?0+$/, "") : plain;
}
