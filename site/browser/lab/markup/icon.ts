/** The signs on a lab's buttons: drawn in a square of 16 with the text's colour. */

const shapes = {
  play: "M4 2.5v11l9.5-5.5z",
  pause: "M4 2.5h3v11H4zM9 2.5h3v11H9z",
  step: "M3 2.5v11l7.5-5.5zM11.5 2.5h2v11h-2z",
  steps: "M1 2.5v11l6-5.5zM7 2.5v11l6-5.5zM13.5 2.5h2v11h-2z",
  back: "M2.5 2.5h2v11h-2zM13.5 2.5v11L5.5 8z",
  whole: "M2 6V2h4v1.5H3.5V6zM10 2h4v4h-1.5V3.5H10zM2 10h1.5v2.5H6V14H2zM12.5 10H14v4h-4v-1.5h2.5z",
  fold: "M3 5.2 4.1 4 8 8l3.9-4L13 5.2 8 10.4z",
  unfold: "M3 10.2 8 5l5 5.2-1.1 1.2L8 7.4l-3.9 4z",
  close:
    "M3.2 2.1 8 6.9l4.8-4.8 1.1 1.1L9.1 8l4.8 4.8-1.1 1.1L8 9.1l-4.8 4.8-1.1-1.1L6.9 8 2.1 3.2z",
} as const;
export type Icon = keyof typeof shapes;

const svg = "http://www.w3.org/2000/svg";

export function icon(name: Icon): SVGElement {
  const picture = document.createElementNS(svg, "svg");
  picture.setAttribute("viewBox", "0 0 16 16");
  picture.setAttribute("class", "icon");
  picture.setAttribute("aria-hidden", "true");
  const path = document.createElementNS(svg, "path");
  path.setAttribute("d", shapes[name]);
  picture.append(path);
  return picture;
}
