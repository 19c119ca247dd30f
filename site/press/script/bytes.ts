/** Bytes of `text` in UTF-8. */
export function bytes(text: string): number {
  return encodeURIComponent(text).replace(/%../g, "%").length;
}
