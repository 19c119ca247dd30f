// The templates of press/templates, compiled: a module that the generator's script of templates has
// in it. To compile the thirty of a lesson takes a thread of the generator a quarter of a second.

import { readdir, readFile } from "node:fs/promises";
import path from "node:path";

import Handlebars from "handlebars";

import { options, strictly } from "../press/script/strict-template.ts";

export async function compiledTemplates(site) {
  const folder = path.join(site, "press/templates");
  const files = (await readdir(folder)).filter((file) => file.endsWith(".hbs")).sort();
  const entries = files.map(async (file) => {
    const source = await readFile(path.join(folder, file), "utf8");
    const spec = Handlebars.precompile(strictly(source), options);
    return `${JSON.stringify(file.slice(0, -4))}:{source:${JSON.stringify(source)},spec:${spec}}`;
  });
  return `export default {${(await Promise.all(entries)).join(",\n")}};`;
}
