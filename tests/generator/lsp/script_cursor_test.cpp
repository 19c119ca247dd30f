#include "lsp/script_cursor.h"

#include <gtest/gtest.h>

#include <chrono>

namespace mjcourse {
namespace {

std::string text_of(std::string_view before) {
  const auto cursor = script_cursor(before);
  if (!cursor) return "";
  return (cursor->kind == ScriptCursor::Kind::field ? "field of " : "name for ") + cursor->of +
         ": " + cursor->part;
}

TEST(ScriptCursor, NamesAField) {
  EXPECT_EQ(text_of("data."), "field of data: ");
  EXPECT_EQ(text_of("x = 2*data.qp"), "field of data: qp");
  EXPECT_EQ(text_of("model.opt.time"), "field of model.opt: time");
  EXPECT_EQ(text_of("model.vis.global.fo"), "field of model.vis.global: fo");
  EXPECT_EQ(text_of("data->qp"), "field of data: qp");
  EXPECT_EQ(text_of("other.qp"), "");
  EXPECT_EQ(text_of("mydata.qp"), "");
  EXPECT_EQ(text_of("data"), "");
  EXPECT_EQ(text_of("1."), "");
}

TEST(ScriptCursor, NamesAnObject) {
  EXPECT_EQ(text_of("qpos('"), "name for qpos: ");
  EXPECT_EQ(text_of("a = body(\"bo"), "name for body: bo");
  EXPECT_EQ(text_of("qpos('a')[0] + qvel('b"), "name for qvel: b");
  EXPECT_EQ(text_of("qpos('a')"), "");
  EXPECT_EQ(text_of("'text"), "");
  EXPECT_EQ(text_of("('text"), "");
}

// 4 MB; a path that is put together from its end on takes many minutes.
TEST(ScriptCursor, TakesALongPath) {
  std::string text = "model";
  for (int i = 0; i < 1'000'000; ++i) text += i % 2 == 0 ? ".x" : "->xx";
  const auto began = std::chrono::steady_clock::now();
  const auto cursor = script_cursor(text);
  ASSERT_TRUE(cursor);
  EXPECT_TRUE(cursor->of.starts_with("model.x.xx.x.xx.") && cursor->of.ends_with(".xx.x"));
  EXPECT_EQ(cursor->part, "xx");
  EXPECT_FALSE(field_at(text, text.size()));
  EXPECT_FALSE(script_cursor("other." + text));
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(60));
}

TEST(FieldAt, IsCalledAsInTheHeaders) {
  const auto name = [](std::string_view text, std::size_t offset) {
    const auto field = field_at(text, offset);
    return field ? field->name : "";
  };
  EXPECT_EQ(name("data.qpos[0]", 7), "mjData.qpos");
  EXPECT_EQ(name("data.qpos[0]", 9), "mjData.qpos");
  EXPECT_EQ(name("data.qpos[0]", 2), "");
  EXPECT_EQ(name("mj_step(m, data->qvel)", 19), "mjData.qvel");
  EXPECT_EQ(name("model.opt.timestep", 12), "mjOption.timestep");
  EXPECT_EQ(name("model.stat.extent", 12), "mjStatistic.extent");
  EXPECT_EQ(name("model.vis.global.fovy", 18), "mjVisual.global.fovy");
  EXPECT_EQ(name("", 0), "");
  EXPECT_EQ(name("data.", 5), "");
}

}  // namespace
}  // namespace mjcourse
