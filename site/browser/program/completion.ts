/**
 * What a reader may mean by the letters of a program: MuJoCo's functions, types, constants and
 * fields, from the site's own index of them, and what the course's header declares. Enter with
 * completionOf().
 */
import type { Completion, CompletionContext, CompletionSource } from "@codemirror/autocomplete";

/** As generator/page/api_names.h writes them. */
export type ApiName = readonly [name: string, kind: string, declaration: string, comment: string];

/** What stands before a field: the expression, without blanks. */
const beforeField = /([A-Za-z_][\w.>[\]()-]*?)(?:->|\.)\w*$/;

/** A variable's declaration, as programs of lessons write it. */
const declared = /\b(?:const\s+)?(mj[A-Z]\w+|Model|Data)\s*[*&]?\s+[*&]?(\w+)\b/g;

/** The structures that the course's header owns. */
const owned: Readonly<Record<string, string>> = { Model: "mjModel", Data: "mjData" };

/** `load` gives the index, and is called when the reader first types; `header` is the text of the
 * course's own header. */
export function completionOf(
  load: () => Promise<readonly ApiName[]>,
  header: string,
): CompletionSource {
  let index: Promise<Index> | undefined;
  return async (context) => {
    const word = context.matchBefore(/\w+/);
    const line = context.state.doc.lineAt(context.pos);
    const before = line.text.slice(0, context.pos - line.from);
    const field = beforeField.exec(before);
    if (field === null && !context.explicit && (word?.text.length ?? 0) < 3) return null;
    index ??= load().then((names) => new Index(names, header));
    const found = await index.catch(() => (index = undefined));
    if (found === undefined || context.aborted) return null;
    const from = word?.from ?? context.pos;
    const options = field === null ? found.words : found.fieldsOf(field[1]!, variablesIn(context));
    return options.length === 0 ? null : { from, options, validFor: /^\w*$/ };
  };
}

/** The structure of each variable that the program declares. */
function variablesIn(context: CompletionContext): ReadonlyMap<string, string> {
  const text = context.state.doc.toString();
  return new Map(
    [...text.matchAll(declared)].map(([, type, name]) => [name!, owned[type!] ?? type!]),
  );
}

class Index {
  /** What begins an expression. */
  readonly words: readonly Completion[];
  readonly #fields = new Map<string, Completion[]>();
  /** Of a field that is a structure: "mjModel.opt" is an "mjOption". */
  readonly #types = new Map<string, string>();

  constructor(names: readonly ApiName[], header: string) {
    const words: Completion[] = functionsOf(header);
    for (const [name, kind, declaration, comment] of names) {
      const dot = name.lastIndexOf(".");
      const label = name.slice(dot + 1);
      const completion = { label, type: kind, detail: detailOf(declaration, label), info: comment };
      if (dot < 0) words.push(completion);
      else {
        const owner = name.slice(0, dot);
        this.#fields.set(owner, [...(this.#fields.get(owner) ?? []), completion]);
        this.#types.set(name, /\bmj[A-Z]\w*/.exec(declaration)?.[0] ?? name);
      }
    }
    this.words = words;
  }

  /** Of `model->opt`, where `variables` has `model`. */
  fieldsOf(expression: string, variables: ReadonlyMap<string, string>): readonly Completion[] {
    const [variable, ...path] = expression.replaceAll(/\[[^\]]*\]|\([^)]*\)/g, "").split(/->|\./);
    let type = variables.get(variable!);
    for (const field of path)
      type = type === undefined ? type : this.#types.get(`${type}.${field}`);
    return type === undefined ? [] : (this.#fields.get(type) ?? []);
  }
}

/** The declaration without its name, which stands before it: the parameters, or the type. */
function detailOf(declaration: string, name: string): string {
  const parameters = declaration.indexOf("(");
  if (parameters >= 0) return declaration.slice(parameters);
  return declaration.replace(new RegExp(`\\b${name}\\b`), "").trim();
}

/** The functions that the course's header defines, with the comment above each. */
function functionsOf(header: string): Completion[] {
  const pattern = /((?:^\/\/.*\n)*)^(?:template.*\n)?inline [\w:<>*& ]*?\b(\w+)\(([^)]*)\)/gm;
  const found = new Map<string, Completion>();
  for (const [, comment, label, parameters] of header.matchAll(pattern)) {
    const info = comment!
      .replaceAll(/^\/\/ ?/gm, "")
      .replaceAll("\n", " ")
      .trim();
    const detail = `(${parameters!.replaceAll(/\s+/g, " ")})`;
    found.set(label!, { label: label!, type: "function", detail, info });
  }
  return [...found.values()];
}
