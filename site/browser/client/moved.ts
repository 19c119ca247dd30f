// The script of a page at a former address: it leads on to where the lesson is now, at once, and to
// the heading that was linked to. The former address is not left in the browser's history, so the
// way back leads to where the reader came from.

const to = document.currentScript?.dataset["to"];
if (to !== undefined) location.replace(new URL(location.hash, new URL(to, document.baseURI)));
