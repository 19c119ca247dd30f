// PlotRenderer in tests: specs and tables in a few words, and what is wrong with them in one text.
#pragma once

#include <gtest/gtest.h>

#include "bundle.h"
#include "script/plot_renderer.h"

namespace mjcourse {

class PlotRendererTest : public testing::Test {
 protected:
  using json = nlohmann::json;

  // A spec with `more` members beside a line of `y` over `x`.
  static std::string line(const std::string& more = "", const std::string& of_y = "") {
    return R"({"data": {"name": "a/b"}, "caption": "c", "alt": "d", "mark": "line")" + more +
           R"(, "encoding": {"x": {"field": "x", "type": "quantitative"},
               "y": {"field": "y", "type": "quantitative")" +
           of_y + "}}}";
  }

  static json table(const std::vector<double>& x, const std::vector<double>& y) {
    return json::array({json::array({"x", x}), json::array({"y", y})});
  }

  // "id path message | cure" of each fault; "" for none.
  std::string faults(const std::string& spec, const json& table) {
    const auto drawn = renderer_.draw(spec, table, "plot-1");
    std::string text;
    for (const PlotFault& fault : drawn ? std::vector<PlotFault>{} : drawn.error()) {
      const std::string part =
          fault.to > 0 ? "[" + std::to_string(fault.from) + "," + std::to_string(fault.to) + "]"
                       : "";
      text += fault.id + " " + fault.path.dump() + (fault.key ? " key" : "") + part + " " +
              fault.message + (fault.cure.empty() ? "" : " | " + fault.cure) + "\n";
    }
    return text;
  }
  std::string faults(const std::string& spec) { return faults(spec, table_); }

  PlotRenderer renderer_{bundle("plot")};
  json table_ = table({0, 1, 2}, {-1, 0.5, 3e-7});
};

}  // namespace mjcourse
