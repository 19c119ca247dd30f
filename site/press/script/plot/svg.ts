/** What becomes of Vega's SVG before it stands in a page. */
import type { Drawing } from "./drawing.js";

/** `id` begins the drawing's own ids. */
export function finish(svg: string, id: string): Drawing {
  const [head] = /^<svg[^>]*>/.exec(svg)!;
  const [width, height] = ["width", "height"].map((name) =>
    Math.ceil(Number(new RegExp(` ${name}="([^"]*)"`).exec(head)![1])),
  ) as [number, number];
  const body = svg
    .slice(head.length)
    .replace(/<path[^>]*(?:d=""|d="M0,0h0v0h0Z")[^>]*\/>/g, "") // a group's empty ground
    .replace(/<[^>]+>/g, (tag) => finishTag(tag, id))
    .replace(/>([-−]?)(\d+(?:\.\d+)?)e([-−+]?)(\d+)</g, powerOfTen);
  return { svg: body.slice(0, body.lastIndexOf("</svg>")), width, height };
}

/** What stands between tags is the author's. */
function finishTag(tag: string, id: string): string {
  return tag
    .replace(/ (?:class|role|aria-[a-z]+|pointer-events)="[^"]*"/g, "")
    .replace(/(\bid="|url\(#|href="#)/g, `$1${id}-`)
    .replace(/-?\d*\.\d{3,}(?:e-?\d+)?/g, rounded);
}

/** A hundredth of a pixel is not seen. */
function rounded(number: string): string {
  return String(Number(Number(number).toFixed(2)));
}

/** 2.5e−4 as people write it. */
function powerOfTen(_: string, sign: string, mantissa: string, below: string, power: string) {
  const head = mantissa === "1" ? "10" : `${mantissa}\u2009×\u200910`;
  const exponent = `${below.replace("+", "").replace("-", "−")}${power}`;
  return `>${sign}${head}<tspan class="power" dy="-0.4em">${exponent}</tspan><`;
}
