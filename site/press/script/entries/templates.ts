/**
 * Handlebars in strict mode. `addTemplate(name, source)` first, then `render(name, data)` gives "="
 * and the HTML, or the JSON `{name, message, line, cure}` of the template with the mistake.
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
    readonly cure = "",
  ) {
    super(message);
  }
}

const mostMade = 128 << 20; // characters, of a page; the largest that a lesson may have is a third

// What the loops of this page have made so far. A loop in a loop is counted in both.
let madeInLoops = 0;

class TooMuch extends Error {}

const each = handlebars.helpers["each"]!;
const boundedEach = function (this: unknown, items: unknown, options: Handlebars.HelperOptions) {
  const fn = (item: unknown, settings?: Handlebars.RuntimeOptions): string => {
    const made = options.fn(item, settings);
    madeInLoops += made.length;
    if (madeInLoops > 4 * mostMade) throw new TooMuch();
    return made;
  };
  return each.call(this, items, { ...options, fn }) as string;
};
handlebars.registerHelper("each", boundedEach as Handlebars.HelperDelegate);

function addTemplate(name: string, source: string): string {
  const template = lazily(() => {
    const ours = known[name];
    if (ours?.source === source) return handlebars.template(ours.spec);
    return handlebars.compile(strictly(source), options);
  });
  const tagged: Handlebars.TemplateDelegate = (data: unknown, options) => {
    try {
      const made = template()(data, options);
      if (made.length > mostMade) throw new TooMuch();
      return made;
    } catch (error) {
      if (error instanceof TooMuch) throw tooMuchOf(name);
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

function tooMuchOf(name: string): Mistake {
  const cure = "look for a loop in a loop, and for a template that includes another one twice";
  return new Mistake(name, `makes more than ${mostMade >> 20} MiB of a page`, 0, cure);
}

/** `data` is JSON. HTML goes as it is: to make JSON of it and to read that takes long. */
function render(name: string, data: string): string {
  const template = handlebars.partials[name] as Handlebars.TemplateDelegate | undefined;
  madeInLoops = 0;
  try {
    if (template === undefined) throw new Mistake(name, "there is no such template", 0);
    return `=${template(JSON.parse(data))}`;
  } catch (error) {
    if (!(error instanceof Mistake)) throw error;
    const { template: of, message, line, cure } = error;
    return JSON.stringify({ name: of, message, line, cure });
  }
}

Object.assign(globalThis, { addTemplate, render });
