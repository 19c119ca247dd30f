// What the preview's server says of a page: generator/preview/preview.cpp writes it.

import { decoded } from "../client/decoded.js";

export interface Place {
  readonly file: string; // below the course; "" where there is none
  readonly line: number; // from 1; 0 means the file as a whole
  readonly column: number;
}

export interface Diagnostic {
  readonly id: string;
  readonly severity: "error" | "warning";
  readonly place: Place;
  readonly message: string;
  readonly text: string; // all of it, as a terminal shows it
  readonly here: boolean; // it is about this page
}

/** Some parts of a lesson's text, one after the other, have others in their place. */
export interface Change {
  readonly first: number; // the first that is gone, from 0
  readonly count: number; // how many are gone
  readonly html: string; // what is there now
}

export interface State {
  readonly version: number;
  readonly running: boolean; // some results are still those of before
  readonly source: string; // the lesson's file; "" of other pages
  readonly diagnostics: readonly Diagnostic[];
  readonly drafts: readonly { readonly href: string; readonly title: string }[];
  // The hashes of pictures that keep their addresses, by their paths below the root.
  readonly pictures: Readonly<Record<string, string>>;
  readonly stylesheet: string; // the newest, below the root
  readonly css: string | null; // its text; null where it is the one that is worn
  readonly hash: string; // of the page
  // Against the known page: null where nothing, or only parts of its text, are others.
  readonly change: Change | null;
  readonly html: string | null; // the whole page; "": there is none
  // Of each part of the lesson's text its first and last line, and whether it is still running.
  readonly marks: readonly (readonly [number, number, boolean])[];
  readonly course: string; // its folder
  readonly link: string; // how an editor is told to open a file
}

/** `known` is the hash of the page, `worn` the stylesheet that is in force. */
export async function askState(known: string, worn: string): Promise<State> {
  const page = decoded(location.pathname)
    .replace(/^\//, "")
    .replace(/(^|\/)$/, "$1index.html");
  const query = new URLSearchParams({ page, known, worn });
  const answer = await fetch(`/.preview/state?${query}`);
  if (!answer.ok) throw new Error(`the preview answers ${answer.status}`);
  return (await answer.json()) as State;
}
