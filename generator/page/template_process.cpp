#include "page/template_process.h"

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/temporary_folder.h"
#include "process/open_to_all.h"
#include "process/process_supervisor.h"
#include "process/question_stream.h"
#include "script/script_bundles.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// As long as the longest preview, for a limit of the kernel's when nobody is left to look.
constexpr double kLifetime = 30 * 24 * 3600;
// Of one answer, as JSON: the engine itself ends a template after 10 s.
constexpr double kSeconds = 30;
constexpr std::size_t kMostAnswer = 512 << 20;
constexpr std::uint64_t kMemory = 512ull << 20;

// JSON has no place for what is no text; a page has none either.
std::string as_text(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

class TemplateProcess : public TemplateRenderer {
 public:
  TemplateProcess(fs::path program, fs::path assets, std::map<std::string, std::string> sources)
      : program_(std::move(program)), assets_(std::move(assets)), sources_(std::move(sources)) {}

  tl::expected<std::string, TemplateError> render(const std::string& name,
                                                  const std::string& data) override {
    auto running = std::move(running_);
    if (!running) running = std::make_unique<Running>(command());
    json question{{"name", name}, {"data", data}};
    if (!std::exchange(running->knows_sources, true)) question["sources"] = sources_;
    const auto answer = running->supervisor.ask(as_text(question), kSeconds);
    if (!answer) return tl::unexpected(end_of(name, answer.error()));
    // It may have been taken over, and say anything.
    const json said = json::parse(*answer, nullptr, false);
    if (said.is_string()) {
      running_ = std::move(running);
      return said.get<std::string>();
    }
    try {
      TemplateError error{said.at("name"), said.at("message"), said.at("line"), said.at("cure")};
      running_ = std::move(running);
      return tl::unexpected(std::move(error));
    } catch (const json::exception&) {
      throw std::runtime_error("the process that renders templates gave no answer");
    }
  }

 private:
  struct Running {
    explicit Running(Command its_command)
        : command(std::move(its_command)), supervisor(in_folder(command, folder)) {}

    static const Command& in_folder(Command& command, const TemporaryFolder& folder) {
      command.folder = folder.path();
      command.sandbox->write = {folder.path()};
      return command;
    }

    TemporaryFolder folder;
    Command command;
    ProcessSupervisor supervisor;
    bool knows_sources = false;
  };

  Command command() const {
    Command command;
    command.arguments = {program_.string(), kRenderCommand, assets_.string()};
    command.seconds = kLifetime;
    command.output_bytes = kMostAnswer;
    command.answers = true;
    Sandbox sandbox;
    sandbox.read = {program_.string(), assets_.string()};
    for (const std::string& path : sandbox.read) {
      if (!can_be_read_by_all(path)) sandbox.reads_all = true;
    }
    sandbox.processes = true;  // so that its memory is counted, and not what the engine reserves
    sandbox.reserves = true;
    sandbox.memory_bytes = kMemory;
    sandbox.open_files = 256;
    command.sandbox = std::move(sandbox);
    return command;
  }

  static TemplateError end_of(const std::string& name, const Outcome& outcome) {
    using End = Outcome::End;
    const char* const cure = "look for a loop in a loop, and for a template of many parts";
    switch (outcome.end) {
      case End::timed_out:
        return {name, "takes more than 30 s", 0, cure};
      case End::exhausted:
        return {name, "takes more than 512 MiB of memory", 0, cure};
      case End::flooded:
        return {name, "makes more than 512 MiB of a page", 0, cure};
      default:
        return {
            name,
            "ended the process that renders it: " + outcome.err.substr(0, outcome.err.find('\n')),
            0, cure};
    }
  }

  fs::path program_, assets_;
  std::map<std::string, std::string> sources_;
  std::unique_ptr<Running> running_;
};

}  // namespace

RendererOf renderer_of(const ThemedAssets& themed, const fs::path& program,
                       const fs::path& assets) {
  if (!themed.is_themed() || program.empty()) return {};
  return [program, assets](std::map<std::string, std::string> sources) {
    return std::make_unique<TemplateProcess>(program, assets, std::move(sources));
  };
}

void render_templates(const Files& assets) {
  const QuestionStream questions;
  std::optional<TemplateEngine> engine;
  while (const auto text = questions.next()) {
    const json question = json::parse(*text);
    if (question.contains("sources")) {
      engine.emplace(script_bundle(assets, "templates"),
                     question.at("sources").get<std::map<std::string, std::string>>());
    }
    const auto html = engine.value().render(question.at("name"), question.at("data"));
    const json answer = html ? json(*html)
                             : json{{"name", html.error().name},
                                    {"message", html.error().message},
                                    {"line", html.error().line},
                                    {"cure", html.error().cure}};
    if (!questions.answer(as_text(answer))) return;
  }
}

}  // namespace mjcourse
