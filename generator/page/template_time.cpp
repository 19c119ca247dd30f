#include "page/template_time.h"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace mjcourse {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kOfASite{60'000};
constexpr milliseconds kOfALesson{100};

// The time that all renderers of a site have taken together.
class TimeTaken {
 public:
  explicit TimeTaken(milliseconds allowed) : allowed_(allowed) {}

  void add(const std::string& name, Clock::duration time) {
    const std::lock_guard guard(mutex_);
    all_ += time;
    of_each_[name] += time;
  }

  // Where there is no more: it may be a part of many templates that takes it, so it is a mistake of
  // none of them.
  std::optional<TemplateError> end() const {
    const std::lock_guard guard(mutex_);
    if (all_ <= allowed_) return std::nullopt;
    const auto slowest =
        std::ranges::max_element(of_each_, {}, [](const auto& one) { return one.second; });
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(allowed_).count();
    return TemplateError{"",
                         "the templates of a whole site take more than " + std::to_string(seconds) +
                             " s together, and most of it `" + slowest->first + "`",
                         0, "look there, and in what it includes, for a loop in a loop"};
  }

 private:
  const milliseconds allowed_;
  mutable std::mutex mutex_;
  Clock::duration all_{};
  std::map<std::string, Clock::duration> of_each_;
};

class TimedRenderer : public TemplateRenderer {
 public:
  TimedRenderer(std::unique_ptr<TemplateRenderer> renderer, std::shared_ptr<TimeTaken> taken)
      : renderer_(std::move(renderer)), taken_(std::move(taken)) {}

  tl::expected<std::string, TemplateError> render(const std::string& name,
                                                  const std::string& data) override {
    if (auto end = taken_->end()) return tl::unexpected(*std::move(end));
    const Clock::time_point begun = Clock::now();
    auto html = renderer_->render(name, data);
    taken_->add(name, Clock::now() - begun);
    return html;
  }

 private:
  std::unique_ptr<TemplateRenderer> renderer_;
  std::shared_ptr<TimeTaken> taken_;
};

}  // namespace

milliseconds time_of_templates(std::size_t lessons) {
  return kOfASite + lessons * kOfALesson;
}

RendererOf within(milliseconds time, RendererOf renderer_of) {
  if (!renderer_of) return {};
  auto taken = std::make_shared<TimeTaken>(time);
  return [renderer_of = std::move(renderer_of), taken = std::move(taken)](
             std::map<std::string, std::string> sources) -> std::unique_ptr<TemplateRenderer> {
    return std::make_unique<TimedRenderer>(renderer_of(std::move(sources)), taken);
  };
}

}  // namespace mjcourse
