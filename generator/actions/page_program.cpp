#include "actions/page_program.h"

#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/base64.h"
#include "base/utf8.h"
#include "cache/cbor.h"

namespace mjcourse {
namespace {

using nlohmann::json;

json content(const std::string& bytes) {
  if (find_invalid_utf8(bytes)) return {{"base64", base64(bytes)}};
  return {{"text", bytes}};
}

std::string question_of(const PageProgram& program) {
  json files = json::object();
  for (const auto& [name, bytes] : program.files) files[name] = content(bytes);
  return json{{"main", program.main},
              {"files", std::move(files)},
              {"models", "models"},
              {"arguments", program.arguments}}
      .dump();
}

std::string first_error(const json& diagnostics) {
  for (const json& diagnostic : diagnostics) {
    if (diagnostic.value("severity", "") == "error") return diagnostic.value("message", "");
  }
  return "no word";
}

// As the page's own code answers (site/node/run.ts). Throws json::exception.
PageEnd end_of(const json& answer) {
  PageEnd end;
  if (!answer.at("ok").get<bool>()) {
    end.refusal = first_error(answer.at("diagnostics"));
    return end;
  }
  const json& how = answer.at("end");
  end.how = how.at("how").get<std::string>();
  end.code = how.value("code", 0);
  end.line = how.value("line", 0);
  end.message = how.value("message", "");
  end.out = answer.at("out").get<std::string>();
  end.records = answer.at("records").get<std::string>();
  return end;
}

std::string bytes_of(const PageEnd& end) {
  return to_cbor(
      json::array({end.refusal, end.how, end.code, end.line, end.message, end.out, end.records}));
}

// A store may hold anything.
std::optional<PageEnd> known_end(const std::string& bytes) {
  const std::optional<json> all = from_cbor(bytes);
  if (!all) return std::nullopt;
  try {
    return PageEnd{all->at(0), all->at(1), all->at(2), all->at(3),
                   all->at(4), all->at(5), all->at(6)};
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

}  // namespace

tl::expected<PageEnd, Outcome> run_page_program(const PageProgram& program, double seconds,
                                                const PageToolchain& toolchain,
                                                PageProcess& process, ActionStore& store,
                                                Trace& trace) {
  const std::string question = question_of(program);
  Dependencies recipe = action_recipe("page run", {question});
  recipe.push_back({"page", toolchain.version()});
  if (const auto bytes = store.find(recipe, trace)) {
    if (auto end = known_end(*bytes)) return *std::move(end);
  }
  const auto begin = std::chrono::system_clock::now();
  const auto answer = process.ask(question, seconds);
  if (!answer) return tl::unexpected(answer.error());
  PageEnd end = end_of(json::parse(*answer));
  store.keep(recipe, Trace(trace.root()), begin, bytes_of(end));
  return end;
}

}  // namespace mjcourse
