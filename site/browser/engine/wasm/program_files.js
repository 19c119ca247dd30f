// The engine's files are those of the reader's program (Module.files, ../../cpp/execution.ts). A lab's
// engine has none: MuJoCo gets its files in memory there.
mergeInto(LibraryManager.library, {
  __syscall_openat: function (folder, path, flags) {
    return Module["files"] ? Module["files"]["open"](path, flags) : -52;
  },
  __syscall_open: function (path, flags) {
    return Module["files"] ? Module["files"]["open"](path, flags) : -52;
  },
  fd_close: function (fd) {
    return Module["files"] ? Module["files"]["fd_close"](fd) : 52;
  },
  fd_read: function (fd, vectors, count, read) {
    return Module["files"] ? Module["files"]["fd_read"](fd, vectors, count, read) : 52;
  },
  fd_write: function (fd, vectors, count, written) {
    return Module["files"] ? Module["files"]["fd_write"](fd, vectors, count, written) : 52;
  },
  fd_seek: function (fd, low, high, whence, place) {
    if (!Module["files"]) return 70;
    // emscripten's minifier does not know the letter n of a BigInt
    var offset = BigInt(high) * BigInt(4294967296) + BigInt(low >>> 0);
    return Module["files"]["fd_seek"](fd, offset, whence, place);
  },
});
