#include "page/template_time.h"

#include <gtest/gtest.h>

#include <thread>

namespace mjcourse {
namespace {

using namespace std::chrono_literals;

// Takes a little of the time.
class SlowRenderer : public TemplateRenderer {
 public:
  tl::expected<std::string, TemplateError> render(const std::string& name,
                                                  const std::string& data) override {
    std::this_thread::sleep_for(2ms);
    return name + data;
  }
};

std::unique_ptr<TemplateRenderer> slow(const std::map<std::string, std::string>& /*sources*/) {
  return std::make_unique<SlowRenderer>();
}

TEST(TemplateTime, IsAMinuteAndALittleForEachLesson) {
  EXPECT_EQ(time_of_templates(0), 60s);
  EXPECT_EQ(time_of_templates(100), 70s);
  EXPECT_EQ(time_of_templates(20'000), 2'060s);
}

TEST(TemplateTime, EndsForAllThatRenderASite) {
  const RendererOf renderer_of = within(1ms, slow);
  const auto first = renderer_of({}), second = renderer_of({});
  EXPECT_EQ(first->render("card", "1"), "card1");
  const auto end = second->render("page", "2");
  ASSERT_FALSE(end);
  EXPECT_EQ(end.error().name, "");
  EXPECT_EQ(end.error().message,
            "the templates of a whole site take more than 0 s together, and most of it `card`");
  EXPECT_EQ(end.error().cure, "look there, and in what it includes, for a loop in a loop");
  EXPECT_FALSE(first->render("card", "3"));
}

TEST(TemplateTime, IsEnoughForTemplatesThatRender) {
  const auto renderer = within(time_of_templates(0), slow)({});
  for (int i = 0; i < 10; ++i) EXPECT_EQ(renderer->render("card", "1"), "card1");
}

TEST(TemplateTime, IsNoneWhereNobodyRenders) {
  EXPECT_FALSE(within(1ms, {}));
}

}  // namespace
}  // namespace mjcourse
