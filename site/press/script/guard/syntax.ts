/** The parts of JavaScript that a lab's script is made of; acorn's tree, as far as it is looked at. */

/** A node of the tree: its members are nodes, lists of nodes, or plain values. */
export interface Node {
  readonly type: string;
  readonly start: number;
  readonly end: number;
  readonly [member: string]: unknown;
}

/** Without classes, `this`, `import`, tagged templates and all that goes on when a script has ended. */
export const syntax: ReadonlySet<string> = new Set([
  ...["ArrowFunctionExpression", "FunctionExpression", "FunctionDeclaration"],
  ...["BlockStatement", "ExpressionStatement", "EmptyStatement", "IfStatement", "ForStatement"],
  ...["ForInStatement", "ForOfStatement", "WhileStatement", "DoWhileStatement", "ReturnStatement"],
  ...["BreakStatement", "ContinueStatement", "LabeledStatement", "SwitchStatement", "SwitchCase"],
  ...["ThrowStatement", "TryStatement", "CatchClause", "VariableDeclaration", "VariableDeclarator"],
  ...["Identifier", "Literal", "TemplateLiteral", "TemplateElement", "ArrayExpression"],
  ...["ObjectExpression", "Property", "SpreadElement", "RestElement", "AssignmentPattern"],
  ...["ArrayPattern", "ObjectPattern", "UnaryExpression", "UpdateExpression", "BinaryExpression"],
  ...["LogicalExpression", "ConditionalExpression", "AssignmentExpression", "SequenceExpression"],
  ...["CallExpression", "NewExpression", "MemberExpression", "ChainExpression"],
]);

/** What of JavaScript's own a script may name, besides the world's names. */
export const builtins: ReadonlySet<string> = new Set([
  ...["Array", "Boolean", "Error", "Infinity", "Map", "NaN", "Number", "Set", "String"],
  ...["isFinite", "isNaN", "parseFloat", "parseInt", "undefined"],
  ...["Float64Array", "Float32Array", "Int32Array", "Uint8Array"],
]);

/** Of these, no more than these functions. */
export const parts: ReadonlyMap<string, readonly string[]> = new Map([
  ["JSON", ["parse", "stringify"]],
  ["Object", ["entries", "fromEntries", "hasOwn", "is", "keys", "values"]],
]);

export function childrenOf(node: Node): Node[] {
  return Object.values(node)
    .flat()
    .filter((child): child is Node => isNode(child));
}

export function isNode(value: unknown): value is Node {
  return typeof value === "object" && value !== null && "type" in value && "start" in value;
}

export function isFunction(node: Node): boolean {
  return /^(ArrowFunctionExpression|FunctionExpression|FunctionDeclaration)$/u.test(node.type);
}
