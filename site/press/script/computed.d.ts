// What the bundler computes for the scripts here: bundle/computed.mjs.

declare module "computed:templates" {
  /** By name: its text, and what Handlebars.precompile makes of it. */
  const templates: Readonly<Record<string, { source: string; spec: TemplateSpecification }>>;
  export default templates;
}
