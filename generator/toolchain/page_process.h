// PageProcess: a process that compiles and runs programs as a reader's page does.
//
// Enter with ask(). The process begins with the first question, and stays, since its compiler is
// quick once it is warm; after one that ended, there is a new one. It is confined as programs are,
// and reads nothing but its own: question and answer have all of a program
// (site/node/questions.ts).
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "process/subprocess.h"
#include "toolchain/page_toolchain.h"

namespace mjcourse {

class PageProcess {
 public:
  // The toolchain must outlive this.
  explicit PageProcess(const PageToolchain& toolchain);
  ~PageProcess();
  PageProcess(const PageProcess&) = delete;
  PageProcess& operator=(const PageProcess&) = delete;

  // The answer; or how the process ended, or that it took longer than `seconds`. Throws Cancelled,
  // and std::runtime_error where nothing can be asked.
  tl::expected<std::string, Outcome> ask(std::string_view question, double seconds);

  // Seconds that all questions together took.
  double asked() const { return asked_; }

 private:
  class Running;

  const PageToolchain& toolchain_;
  std::unique_ptr<Running> running_;
  double asked_ = 0;
};

}  // namespace mjcourse
