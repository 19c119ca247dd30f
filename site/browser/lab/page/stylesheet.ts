/** The stylesheet that comes with the lab's code: one for all labs of a page. */

const worn = new Map<string, Promise<void>>();

/** Until the stylesheet at `address` is in force. It is asked for again after it failed. */
export function wear(address: string): Promise<void> {
  const known = worn.get(address);
  if (known !== undefined) return known;
  const link = document.createElement("link");
  link.rel = "stylesheet";
  link.href = address;
  const arrived = new Promise<void>((resolve, reject) => {
    link.onload = () => resolve();
    link.onerror = () => {
      link.remove();
      worn.delete(address);
      reject(new Error(`${address} did not arrive`));
    };
  });
  document.head.append(link);
  worn.set(address, arrived);
  return arrived;
}
