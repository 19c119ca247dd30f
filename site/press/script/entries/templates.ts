/**
 * Handlebars in strict mode. `addTemplate(name, source)` first, then `render(name, data)` gives "="
 * and the HTML, or the JSON `{name, message, line}` of the template with the mistake.
 */
import Handlebars from "handlebars";
import known from "computed:templates";

import { options, strictly } from "../strict-template.js";

const handlebars = Handlebars.create();

/** A mistake, and the innermost template it is in. */
class Mistake extends Error {
  constructor(
    readonly template: string,
    message: string,
    readonly line: number,
  ) {
    super(message);
  }
}

function addTemplate(name: string, source: string): string {
  const template = lazily(() => {
    const ours = known[name];
    if (ours?.source === source) return handlebars.template(ours.spec);
    return handlebars.compile(strictly(source), options);
  });
  const tagged: Handlebars.TemplateDelegate = (data: unknown, options) => {
    try {
      return template()(data, options);
    } catch (error) {
      throw error instanceof Mistake ? error : mistakeIn(name, error as HandlebarsError);
    }
  };
  handlebars.registerPartial(name, tagged);
  return "";
}

function lazily<T>(make: () => T): () => T {
  let made: T | undefined;
  return () => (made ??= make());
}

/** What Handlebars and its parser throw. */
interface HandlebarsError {
  readonly message: string;
  readonly lineNumber?: number;
}

function mistakeIn(name: string, { message, lineNumber }: HandlebarsError): Mistake {
  // the parser tells its line only in words, and draws the place before it says what it expected
  const inWords = /^(?:Parse|Lexical) error on line (\d+)/.exec(message);
  const line = lineNumber ?? Number(inWords?.[1] ?? 0);
  const text = (inWords === null ? message : message.split("\n").at(-1)!)
    .replace(/ - \d+:\d+$/, "")
    .replace(/ not defined in \[object Object\]$/, " is not in the data");
  return new Mistake(name, text, line);
}

/** `data` is JSON. HTML goes as it is: to make JSON of it and to read that takes long. */
function render(name: string, data: string): string {
  const template = handlebars.partials[name] as Handlebars.TemplateDelegate | undefined;
  try {
    if (template === undefined) throw new Mistake(name, "there is no such template", 0);
    return `=${template(JSON.parse(data))}`;
  } catch (error) {
    if (!(error instanceof Mistake)) throw error;
    return JSON.stringify({ name: error.template, message: error.message, line: error.line });
  }
}

Object.assign(globalThis, { addTemplate, render });
