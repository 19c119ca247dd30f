#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "lesson/guide_table.h"
#include "lesson/json/json_fences.h"
#include "reading_of.h"

namespace mjcourse {
namespace {

std::string object_with_all(const Vocabulary& vocabulary, std::string_view word);

// Values that `key` may have: one for each form that it takes.
std::vector<std::string> samples_of(const Key& key, std::string_view word) {
  const double least = key.limits.least == kAboveZero ? 0.5 : key.limits.least;
  const std::string number = key.limits.text.empty() ? "1" : std::to_string(least);
  switch (key.kind) {
    case KeyKind::text:
    case KeyKind::markdown:
    case KeyKind::model:
    case KeyKind::expression:
      return {"\"a/b\""};
    case KeyKind::script:
    case KeyKind::mjcf:
      return {"\"1\"", R"(["1", "2"])"};
    case KeyKind::word:
      return {'"' + std::string(word) + '"'};
    case KeyKind::number:
    case KeyKind::whole:
      return {number};
    case KeyKind::boolean:
      return {"true"};
    case KeyKind::tolerance:
      return {"0.5", "\"1%\""};
    case KeyKind::point:
      return {"[0, 0, 1]"};
    case KeyKind::size:
      return {"[320, 200]"};
    case KeyKind::indices:
      return {"[0]"};
    case KeyKind::texts:
    case KeyKind::expressions:
      return {R"(["1", "2"])"};
    case KeyKind::overlays:
      return {R"({"joints": true})"};
    case KeyKind::object:
      return {object_with_all(*key.of, "")};
    case KeyKind::objects:
    case KeyKind::texts_or_objects: {
      if (key.of->variants.empty()) {
        const std::string one = object_with_all(*key.of, "");
        return {key.kind == KeyKind::objects ? "[" + one + "]" : "[" + one + ", \"another\"]"};
      }
      std::string all;
      for (const Variant& variant : key.of->variants) {
        all += (all.empty() ? "" : ", ") + object_with_all(*variant.vocabulary, variant.word);
      }
      return {"[" + all + "]"};
    }
    case KeyKind::true_or_object:
      return {"true", object_with_all(*key.of, "")};
  }
  return {};
}

// Its keys are all there, each in the last of its forms.
std::string object_with_all(const Vocabulary& vocabulary, std::string_view word) {
  std::string text;
  for (const Key& key : vocabulary.keys) {
    text += (text.empty() ? "{\"" : ", \"") + std::string(key.name) +
            "\": " + samples_of(key, word).back();
  }
  return text + "}";
}

// The ids of what the generator minds in a fence.
std::set<std::string> ids_in(const JsonFence& fence, const std::string& body) {
  std::set<std::string> ids;
  const std::string text = "```" + std::string(fence.opened) + "\n" + body + "\n```\n";
  for (const Diagnostic& diagnostic : reading_of(text).diagnostics) ids.insert(diagnostic.id);
  return ids;
}

// What is minded is what several keys say together, and never a key or its kind. That a reader asks
// for every word, JsonObject sees to.
TEST(Vocabulary, HasNoWordThatItsReaderRefuses) {
  for (const JsonFence& fence : json_fences()) {
    const std::string body = object_with_all(*fence.vocabulary, "");
    for (const std::string& id : ids_in(fence, body)) {
      EXPECT_TRUE(id != "E-json-key" && id != "E-json-kind" && id != "E-json-missing" &&
                  id != "E-json-syntax")
          << id << " in " << body;
    }
  }
}

TEST(Vocabulary, HasEveryFormThatAReaderTakes) {
  for (const JsonFence& fence : json_fences()) {
    for (const Key& key : fence.vocabulary->keys) {
      for (const std::string& sample : samples_of(key, "")) {
        const std::string body = "{\"" + std::string(key.name) + "\": " + sample + "}";
        const std::set<std::string> ids = ids_in(fence, body);
        EXPECT_FALSE(ids.contains("E-json-key") || ids.contains("E-json-kind")) << body;
      }
    }
  }
}

// `visit` each vocabulary below `vocabulary` and itself.
template <typename Visit>
void walk(const Vocabulary& vocabulary, const Visit& visit) {
  visit(vocabulary);
  for (const Variant& variant : vocabulary.variants) walk(*variant.vocabulary, visit);
  for (const Key& key : vocabulary.keys) {
    if (key.of != nullptr) walk(*key.of, visit);
  }
}

TEST(Vocabulary, SaysOfEachKeyWhatItMeans) {
  int keys = 0;
  for (const JsonFence& fence : json_fences()) {
    walk(*fence.vocabulary, [&](const Vocabulary& vocabulary) {
      std::set<std::string_view> names;
      for (const Key& key : vocabulary.keys) {
        ++keys;
        const std::string_view meaning = key.meaning;
        EXPECT_TRUE(names.insert(key.name).second) << key.name << " twice in " << vocabulary.name;
        EXPECT_TRUE(meaning.ends_with('.') || meaning.ends_with("`.")) << key.name;
        EXPECT_EQ(meaning.find('\n'), meaning.npos) << key.name;
        const Limits none;
        const bool limited = key.kind == KeyKind::whole || key.limits.least > none.least ||
                             key.limits.most < none.most;
        EXPECT_TRUE(!limited || !key.limits.text.empty()) << key.name << " of " << vocabulary.name;
        const bool whole_of_others = key.kind == KeyKind::object || key.kind == KeyKind::objects ||
                                     key.kind == KeyKind::texts_or_objects ||
                                     key.kind == KeyKind::true_or_object;
        EXPECT_EQ(key.of != nullptr, whole_of_others) << key.name << " of " << vocabulary.name;
      }
    });
  }
  EXPECT_GT(keys, 100);
}

std::vector<std::string> sorted_keys(const Vocabulary& vocabulary) {
  std::vector<std::string> names;
  for (const Key& key : vocabulary.keys) names.emplace_back(key.name);
  std::sort(names.begin(), names.end());
  return names;
}

const Vocabulary& within(const Vocabulary& vocabulary, std::string_view key) {
  return *vocabulary.find(key)->of;
}

// What a table of the guide says of keys: which there are, and which must be there.
void expect_keys(const std::vector<GuideRow>& rows, const Vocabulary& vocabulary) {
  EXPECT_EQ(names_of(rows), sorted_keys(vocabulary));
  for (const GuideRow& row : rows) {
    for (const std::string& name : row.names) {
      const Key* key = vocabulary.find(name);
      const bool required = row.words.ends_with("; required |");
      EXPECT_EQ(required, key != nullptr && key->need != Need::none) << name;
    }
  }
}

TEST(Vocabulary, HasItsKeysInTheGuidesTables) {
  constexpr const char* kHead = "| key | value |";
  constexpr const char* kFigures = "A.7-figures-and-plots.md";
  expect_keys(guide_table("A.5-labs.md", kHead), *vocabulary_of("lab"));
  expect_keys(guide_table(kFigures, kHead), *vocabulary_of("figure"));
  std::vector<GuideRow> plot = guide_table(kFigures, kHead, "## A plot");
  EXPECT_TRUE(plot.back().names.empty()) << "Vega-Lite's keys";
  plot.pop_back();
  expect_keys(plot, *vocabulary_of("plot"));
}

TEST(Vocabulary, OfAProofStandsInTheGuidesTables) {
  std::vector<GuideRow> rows = guide_table("A.6-questions.md", "| first, one of | the build |");
  for (GuideRow& row : guide_table("A.6-questions.md", "| then | means |")) rows.push_back(row);
  for (const Variant& kind : within(*vocabulary_of("quiz"), "questions").variants) {
    EXPECT_EQ(names_of(rows), sorted_keys(within(*kind.vocabulary, "verify"))) << kind.word;
  }
}

TEST(Vocabulary, OfAControlStandsInTheGuidesTable) {
  const std::vector<GuideRow> rows = guide_table("A.5-labs.md", "| type | keys besides `label` |");
  const Vocabulary& controls = within(*vocabulary_of("lab"), "controls");
  EXPECT_EQ(rows.size(), controls.variants.size());
  for (const GuideRow& row : rows) {
    const Vocabulary* control = controls.variant(row.names.at(0));
    ASSERT_NE(control, nullptr) << row.names[0];
    const std::vector<std::string> said = code_in(row.words);
    for (const Key& key : control->keys.subspan(2)) {  // behind `type` and `label`
      EXPECT_NE(std::count(said.begin(), said.end(), key.name), 0)
          << key.name << " of " << row.names[0];
    }
  }
}

TEST(Vocabulary, OfVariantsIsChosenByTheFirstKey) {
  for (const JsonFence& fence : json_fences()) {
    walk(*fence.vocabulary, [](const Vocabulary& vocabulary) {
      for (const Variant& variant : vocabulary.variants) {
        ASSERT_EQ(vocabulary.keys.size(), 1u);
        EXPECT_EQ(vocabulary.keys[0].kind, KeyKind::word);
        EXPECT_EQ(variant.vocabulary->keys[0].name, vocabulary.keys[0].name);
        EXPECT_EQ(vocabulary.variant(variant.word), variant.vocabulary);
      }
      EXPECT_EQ(vocabulary.variant("frobnicate"), nullptr);
    });
  }
}

TEST(Vocabulary, IsFoundByItsFence) {
  ASSERT_NE(vocabulary_of("lab"), nullptr);
  ASSERT_NE(vocabulary_of("lab")->find("height"), nullptr);
  EXPECT_EQ(vocabulary_of("lab")->find("height")->limits.most, 1024);
  EXPECT_EQ(vocabulary_of("lab")->find("hieght"), nullptr);
  EXPECT_EQ(vocabulary_of("text"), nullptr);
}

}  // namespace
}  // namespace mjcourse
