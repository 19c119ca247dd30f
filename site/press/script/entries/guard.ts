/**
 * Scripts, by their text. `guard(text, kind, names)` puts the guards into a lab's, and gives JSON, of
 * the text that is run and what it declares for others, or of why there is none; `ask(run, value,
 * names)` tells what a proof's asks.
 */
import { parseExpressionAt } from "acorn";

import { asked } from "../guard/asked.js";
import { inBlock } from "../guard/declared.js";
import { guarded, Refusal } from "../guard/guarded.js";
import { isNode, type Node } from "../guard/syntax.js";
import { closing, key, target, withoutGuards } from "../guards.js";

/** As the page has it (generator/script/page_function.cpp), a line before it and a line behind. */
const around: Readonly<Record<string, readonly [before: string, after: string]>> = {
  definitions: ["() => { {\n", "\n} }"],
  script: ["() => { {\n", "\n} }"],
  value: ["() => { return (\n", "\n); }"],
  assignment: ["() => { (\n", "\n) = value; }"],
};

function guard(text: string, kind: string, names: string): string {
  const [before, after] = around[kind]!;
  const mark = [`${key}(`, `${target}(`, closing].find((one) => text.includes(one));
  try {
    if (mark !== undefined) throw marked(text, mark, before.length);
    const whole = before + text + after;
    const tree = onlyFunction(whole, kind);
    const declares = kind === "definitions" ? declaredBy(tree, names.split("\n")) : [];
    const world = kind === "assignment" ? `${names}\nvalue` : names;
    const safe = guarded(whole, tree, world.split("\n"));
    return JSON.stringify({
      text: safe.slice(before.length, safe.length - after.length),
      declares,
    });
  } catch (error) {
    return JSON.stringify(told(error, text, before.length));
  }
}

function marked(text: string, mark: string, before: number): Refusal {
  const at = before + text.indexOf(mark);
  return new Refusal("E-script-foreign", `a script cannot hold \`${mark}\``, at, at + mark.length);
}

/** The function that `text` is, and nothing else: no bracket of it closes one of ours. */
function onlyFunction(text: string, kind: string): Node {
  const options = { ecmaVersion: "latest", sourceType: "module" } as const;
  const tree = parseExpressionAt(text, 0, options) as unknown as Node;
  const body = tree.type === "ArrowFunctionExpression" ? (tree["body"] as Node) : undefined;
  const statements = (body?.["body"] ?? []) as Node[];
  const [first] = statements;
  const whole = tree.end === text.length && statements.length === 1 && first !== undefined;
  if (!whole || !isOurs(first, kind)) {
    const isBlock = first?.type === "BlockStatement"; // which the stray bracket has closed
    const pos = isBlock ? first.end - 1 : undefined;
    throw Object.assign(new SyntaxError("a closing bracket has no opening one"), { pos });
  }
  return tree;
}

/** The names that the script `tree` declares, none of the world's. It stands before others, and does
 * nothing else. */
function declaredBy(tree: Node, world: readonly string[]): string[] {
  const block = ((tree["body"] as Node)["body"] as Node[])[0]!;
  const statements = block["body"] as Node[];
  const other = statements.find(
    (one) => one.type !== "FunctionDeclaration" && one["kind"] !== "const",
  );
  const taken = statements.find((one) => inBlock([one]).some((name) => world.includes(name)));
  if (taken !== undefined) {
    const name = inBlock([taken]).find((one) => world.includes(one))!;
    const message = `\`${name}\` is a name of every script already`;
    throw new Refusal("E-lab-define", message, taken.start, taken.end, "choose another name");
  }
  if (other === undefined) return inBlock(statements);
  throw new Refusal(
    "E-lab-define",
    "`define` declares functions and constants, and does nothing else",
    other.start,
    other.end,
    "begin with `const` or `function`; what runs belongs into a control's script",
  );
}

function isOurs(statement: Node, kind: string): boolean {
  if (kind === "script" || kind === "definitions") return statement.type === "BlockStatement";
  if (kind === "value") return statement.type === "ReturnStatement";
  const set = statement["expression"];
  return isNode(set) && set.type === "AssignmentExpression" && set["operator"] === "=";
}

/** Why `text` is not run; lines and columns count from 1, in characters. */
function told(error: unknown, text: string, before: number): object {
  if (!(error instanceof Error)) throw error;
  if (!(error instanceof Refusal)) return syntaxError(error, text, before);
  return {
    id: error.id,
    message: error.message,
    cure: error.cure,
    ...placed(text, error.start - before, error.end - before),
  };
}

/** Of a text that does not parse. Its place is acorn's; behind the end of the text there is none, as
 * something is missing. A message of acorn's ends with a place that counts what is around the text. */
function syntaxError(error: Error, text: string, before: number): object {
  const message = error.message.replace(/ \(\d+:\d+\)$/u, "");
  const at = (error as { readonly pos?: number }).pos ?? 0;
  const isInside = at >= before && at - before < text.trimEnd().length;
  const place = isInside
    ? placed(text, at - before, at - before + 1)
    : { line: 0, column: 0, width: 1 };
  return { id: "E-script-syntax", cure: "", message, ...place };
}

function placed(text: string, from: number, to: number): object {
  const start = Math.min(Math.max(from, 0), text.length);
  const lines = text.slice(0, start).split("\n");
  const shown = text.slice(start, to).split("\n")[0]!;
  return {
    line: lines.length,
    column: Array.from(lines.at(-1)!).length + 1,
    width: Math.max(Array.from(shown).length, 1),
  };
}

function ask(run: string, value: string, names: string): string {
  return JSON.stringify(asked(run, value, names.split("\n")));
}

Object.assign(globalThis, { guard, withoutGuards, ask });
