// What is loaded when a reader first searches, or asks for the keys: entered by opener.ts, which
// knows it by the object that it leaves.

import { KeysDialog } from "./keys-dialog.js";
import { mendMissingPage } from "./missing.js";
import { add, addressOf } from "./scripts.js";
import { SearchDialog } from "./search-dialog.js";
import { SearchPage } from "./search-page.js";

let keys: KeysDialog | undefined;
let search: SearchDialog | SearchPage | undefined;

// Without it they are plain, and work all the same.
const link = document.createElement("link");
link.rel = "stylesheet";
link.href = addressOf(window.mjcourse!.styles);
const styled = add(link).catch(() => undefined);

function openKeys(): void {
  (keys ??= new KeysDialog()).open();
}

function openSearch(words?: string, typed = ""): void {
  (search ??= new SearchDialog(openKeys)).open(words, typed);
}

window.mjcourse!.dialogs = { styled, openSearch, openKeys };
const place = document.querySelector("article.search-place");
if (place) void styled.then(() => (search = new SearchPage(place)));
const missing = document.querySelector("article.missing");
if (missing) mendMissingPage(missing, openSearch);
