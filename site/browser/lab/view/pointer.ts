/**
 * The mouse and the fingers on a view, as MuJoCo's own viewer has them: left turns, right or Shift
 * moves, two fingers turn into zoom and move, Ctrl (⌘) pulls the body under the pointer.
 *
 * The page keeps what is its own: one finger up or down scrolls it (touch-action in lab-view.css), and
 * so does the wheel, unless Ctrl is held or the view has the focus.
 */
import type { Action } from "../../engine/scene.js";

/** Places are parts of the view: x from the left, y from the top; ways are parts of its height. */
export interface PointerTarget {
  /** Whether a drag pulls a body without Ctrl as well. */
  readonly pushing: boolean;
  moveCamera(action: Action, dx: number, dy: number): void;
  /** False when there is no body. */
  grab(x: number, y: number): boolean;
  drag(dx: number, dy: number): void;
  release(): void;
  home(): void;
  /** The wheel was turned over the view and scrolls the page. */
  wheelPassed(): void;
}

const wheelStep = 0.05;
const pixelsOfWheelStep = 100;

/** Pixels sideways after which a finger turns the view, and does not scroll the page. */
const sideways = 8;

interface Finger {
  x: number;
  y: number;
}

export class Pointer {
  readonly #canvas: HTMLCanvasElement;
  readonly #target: PointerTarget;
  readonly #fingers = new Map<number, Finger>();
  /** What the drag does; undefined when nothing is held, or it is not clear yet. */
  #doing: "turn" | "move" | "pull" | undefined;

  constructor(canvas: HTMLCanvasElement, target: PointerTarget) {
    this.#canvas = canvas;
    this.#target = target;
    canvas.addEventListener("pointerdown", (event) => this.#down(event));
    canvas.addEventListener("pointermove", (event) => this.#moved(event));
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"] as const) {
      canvas.addEventListener(end, (event) => this.#up(event));
    }
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    canvas.addEventListener("touchstart", keepTwoFingers, { passive: false });
    canvas.addEventListener("touchmove", keepTwoFingers, { passive: false });
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("dblclick", () => target.home());
  }

  #down(event: PointerEvent): void {
    this.#canvas.setPointerCapture(event.pointerId);
    this.#fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (this.#fingers.size > 1) {
      this.#letGo();
      return;
    }
    const pull = event.ctrlKey || event.metaKey || this.#target.pushing;
    if (pull && this.#target.grab(...this.#place(event))) this.#doing = "pull";
    else if (event.pointerType === "touch") this.#doing = undefined;
    else this.#doing = event.button === 0 && !event.shiftKey ? "turn" : "move";
  }

  #moved(event: PointerEvent): void {
    const finger = this.#fingers.get(event.pointerId);
    if (finger === undefined) return;
    const height = this.#canvas.clientHeight;
    const dx = (event.clientX - finger.x) / height;
    const dy = (event.clientY - finger.y) / height;
    if (this.#fingers.size === 1 && this.#doing === undefined) {
      if (Math.abs(dx) * height < sideways || Math.abs(dx) < Math.abs(dy)) return;
      this.#doing = "turn";
    }
    if (this.#fingers.size === 2) this.#pinch(finger, event, height);
    else if (this.#doing === "pull") this.#target.drag(dx, dy);
    else if (this.#doing === "turn") this.#target.moveCamera("rotateVertical", dx, dy);
    else if (this.#doing === "move") this.#target.moveCamera("moveVertical", dx, dy);
    finger.x = event.clientX;
    finger.y = event.clientY;
  }

  /** The middle of two fingers moves, their distance zooms. */
  #pinch(moved: Finger, to: PointerEvent, height: number): void {
    const other = [...this.#fingers.values()].find((finger) => finger !== moved)!;
    const dx = (to.clientX - moved.x) / (2 * height);
    const dy = (to.clientY - moved.y) / (2 * height);
    const before = Math.hypot(moved.x - other.x, moved.y - other.y);
    const after = Math.hypot(to.clientX - other.x, to.clientY - other.y);
    this.#target.moveCamera("moveVertical", dx, dy);
    this.#target.moveCamera("zoom", 0, (after - before) / (2 * height));
  }

  #up({ pointerId }: PointerEvent): void {
    if (this.#fingers.delete(pointerId)) this.#letGo();
  }

  #letGo(): void {
    if (this.#doing === "pull") this.#target.release();
    this.#doing = undefined;
  }

  #wheel(event: WheelEvent): void {
    const ours = event.ctrlKey || event.metaKey || document.activeElement === this.#canvas;
    if (!ours) {
      this.#target.wheelPassed();
      return;
    }
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? pixelsOfWheelStep : 3;
    this.#target.moveCamera("zoom", 0, (-wheelStep * event.deltaY) / lines);
  }

  #place({ clientX, clientY }: PointerEvent): [number, number] {
    const { left, top, width, height } = this.#canvas.getBoundingClientRect();
    return [(clientX - left) / width, (clientY - top) / height];
  }
}

/** Two fingers are for the view, whichever way they go. */
function keepTwoFingers(event: TouchEvent): void {
  if (event.touches.length > 1) event.preventDefault();
}
