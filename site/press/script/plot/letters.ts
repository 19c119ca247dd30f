/** How wide a text is in the site's sans, so that a plot is laid out as it will be set. */
import widths from "computed:letter-widths";

/** Of a letter that is not in the table, in thousandths of an em. */
const unknown = 600;

/** `text` at `size` pixels. */
export function widthOf(text: string, size: number, bold: boolean): number {
  const table = bold ? widths.bold : widths.regular;
  const letters = Array.from(text, (letter) => table[letter] ?? unknown);
  return (letters.reduce((sum, width) => sum + width, 0) * size) / 1000;
}
