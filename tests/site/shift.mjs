/** How much of a layout's shift is allowed, as the browser measures it. */
export const mostShifted = 0.02;

/** How far what is in the page has moved since it was loaded, by itself. */
export function shiftOf(page) {
  return page.evaluate(
    () =>
      new Promise((tell) => {
        let sum = 0;
        new PerformanceObserver((list) => {
          for (const entry of list.getEntries()) if (!entry.hadRecentInput) sum += entry.value;
        }).observe({ type: "layout-shift", buffered: true });
        setTimeout(() => tell(sum), 500);
      }),
  );
}
