#include "report/file_edits.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

Diagnostic with_edit(Edit edit) {
  Diagnostic diagnostic = error_at({}, "E-test", "wrong");
  diagnostic.edit = std::move(edit);
  return diagnostic;
}

const MemoryFiles kFiles({{"a", "0123456789"}, {"b", "old"}});

FileEdits gathered(const Diagnostics& diagnostics) {
  std::vector<const Diagnostic*> wanted;
  for (const Diagnostic& one : diagnostics) wanted.push_back(&one);
  return gather_edits(wanted, kFiles);
}

TEST(FileEdits, AreMadeTogetherInOneFile) {
  const Diagnostics all{
      with_edit({"a", Span{2, 4}, "two three", "x"}), with_edit({"b", std::nullopt, "new", "y"}),
      with_edit({"a", Span{8, 9}, "", "z"}), with_edit({"a", Span{0, 0}, "start ", "w"})};
  const FileEdits edits = gathered(all);
  ASSERT_EQ(edits.files.size(), 2u);
  EXPECT_TRUE(edits.refused.empty());
  EXPECT_EQ(edits.files[0].before, "0123456789");
  EXPECT_EQ(edits.files[0].after, "start 01two three45679");
  EXPECT_EQ(edits.files[0].cures.size(), 3u);
  EXPECT_EQ(edits.files[1].after, "new");
}

TEST(FileEdits, MakeAFileThatIsNotThere) {
  const Diagnostics all{with_edit({"c", std::nullopt, "new", "x"})};
  const FileEdits edits = gathered(all);
  ASSERT_EQ(edits.files.size(), 1u);
  EXPECT_EQ(edits.files[0].before, std::nullopt);
  EXPECT_EQ(edits.files[0].after, "new");
}

TEST(FileEdits, TakeTheSameEditOnce) {
  const Diagnostics all{with_edit({"a", Span{2, 4}, "x", "one"}),
                        with_edit({"a", Span{2, 4}, "x", "two"})};
  const FileEdits edits = gathered(all);
  ASSERT_EQ(edits.files.size(), 1u);
  EXPECT_EQ(edits.files[0].after, "01x456789");
}

// What is in the way of two edits.
std::string refusal(Edit one, Edit other) {
  const Diagnostics all{with_edit(std::move(one)), with_edit(std::move(other))};
  const FileEdits edits = gathered(all);
  EXPECT_TRUE(edits.files.empty());
  EXPECT_EQ(edits.refused.size(), 2u);
  return edits.refused.empty() ? "" : edits.refused[0].cure;
}

TEST(FileEdits, RefuseTwoOfTheSameBytes) {
  const std::string cure = "several fences want different text in a: make them say the same first";
  EXPECT_EQ(refusal({"a", Span{2, 5}, "x", ""}, {"a", Span{4, 6}, "y", ""}), cure);
  EXPECT_EQ(refusal({"a", Span{4, 4}, "x", ""}, {"a", Span{4, 4}, "y", ""}), cure);
  EXPECT_EQ(refusal({"a", std::nullopt, "x", ""}, {"a", Span{4, 4}, "y", ""}), cure);
  EXPECT_EQ(refusal({"a", Span{2, 11}, "x", ""}, {"a", Span{0, 1}, "y", ""}), cure);
}

TEST(FileEdits, RefuseThoseOfAFileThatIsNotAsItWasRead) {
  EXPECT_EQ(refusal({"a", Span{2, 3}, "x", "", "012"}, {"a", Span{4, 5}, "y", ""}),
            "a was changed while the course was evaluated: accept again");
}

}  // namespace
}  // namespace mjcourse
