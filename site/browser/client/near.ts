// What is done for something on the page once the reader comes near it.

// Ahead of what is in sight, in pixels.
const near = "300px";

/** Once, and never for what nobody comes near. */
export function whenNear(element: Element, act: () => void): void {
  const observer = new IntersectionObserver(
    ([entry]) => {
      if (!entry?.isIntersecting) return;
      observer.disconnect();
      act();
    },
    { rootMargin: near },
  );
  observer.observe(element);
}
