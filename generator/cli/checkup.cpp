#include "cli/checkup.h"

#include <mujoco/mujoco.h>

#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "base/folder_size.h"
#include "base/temporary_folder.h"
#include "cli/size.h"
#include "evaluate/versions.h"
#include "physics/renderer.h"
#include "process/find_program.h"
#include "process/our_command.h"
#include "process/sandbox.h"
#include "process/subprocess.h"
#include "remote/server_checkup.h"
#include "toolchain/compiler.h"
#include "toolchain/containment.h"
#include "toolchain/toolchain.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using Grade = Sign::Grade;

constexpr std::uintmax_t kEnoughSpace = 1'000'000'000;  // bytes

// It says its version, which must be that of the headers that we were compiled with.
constexpr const char* kProgram =
    "#include <mujoco/mujoco.h>\n#include <cstdio>\n"
    "int main() { std::printf(\"%s\", mj_versionString()); }\n";

Sign mujoco() {
  const std::string version = mj_versionString();
  if (mj_version() == mjVERSION_HEADER) return {"MuJoCo", Grade::good, version, ""};
  return {"MuJoCo", Grade::missing,
          "the library is " + version + ", and the headers are of another version",
          "install both from one place: `apt-get install libmujoco-dev`, and build mjcourse again"};
}

// Compiles and runs a program as a lesson's.
Sign compiler() {
  const auto cure = [] {
    return "`apt-get install " + compiler_package() + " mold libmujoco-dev libeigen3-dev`";
  };
  const std::optional<Compiler> found = Compiler::find({}, std::nullopt);
  if (!found) return {"compiler", Grade::missing, "none: no program can be run", cure()};
  const TemporaryFolder folder;
  const fs::path source = folder.path() / "program.cpp", binary = folder.path() / "program";
  write_file(source, kProgram);
  const Compiled compiled = found->compile(source, binary, folder.path());
  if (!compiled.succeeded) {
    const std::string why = compiled.stopped.empty() ? compiled.raw : compiled.stopped;
    return {"compiler", Grade::missing,
            found->version() + " cannot compile: " + why.substr(0, why.find('\n')), cure()};
  }
  Command command;
  command.arguments = {binary.string()};
  command.folder = folder.path() / "run";
  fs::create_directory(command.folder);
  command.sandbox = program_sandbox(binary, command.folder, {}, folder.path());
  const Outcome outcome = run(command);
  if (outcome.end != Outcome::End::exited || outcome.out != mj_versionString()) {
    return {"compiler", Grade::missing, found->version() + " makes programs that do not run",
            cure()};
  }
  const Toolchain& toolchain = found->toolchain();
  if (!toolchain.is_clang() || !toolchain.has_mold) {
    return {
        "compiler", Grade::slow,
        found->version() + (toolchain.has_mold ? ", mold" : ", no mold") + ": programs take longer",
        "`apt-get install " + compiler_package() + " mold`"};
  }
  return {"compiler", Grade::good, found->version() + ", mold", ""};
}

Sign pictures() {
  const char* const cure = "`apt-get install libosmesa6`";
  tl::expected<Renderer, std::string> renderer = Renderer::create();
  if (!renderer) return {"pictures", Grade::missing, renderer.error(), cure};
  auto model = load_model_text("<mujoco><worldbody><geom size='1'/></worldbody></mujoco>");
  const Simulation simulation(std::move(model.value()));
  const auto picture = renderer->render(simulation, {}, {}, {16, 16});
  if (!picture) return {"pictures", Grade::missing, picture.error(), cure};
  return {"pictures", Grade::good, "drawn by OSMesa, which needs no screen and no GPU", ""};
}

Sign films() {
  if (!find_program("ffmpeg").empty()) return {"films", Grade::good, "made by ffmpeg", ""};
  return {"films", Grade::missing, "no ffmpeg: no figure can move", "`apt-get install ffmpeg`"};
}

Sign site(const fs::path& assets) {
  const auto text = DiskFiles(assets).read("manifest.json");
  if (!text) {
    return {"site", Grade::missing, "its scripts and styles were not built: " + text.error(),
            "build them: `./mjcourse build`"};
  }
  const Versions versions = known_versions(DiskFiles(assets));
  if (!nlohmann::json::parse(*text).contains("engine.wasm")) {
    return {"site", Grade::slow, "no engine for the browser: labs are pictures in the page",
            "`apt-get install emscripten`, then `./mjcourse build` with a network"};
  }
  return {"site", Grade::good, "engine " + versions.engine + ", KaTeX " + versions.katex, ""};
}

Sign sandbox() {
  const SandboxLevel& level = sandbox_level();
  if (level.landlock == 0) {
    return {"sandbox", Grade::missing, level.text() + ": nothing of a course is run",
            "a kernel from 5.13 on that has Landlock turned on (`lsm=landlock,...`)"};
  }
  const std::string weakness = level.weakness();
  if (weakness.empty()) return {"sandbox", Grade::good, level.text(), ""};
  return {"sandbox", Grade::slow, level.text() + "; weaker than on the newest kernels: " + weakness,
          level.filter ? "a newer kernel" : "a machine or container that allows seccomp"};
}

Sign cache(const fs::path& store) {
  if (store.empty()) {
    return {"store", Grade::slow, "none: every run starts from nothing",
            "give HOME or XDG_CACHE_HOME a folder that can be written, or use --store DIR"};
  }
  FolderSize size;
  add_size(store.string(), UINT64_MAX, size);
  std::error_code error;
  fs::path there = store;  // or will be, with the first result
  while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
  const fs::space_info space = fs::space(there, error);
  const std::string state = store.string() + ", " + size_text(size.bytes);
  if (error || space.available < kEnoughSpace) {
    return {"store", Grade::slow,
            state + (error ? ": " + error.message() : "; " + size_text(space.available) + " free"),
            "make room, or " + our_command("store prune --keep 200MB")};
  }
  return {"store", Grade::good, state + "; " + size_text(space.available) + " free", ""};
}

}  // namespace

std::vector<Sign> examine(const fs::path& assets, const fs::path& store) {
  return {mujoco(), compiler(), pictures(), films(), site(assets), sandbox(), cache(store)};
}

std::optional<Sign> examine_shared(const fs::path& assets, SharedPlace place) {
  const auto server = named_server(place);
  if (server && !*server) return std::nullopt;
  if (!server) {
    return Sign{"shared", Grade::slow, server.error(),
                "mend it, or unset it; all works without it"};
  }
  const std::string at = (*server)->address.shown();
  const auto sign = [&](Grade grade, const std::string& state, std::string cure = "") {
    return Sign{"shared", grade, at + ": " + state, std::move(cure)};
  };
  try {
    const bool puts = !place.read_only;
    const ServerCheckup found = examine_server(assets / "net" / "mjcourse-net", **server, puts);
    if (!found.trouble.empty()) {
      return sign(
          Grade::slow, found.trouble,
          "is that its address, is it up, and is MJCOURSE_STORE_TOKEN or ~/.netrc right? All "
          "works without it");
    }
    char times[64];
    std::snprintf(times, sizeof times, "HTTP/%s, answers in %.1f ms",
                  found.protocol == 2 ? "2" : "1.1", found.milliseconds);
    if (!puts) return sign(Grade::good, std::string(times) + "; is read, and nothing is put there");
    if (!found.takes) {
      return sign(Grade::slow, std::string(times) + "; takes nothing: " + found.refusal,
                  found.forbids ? "use --store-read-only, or a token that may write"
                                : "its log says why: must its folder belong to the user that it "
                                  "runs as?");
    }
    const std::string heads = found.tells ? "" : "; does not answer HEAD, so all is put again";
    const std::string most = size_text(found.largest);
    if (found.largest == kLargestTried) {
      return sign(Grade::good, std::string(times) + "; is read and written, " + most +
                                   " at once and perhaps more" + heads);
    }
    return sign(
        Grade::slow,
        std::string(times) + "; takes no more than " + most + " at once: " + found.refusal + heads,
        "let it take 100 MB: films are large (nginx: `client_max_body_size`)");
  } catch (const std::system_error& error) {
    return sign(Grade::slow, error.what(), "install mjcourse again, or build it again");
  }
}

}  // namespace mjcourse
