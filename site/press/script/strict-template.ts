/**
 * What a template of Handlebars is compiled from: by the bundler for those of this folder, which
 * takes the generator longer than a lesson's page does, and by the generator for a course's own.
 */
import Handlebars from "handlebars";

export const options = { strict: true };

/** Strict mode alone lets pass a name that a condition or a loop is given: `{{#if titel}}`. */
class StrictEverywhere extends Handlebars.Visitor {
  override PathExpression(path: hbs.AST.PathExpression): void {
    Object.assign(path, { strict: true });
  }
}

export function strictly(source: string): hbs.AST.Program {
  const program = Handlebars.parse(source);
  new StrictEverywhere().accept(program);
  return program;
}
