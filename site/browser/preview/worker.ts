// The one listener of all tabs of a browser.

import { listen, type News } from "./news.js";

const ports: MessagePort[] = [];
let last: News | undefined;

listen((news) => {
  last = news;
  for (const port of ports) port.postMessage(news);
});

addEventListener("connect", (event) => {
  const [port] = (event as MessageEvent).ports;
  if (!port) return;
  ports.push(port);
  if (last !== undefined) port.postMessage(last);
});
