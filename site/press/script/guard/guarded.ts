/**
 * A lab's script, made fit for the reader's page. There it is a part of the site's own code, so
 * nothing of the page is out of its reach by itself. What it may name and write is decided here, by
 * its text, before it is run anywhere. Enter with guarded(). What the text cannot tell, the guards do
 * (guards.ts).
 */
import * as guards from "../guards.js";
import { suggest } from "../suggest.js";
import { bound, inBlock, inFunction } from "./declared.js";
import { builtins, childrenOf, isFunction, isNode, type Node, parts, syntax } from "./syntax.js";

/** What a script must not do, and where in its text. */
export class Refusal extends Error {
  constructor(
    readonly id: string,
    message: string,
    readonly start: number,
    readonly end: number,
    readonly cure = "",
  ) {
    super(message);
  }
}

type Scope = ReadonlySet<string>;
function within(scope: Scope, names: readonly string[]): Scope {
  return names.length === 0 ? scope : new Set([...scope, ...names]);
}

/** `text` with its guards; `tree` is the function in it that is the script, which sees `names`. */
export function guarded(text: string, tree: Node, names: readonly string[]): string {
  refuseGuards(tree);
  const walk = new Walk(names);
  walk.body(tree["body"] as Node, new Set());
  return walk.marked(text);
}

/** A name of ours is none of the author's, wherever it stands: he could put himself in its place. */
function refuseGuards(node: Node): void {
  const name = node.type === "Identifier" ? String(node["name"]) : "";
  if (name === guards.key || name === guards.target) {
    throw new Refusal("E-script-foreign", guards.foreignMember(name), node.start, node.end);
  }
  childrenOf(node).forEach(refuseGuards);
}

class Walk {
  readonly #world: ReadonlySet<string>;
  readonly #names: readonly string[];
  readonly #marks: { readonly at: number; readonly text: string; readonly closes: boolean }[] = [];

  constructor(names: readonly string[]) {
    this.#names = names;
    this.#world = new Set([...names, ...builtins]);
  }

  /** Closing marks come before opening ones of the same place, outer opening ones before inner. */
  marked(text: string): string {
    const sorted = this.#marks
      .map((mark, index) => ({ ...mark, index }))
      .sort((a, b) => a.at - b.at || Number(b.closes) - Number(a.closes) || a.index - b.index);
    let out = "";
    let from = 0;
    for (const mark of sorted) {
      out += text.slice(from, mark.at) + mark.text;
      from = mark.at;
    }
    return out + text.slice(from);
  }

  #guard(node: Node, name: string): void {
    this.#marks.push({ at: node.start, text: `${name}((`, closes: false });
    this.#marks.push({ at: node.end, text: guards.closing, closes: true });
  }

  /** Of a function. */
  body(body: Node, scope: Scope): void {
    this.#visit(body, within(scope, inFunction(body)));
  }

  #visitAll(nodes: readonly unknown[], scope: Scope): void {
    for (const node of nodes) if (isNode(node)) this.#visit(node, scope);
  }

  #visit(node: Node, scope: Scope): void {
    if (!syntax.has(node.type) || node["async"] === true || node["generator"] === true) {
      throw notASentence(node);
    }
    if (isFunction(node)) {
      this.#function(node, scope);
      return;
    }
    switch (node.type) {
      case "Identifier": {
        this.#name(node, scope);
        return;
      }
      case "MemberExpression": {
        this.#member(node, scope);
        return;
      }
      case "Property": {
        this.#property(node, scope);
        return;
      }
      case "BlockStatement": {
        this.#visitAll(childrenOf(node), within(scope, inBlock(node["body"] as unknown[])));
        return;
      }
      case "SwitchStatement": {
        this.#switch(node, scope);
        return;
      }
      case "ForStatement": {
        this.#visitAll(childrenOf(node), within(scope, inBlock([node["init"]])));
        return;
      }
      case "ForInStatement":
      case "ForOfStatement": {
        this.#loop(node, scope);
        return;
      }
      case "CatchClause": {
        this.#visitAll(childrenOf(node), within(scope, bound(node["param"])));
        return;
      }
      case "LabeledStatement": {
        this.#visitAll([node["body"]], scope);
        return;
      }
      case "BreakStatement":
      case "ContinueStatement":
        return;
      default: {
        this.#other(node, scope);
        return;
      }
    }
  }

  #function(node: Node, outer: Scope): void {
    const own = node.type === "FunctionExpression" ? bound(node["id"]) : [];
    const parameters = node["params"] as Node[];
    const scope = within(outer, [...own, ...parameters.flatMap(bound)]);
    this.#visitAll(node.type === "FunctionDeclaration" ? [node["id"]] : [], outer);
    // what a parameter is without an argument sees none of the body's own names
    this.#visitAll(parameters, scope);
    this.body(node["body"] as Node, scope);
  }

  #switch(node: Node, scope: Scope): void {
    const cases = node["cases"] as Node[];
    this.#visitAll([node["discriminant"]], scope);
    const statements = cases.flatMap((one) => one["consequent"] as unknown[]);
    this.#visitAll(cases, within(scope, inBlock(statements)));
  }

  #loop(node: Node, scope: Scope): void {
    if (node["await"] === true) throw notASentence(node);
    const left = node["left"] as Node;
    this.#written(left, scope);
    this.#visitAll(childrenOf(node), within(scope, inBlock([left])));
  }

  #other(node: Node, scope: Scope): void {
    if (node.type === "VariableDeclaration" && !/^(var|let|const)$/u.test(String(node["kind"]))) {
      throw notASentence(node);
    }
    if (node.type === "AssignmentExpression") this.#written(node["left"] as Node, scope);
    if (node.type === "UpdateExpression") this.#written(node["argument"] as Node, scope);
    if (node["operator"] === "delete") this.#target(withoutChain(node["argument"] as Node));
    this.#visitAll(childrenOf(node), scope);
  }

  #name(node: Node, scope: Scope): void {
    const name = node["name"] as string;
    if (scope.has(name) || this.#world.has(name)) return;
    const some = parts.get(name);
    if (some !== undefined) {
      const cure = some.map((part) => `\`${name}.${part}\``).join(", ");
      const message = `a lab's script cannot use \`${name}\` by itself`;
      throw new Refusal("E-script-foreign", message, node.start, node.end, `use ${cure}`);
    }
    const cure = suggest(
      name,
      [...scope, ...this.#names].filter((known) => !known.includes("$")),
      "",
    );
    throw new Refusal("E-script-name", `\`${name}\` does not exist`, node.start, node.end, cure);
  }

  #member(node: Node, scope: Scope): void {
    const [object, key] = [node["object"] as Node, node["property"] as Node];
    const known = plainKey(node, key);
    const some = object.type === "Identifier" ? parts.get(object["name"] as string) : undefined;
    const isPart = some !== undefined && !scope.has(object["name"] as string);
    if (isPart && known !== undefined && some.includes(known)) return;
    this.#visit(object, scope);
    if (known !== undefined) {
      this.#checkMember(known, key);
      return;
    }
    if (key.type === "Literal" && typeof key["value"] === "number") return;
    if (key.type === "PrivateIdentifier") throw notASentence(key);
    this.#guard(key, guards.key);
    this.#visit(key, scope);
  }

  #property(node: Node, scope: Scope): void {
    const key = node["key"] as Node;
    const known = plainKey(node, key);
    if (node["kind"] !== "init") throw notASentence(node);
    if (known !== undefined) this.#checkMember(known, key);
    else {
      this.#guard(key, guards.key);
      this.#visit(key, scope);
    }
    this.#visit(node["value"] as Node, scope);
  }

  #checkMember(name: string, key: Node): void {
    if (!guards.foreignMembers.has(name)) return;
    throw new Refusal("E-script-foreign", guards.foreignMember(name), key.start, key.end);
  }

  /** What is written to: a name, a member, or several of them in a pattern. */
  #written(node: Node, scope: Scope): void {
    for (const name of bound(node)) {
      if (scope.has(name) || !builtins.has(name)) continue;
      const message = `\`${name}\` cannot be assigned`;
      throw new Refusal(
        "E-script-value",
        message,
        node.start,
        node.end,
        "it belongs to JavaScript",
      );
    }
    this.#target(node);
  }

  #target(node: Node | null): void {
    switch (node?.type) {
      case "MemberExpression": {
        this.#changed(node["object"] as Node);
        return;
      }
      case "ArrayPattern": {
        this.#targets(node["elements"]);
        return;
      }
      case "ObjectPattern": {
        this.#targets(node["properties"]);
        return;
      }
      case "Property": {
        this.#targets([node["value"]]);
        return;
      }
      case "AssignmentPattern": {
        this.#targets([node["left"]]);
        return;
      }
      case "RestElement": {
        this.#targets([node["argument"]]);
        return;
      }
      default:
    }
  }

  #targets(nodes: unknown): void {
    for (const node of nodes as (Node | null)[]) this.#target(node);
  }

  #changed(object: Node): void {
    const name = object.type === "Identifier" ? (object["name"] as string) : "";
    if (parts.has(name)) {
      const message = `a lab's script cannot change \`${name}\``;
      throw new Refusal("E-script-foreign", message, object.start, object.end);
    }
    this.#guard(object, guards.target);
  }
}

/** The name of a member where the text says it: `.name`, `["name"]`, `{ name }`. */
function plainKey(node: Node, key: Node): string | undefined {
  if (node["computed"] !== true && key.type === "Identifier") return key["name"] as string;
  return key.type === "Literal" && typeof key["value"] === "string" ? key["value"] : undefined;
}

function withoutChain(node: Node): Node {
  return node.type === "ChainExpression" ? (node["expression"] as Node) : node;
}

const sayings: Readonly<Record<string, string>> = {
  ThisExpression: "`this`",
  Super: "`super`",
  ImportExpression: "`import`",
  MetaProperty: "`import` and `new.target`",
  AwaitExpression: "`await`",
  YieldExpression: "`yield`",
  ClassDeclaration: "classes",
  ClassExpression: "classes",
  TaggedTemplateExpression: "tagged templates",
  DebuggerStatement: "`debugger`",
  Property: "getters and setters",
  VariableDeclaration: "`using`",
  PrivateIdentifier: "private names",
};

function notASentence(node: Node): Refusal {
  const what =
    isFunction(node) || node.type === "ForOfStatement"
      ? "functions that go on later"
      : (sayings[node.type] ?? node.type);
  const message = `a lab's script cannot use ${what}`;
  return new Refusal("E-script-foreign", message, node.start, node.end);
}
