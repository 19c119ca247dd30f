/** Numbers as C prints them. */

/**
 * `value` as printf's "%.*f": a tie goes to the even digit, which toFixed() does not know, and a
 * large value has all its digits. Zero has no sign, whatever it was rounded from.
 */
export function fixed(value: number, digits: number): string {
  const { mantissa, exponent } = parts(Math.abs(value));
  const scaled = roundHalfEven(mantissa * 10n ** BigInt(digits), exponent);
  const text = scaled.toString().padStart(digits + 1, "0");
  const sign = value < 0 && scaled > 0n ? "-" : "";
  const point = text.length - digits;
  return sign + (digits === 0 ? text : `${text.slice(0, point)}.${text.slice(point)}`);
}

/** value = mantissa · 2^exponent, exactly. */
function parts(value: number): { mantissa: bigint; exponent: number } {
  const bits = new BigUint64Array(Float64Array.of(value).buffer)[0]!;
  const fraction = bits & 0xfffffffffffffn;
  const biased = Number(bits >> 52n);
  return biased === 0
    ? { mantissa: fraction, exponent: -1074 }
    : { mantissa: fraction | 0x10000000000000n, exponent: biased - 1075 };
}

function roundHalfEven(mantissa: bigint, exponent: number): bigint {
  if (exponent >= 0) return mantissa << BigInt(exponent);
  const shift = BigInt(-exponent);
  const floor = mantissa >> shift;
  const twice = (mantissa - (floor << shift)) * 2n;
  const one = 1n << shift;
  const up = twice > one || (twice === one && (floor & 1n) === 1n);
  return up ? floor + 1n : floor;
}
