/**
 * The JSON of what was verified. The generator writes it (generator/page/html/verification.cpp), tools
 * read it, and tests/site/verification.mjs holds what it wrote against these types.
 *
 * `Verification` is `verification.json` of a site: the same bytes for the same course. `Report` is
 * that of `--report DIR`: drafts, measured times and diagnostics come with it, and it is written of a
 * run that failed as well. Text may be empty where that is said; nothing is ever left out.
 */

export interface Verification {
  /** Counts up when readers of the former must change. */
  format: 1;
  /** The course's title; empty where there was no readable one. */
  course: string;
  versions: Versions;
  /** Of all lessons. */
  counts: Counts;
  /** In the course's order. */
  lessons: Lesson[];
}

export interface Report extends Verification {
  lessons: (Lesson & { draft: boolean; claims: (Claim & Times)[] })[];
  /** Whether the course had no errors. */
  succeeded: boolean;
  /** Measured, of everything. */
  seconds: number;
  /** What held the course's programs, of what the machine has; empty where none was to be run. */
  sandbox: string;
  /** Sorted by file, line and column. */
  diagnostics: Diagnostic[];
}

/** What everything was found out with. */
export interface Versions {
  mjcourse: string;
  mujoco: string;
  /** "clang 16.0.6"; empty where no program was to be compiled. */
  compiler: string;
  /** Empty where there was no readable course. */
  katex: string;
  /** Content hash of MuJoCo for the page; empty where it was not built. */
  engine: string;
}

export type Counts = Record<Status, number>;

export interface Lesson {
  /** The id of its part of the verification page. */
  id: string;
  number: string;
  title: string;
  /** Its source, below the course's folder. */
  file: string;
  /** Its page, below the site's root; empty for a draft. */
  page: string;
  counts: Counts;
  /** In the order in which the lesson states them. */
  claims: Claim[];
}

export interface Claim {
  /** The id of its entry on the verification page. */
  id: string;
  kind: Kind;
  status: Status;
  /** What is claimed, on one line. */
  what: string;
  /** How it was found out; empty where it was not. */
  how: string;
  /** What was not looked at, or how far it was; empty for nothing to say. */
  limits: string;
  /** Why it is not proved, or what its source is; empty for no reason given. */
  reason: string;
  /** Where it stands in the lesson's file, from 1; columns count characters. */
  line: number;
  column: number;
  /** Its place in a page of the site, below the site's root; empty for a draft. */
  page: string;
  /** A hash: two reports that have the same found the same. generator/findings/claim.h says what of. */
  key: string;
}

/** Measured. */
export interface Times {
  /** The whole of it; of a snippet without compiling, which all of a lesson's share. */
  seconds: number;
  /** Of these, a program's own run; 0 for what is not run. */
  run_seconds: number;
}

export type Status =
  /** Found again by computing it. */
  | "proved"
  /** Said by a source that the lesson names. */
  | "cited"
  /** Said by the author alone. */
  | "asserted"
  /** Shown and not run. */
  | "unchecked"
  /** Not so, or nobody can know: a diagnostic says why. */
  | "failed";

export type Kind =
  | "program"
  | "exercise"
  | "page"
  | "region"
  | "snippet"
  | "commands"
  | "output"
  | "listing"
  | "value"
  | "formula"
  | "lab"
  | "picture"
  | "plot"
  | "image"
  | "answer"
  | "citation"
  | "code";

export interface Diagnostic {
  /** Stable: "E-output-differs". */
  id: string;
  severity: "error" | "warning";
  place: Place;
  /** One line. */
  message: string;
  /** More lines: a diff, the compiler's own words; empty for none. */
  detail: string;
  notes: { message: string; place: Place }[];
  /** What to do about it; empty for nothing to suggest. */
  cure: string;
}

export interface Place {
  /** Below the course's folder; empty where a note belongs to the diagnostic's own place. */
  file: string;
  /** From 1; 0 for the file as a whole. */
  line: number;
  /** From 1, in characters. */
  column: number;
  /** Characters to underline. */
  width: number;
  /** The source line. */
  excerpt: string;
}
