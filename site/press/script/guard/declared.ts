/** Which names a piece of a script declares: what is declared nowhere is a name of the page. */
import { childrenOf, isFunction, isNode, type Node } from "./syntax.js";

/** The names that a pattern binds: `a`, `[a, ...b]`, `{ a, b: c = 1 }`. */
export function bound(pattern: unknown): string[] {
  if (!isNode(pattern)) return [];
  switch (pattern.type) {
    case "Identifier":
      return [pattern["name"] as string];
    case "ArrayPattern":
      return (pattern["elements"] as unknown[]).flatMap(bound);
    case "ObjectPattern":
      return (pattern["properties"] as Node[]).flatMap((part) =>
        bound(part.type === "Property" ? part["value"] : part),
      );
    case "AssignmentPattern":
      return bound(pattern["left"]);
    case "RestElement":
      return bound(pattern["argument"]);
    default:
      return [];
  }
}

function declaredBy(node: Node): string[] {
  if (node.type === "FunctionDeclaration") return bound(node["id"]);
  if (node.type !== "VariableDeclaration") return [];
  return (node["declarations"] as Node[]).flatMap((one) => bound(one["id"]));
}

/** Those that hold in a block, a loop's head or a switch, for these statements of its own. */
export function inBlock(statements: readonly unknown[]): string[] {
  return statements
    .filter(isNode)
    .flatMap((node) => (node["kind"] === "var" ? [] : declaredBy(node)));
}

/** The `var`s below a function's body, which hold in all of it. */
export function inFunction(body: Node): string[] {
  const own = body.type === "VariableDeclaration" && body["kind"] === "var" ? declaredBy(body) : [];
  const below = childrenOf(body).filter((child) => !isFunction(child));
  return [...own, ...below.flatMap(inFunction)];
}
