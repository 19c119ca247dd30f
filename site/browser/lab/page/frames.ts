/** One loop of animation frames for all labs of a page. A lab that has nothing to show asks for no
 * frame, and the page is at rest. */

export type FrameListener = (now: number) => void;

let waiting: FrameListener[] = [];

/** Calls the listener in the next frame; asking again before that changes nothing. */
export function askFrame(listener: FrameListener): void {
  if (waiting.includes(listener)) return;
  if (waiting.length === 0) requestAnimationFrame(frame);
  waiting.push(listener);
}

function frame(now: number): void {
  const listeners = waiting;
  waiting = [];
  for (const listener of listeners) listener(now);
}
