/**
 * A reader's text of a program in a link: the fragment is `#run:` with the program's file, then a version,
 * and the deflated text in base64url. client/programs.ts finds it when the page is opened. What was made
 * up gives nothing worse than no text; nothing runs before the reader says so.
 */
import { fromBase64Url, toBase64Url } from "../lab/run/base64url.js";
import { deflate, inflate } from "../lab/run/deflate.js";

const version = "1";

/** Characters: mail and chats break or refuse longer addresses. */
const mostCharacters = 7500;

/** Bytes of a program. */
const mostText = 1 << 18;

/** Undefined for one that is too long. */
export async function encodeText(text: string): Promise<string | undefined> {
  const value = version + toBase64Url(await deflate(new TextEncoder().encode(text)));
  return value.length <= mostCharacters ? value : undefined;
}

/** Undefined for what is no such value; it never throws. */
export async function decodeText(value: string): Promise<string | undefined> {
  if (!value.startsWith(version) || value.length > mostCharacters) return undefined;
  try {
    const bytes = await inflate(fromBase64Url(value.slice(version.length)), mostText);
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch {
    return undefined;
  }
}
