// Numbers as people type them.

/**
 * "30", "3e1", "0,5", "−2.5" (a Unicode minus), "1 000"; undefined for what is no finite number.
 * A comma is a decimal point: thousands are set apart by spaces or not at all.
 */
export function parseNumber(text: string): number | undefined {
  const plain = text.replace(/\s/g, "").replace(/[−–]/g, "-").replace(",", ".");
  if (!/^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(plain)) return undefined;
  const value = Number(plain);
  return Number.isFinite(value) ? value : undefined;
}
