/**
 * What the text of a proof's expression tells of it: whether it asks the model or its data for
 * anything at all, and which function of the author's it puts a value into. Enter with asked().
 */
import { parse, parseExpressionAt } from "acorn";

import { builtins, childrenOf, isNode, type Node } from "./syntax.js";

export interface Asked {
  /** It names the model, its data, or one of their functions, or what `run` made of these. */
  readonly world: boolean;
  /** `heldIn` of `heldIn([1, 0, 0, 0])`, where `run` declares it; else "". */
  readonly callee: string;
  /** Its arguments, as they are written. */
  readonly values: string;
}

/** `value` sees what `run` declares; `names` are the world's. Both have run already. */
export function asked(run: string, value: string, names: readonly string[]): Asked {
  const tree = parseExpressionAt(`(${value}\n)`, 0, { ecmaVersion: "latest" }) as unknown as Node;
  const world = new Set(names);
  const known = new Set([...names, ...builtins, "JSON", "Object"]);
  const named = identifiers(tree);
  const before = named.some((name) => !known.has(name)) ? identifiers(statements(run)) : [];
  const call = tree.type === "CallExpression" ? (tree["callee"] as Node) : undefined;
  const callee = call?.type === "Identifier" ? String(call["name"]) : "";
  const values = tree["arguments"] as Node[] | undefined;
  const own = !known.has(callee) && values !== undefined && values.length > 0 ? callee : "";
  return {
    world: [...named, ...before].some((name) => world.has(name) && !isFormula(name)),
    callee: own,
    values: own === "" ? "" : `(${value}`.slice(values![0]!.start, values!.at(-1)!.end),
  };
}

function statements(run: string): Node {
  return parse(run, { ecmaVersion: "latest" }) as unknown as Node;
}

/** What computes without a model: `Math`, `mju_rotVecQuat`, `mjJNT_FREE`. */
function isFormula(name: string): boolean {
  return /^(?:Math$|mju_|mj[A-Z])/u.test(name);
}

/** All that are used, but for the names of members. */
function identifiers(node: Node): string[] {
  if (node.type === "Identifier") return [String(node["name"])];
  const isMember = node.type === "MemberExpression" || node.type === "Property";
  const member =
    isMember && node["computed"] !== true ? (node["property"] ?? node["key"]) : undefined;
  const hidden = node["shorthand"] === true ? undefined : member;
  return childrenOf(node)
    .filter((child) => isNode(child) && child !== hidden)
    .flatMap(identifiers);
}
