/** What the page and the compiler's worker say to each other. */

/** A program with all that it is compiled of and opens. */
export interface Program {
  /** The path of the .cpp among `files`. */
  readonly main: string;
  readonly files: Readonly<Record<string, string | Uint8Array>>;
  /** The folder that MJCOURSE_MODELS names. */
  readonly models: string;
  /** Of its command line, after its name. */
  readonly arguments?: readonly string[];
}

export type ToWorker =
  | {
      readonly kind: "open";
      readonly llvm: string;
      readonly pack: string;
      readonly engineGlue: string;
      readonly engineWasm: string;
    }
  | {
      readonly kind: "run";
      readonly id: number;
      readonly program: Program;
      /** What it is to print; none where nobody knows. */
      readonly stated: readonly StatedOutput[];
    };

export interface StatedOutput {
  readonly text: string;
  /** Absolute; without one, the unit of the last place that the text has. */
  readonly tolerance: number | null;
}

/** Between a text that is stated and what was printed. */
export interface OutputChanges {
  /** How many lines are stated and were not printed. */
  readonly gone: number;
  /** Which lines were printed that are not stated; they count from 1. */
  readonly come: readonly number[];
}

export type Stage = "download" | "compile-tools" | "header";

export type FromWorker =
  | {
      readonly kind: "progress";
      readonly stage: Stage;
      readonly done: number;
      readonly total: number;
    }
  | { readonly kind: "ready" }
  | {
      readonly kind: "failed";
      readonly why: "network" | "memory" | "unknown";
      readonly message: string;
    }
  | {
      readonly kind: "compiled";
      readonly id: number;
      readonly diagnostics: readonly Diagnostic[];
      readonly ok: boolean;
    }
  | {
      readonly kind: "output";
      readonly id: number;
      readonly stream: "out" | "err";
      readonly text: string;
    }
  | {
      readonly kind: "ended";
      readonly id: number;
      readonly end: End;
      /** JSON lines, as the program writes them to the file of MJCOURSE_RECORDS. */
      readonly records: string;
      /** The last one that the program loaded. */
      readonly model: LoadedModel | undefined;
      /** Nothing where no output was stated. */
      readonly changes: OutputChanges | undefined;
      readonly seconds: { readonly compile: number; readonly link: number; readonly run: number };
    };

/** What mj_loadXML made a model of. */
export interface LoadedModel {
  /** Of its main file: "ball.xml". */
  readonly name: string;
  /** The main file, and those that the program itself made for it. */
  readonly files: Readonly<Record<string, Uint8Array>>;
}

/** Lines and columns count from 1. */
export interface Diagnostic {
  readonly file: string;
  readonly line: number;
  readonly column: number;
  readonly endLine: number;
  readonly endColumn: number;
  readonly severity: "error" | "warning" | "note";
  readonly message: string;
}

export type End =
  | { readonly how: "exit"; readonly code: number; readonly line?: number }
  | {
      readonly how: "error" | "trap" | "stack-overflow" | "uncaught" | "memory" | "output";
      readonly message: string;
      readonly line?: number;
    };
