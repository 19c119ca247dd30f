// The servers that a shared store may be behind, each started on loopback, in a folder of its own: the
// two of Debian's that take WebDAV's PUT, and one of ours that does what no server should.

import { execFileSync, spawn } from "node:child_process";
import { randomBytes } from "node:crypto";
import { globSync, mkdirSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { connect, createServer as createSocket } from "node:net";
import { join } from "node:path";
import { setTimeout as pause } from "node:timers/promises";

export const token = randomBytes(16).toString("hex");

export async function freePort() {
  const server = createSocket().listen(0, "127.0.0.1");
  await new Promise((done) => server.on("listening", done));
  const { port } = server.address();
  await new Promise((done) => server.close(done));
  return port;
}

async function listens(where) {
  for (let i = 0; i < 100; ++i) {
    const socket = connect(where);
    const is = await new Promise((done) => {
      socket.on("connect", () => done(true)).on("error", () => done(false));
    });
    socket.destroy();
    if (is) return;
    await pause(50);
  }
  throw new Error(`nothing listens at ${JSON.stringify(where)}`);
}

async function started(program, words, where) {
  const child = spawn(program, words, { stdio: ["ignore", "inherit", "inherit"] });
  await listens(where);
  const gone = new Promise((done) => child.on("exit", done));
  return async () => {
    child.kill("SIGTERM");
    await gone;
  };
}

// The names of a store's entries below `folder`.
const entriesIn = (folder) => globSync("{ac,cas}/*", { cwd: folder }).sort();

function dataFolder(folder) {
  const data = join(folder, "data");
  for (const kind of ["ac", "cas"]) mkdirSync(join(data, kind), { recursive: true });
  return data;
}

async function nginxWith(folder, listen, more, where) {
  const data = dataFolder(folder);
  const config = join(folder, "nginx.conf");
  const user = process.getuid() === 0 ? "user root;" : "";
  const temporary = ["client_body", "proxy", "fastcgi", "uwsgi", "scgi"]
    .map((kind) => `${kind}_temp_path ${folder}/${kind};`)
    .join("\n  ");
  writeFileSync(
    config,
    `${user}
daemon off;
worker_processes 1;
pid ${folder}/pid;
events {}
http {
  access_log off;
  client_max_body_size 1g;
  ${temporary}
  server {
    listen ${listen};
    ${more}
    location / {
      root ${data};
      dav_methods PUT;
      create_full_put_path on;
    }
  }
}
`,
  );
  const stop = await started("nginx", ["-e", join(folder, "log"), "-c", config], where);
  return { stop, entries: () => entriesIn(data), data };
}

export async function nginxAt(address, folder) {
  const port = await freePort();
  const server = await nginxWith(folder, `${address}:${port}`, "", { port, host: "127.0.0.1" });
  return { ...server, port, url: `http://127.0.0.1:${port}`, environment: {} };
}

export const nginx = async (folder) => nginxAt("127.0.0.1", folder);

export async function nginxAtSocket(folder) {
  const path = join(folder, "socket");
  const server = await nginxWith(folder, `unix:${path}`, "", { path });
  return { ...server, url: `unix:${path}`, environment: {} };
}

// By TLS, with a certificate of its own, and HTTP/2; only for those who have the token.
export async function nginxWithToken(folder) {
  const port = await freePort();
  const [certificate, key] = ["certificate.pem", "key.pem"].map((name) => join(folder, name));
  mkdirSync(folder, { recursive: true });
  execFileSync(
    "openssl",
    [
      ...["req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", "/CN=localhost"],
      ...["-addext", "subjectAltName=DNS:localhost", "-out", certificate, "-keyout", key],
    ],
    { stdio: "ignore" },
  );
  const more = `ssl_certificate ${certificate};
    ssl_certificate_key ${key};
    if ($http_authorization != "Bearer ${token}") { return 401; }`;
  const listen = `127.0.0.1:${port} ssl http2`;
  const server = await nginxWith(folder, listen, more, { port, host: "127.0.0.1" });
  return {
    ...server,
    url: `https://localhost:${port}`,
    environment: { MJCOURSE_STORE_AUTHORITIES: certificate, MJCOURSE_STORE_TOKEN: token },
  };
}

// Before another server: cuts one connection in ten, before what is asked or instead of an answer.
export async function haproxy(folder, { port: behind }) {
  const port = await freePort();
  mkdirSync(folder, { recursive: true });
  const config = join(folder, "haproxy.cfg");
  writeFileSync(
    config,
    `defaults
  mode http
  timeout connect 5s
  timeout client 5s
  timeout server 5s
frontend front
  bind 127.0.0.1:${port}
  http-request reject if { rand(100) lt 5 }
  http-response silent-drop if { rand(200) lt 1 }
  default_backend back
backend back
  tcp-response inspect-delay 1s
  tcp-response content reject if { rand(100) lt 5 }
  server nginx 127.0.0.1:${behind}
`,
  );
  const stop = await started("haproxy", ["-db", "-q", "-f", config], { port, host: "127.0.0.1" });
  return { stop, url: `http://127.0.0.1:${port}`, environment: {} };
}

export async function lighttpd(folder) {
  const port = await freePort();
  const data = dataFolder(folder);
  const config = join(folder, "lighttpd.conf");
  writeFileSync(
    config,
    `server.modules = ("mod_webdav")
server.document-root = "${data}"
server.bind = "127.0.0.1"
server.port = ${port}
server.errorlog = "${folder}/log"
server.upload-dirs = ("${folder}")
webdav.activate = "enable"
webdav.is-readonly = "disable"
`,
  );
  const stop = await started("/usr/sbin/lighttpd", ["-D", "-f", config], {
    port,
    host: "127.0.0.1",
  });
  const url = `http://127.0.0.1:${port}`;
  return { stop, entries: () => entriesIn(data), data, url, environment: {} };
}

// A server that keeps what is put in memory, and answers as `answer` says: that gets the request, the
// bytes that are there and a number for each request, and gives a status and bytes; nothing for no
// answer at all.
export async function strange(answer) {
  const kept = new Map();
  let requests = 0;
  const server = createServer(async (request, response) => {
    const pieces = [];
    for await (const piece of request) pieces.push(piece);
    const sent = Buffer.concat(pieces);
    const name = request.url.slice(1);
    const found = kept.get(name);
    const usual =
      request.method === "PUT" ? { status: 201 } : { status: found ? 200 : 404, bytes: found };
    const given = await answer(
      { method: request.method, headers: request.headers, name, found, kept, sent, usual },
      ++requests,
    );
    if (given === undefined) return void response.destroy();
    const { status, bytes = Buffer.alloc(0), length = bytes.length } = given;
    if (request.method === "PUT" && status < 300) kept.set(name, sent);
    response.writeHead(status, { "content-length": length });
    if (request.method === "HEAD") return void response.end();
    if (length === bytes.length) return void response.end(bytes);
    response.write(bytes, () => response.destroy());
  });
  server.listen(0, "127.0.0.1");
  await new Promise((done) => server.on("listening", done));
  const url = `http://127.0.0.1:${server.address().port}`;
  const stop = async () => {
    server.closeAllConnections();
    await new Promise((done) => server.close(done));
  };
  return { stop, url, kept, requests: () => requests };
}
