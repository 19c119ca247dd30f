#include "evaluate/answers/proof_text.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

Proof with_joints(const std::map<std::string, int>& joints) {
  Proof proof;
  proof.joints = joints;
  return proof;
}

TEST(ProofText, HasTenDigitsOfANumber) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(1.0 / 3), "0.3333333333");
  EXPECT_EQ(number_text(-2.5e-7), "-2.5e-07");
  EXPECT_EQ(number_text(1e20), "1e+20");
}

TEST(ProofText, HasAllOfAWholeNumber) {
  EXPECT_EQ(number_text(123456789012345), "123456789012345");
  EXPECT_EQ(number_text(-0.0), "-0");
  EXPECT_EQ(number_text(7), "7");
}

TEST(ProofText, HasAsManyDigitsAsTellTwoNumbersApart) {
  EXPECT_EQ(number_text(0.5, 0.25), "0.5");
  EXPECT_EQ(number_text(0.3333333333, 1.0 / 3), "0.3333333333");
  EXPECT_EQ(number_text(1.0 / 3, 0.3333333333), "0.33333333333");
  EXPECT_EQ(number_text(0.1 + 0.2, 0.3), "0.30000000000000004");
  EXPECT_EQ(number_text(0.3, 0.1 + 0.2), "0.29999999999999999");
}

TEST(ProofText, ListsWords) {
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed({"a"}), "a");
  EXPECT_EQ(listed({"a", "b"}), "a and b");
  EXPECT_EQ(listed({"a", "b", "c"}), "a, b and c");
}

TEST(ProofText, NamesJointsInMujocosOrder) {
  EXPECT_EQ(built_text(with_joints({{"free", 3}, {"hinge", 7}, {"slide", 2}})),
            "7 hinge, 2 slide and 3 free joints");
  EXPECT_EQ(built_text(with_joints({{"ball", 1}})), "1 ball joint");
  EXPECT_EQ(built_text(with_joints({{"hinge", 1}, {"ball", 1}})), "1 hinge and 1 ball joints");
  EXPECT_EQ(built_text(with_joints({{"hinge", 0}})), "no joints");
  EXPECT_EQ(built_model(with_joints({{"ball", 1}})), "a model with 1 ball joint");
  EXPECT_EQ(built_model(Proof()), "a model with no joints");
}

TEST(ProofText, NamesWhatIsAsked) {
  Proof proof;
  proof.model.text = "pick_place";
  EXPECT_EQ(built_text(proof), "pick_place");
  EXPECT_EQ(built_model(proof), "pick_place.xml");
  proof.example.text = "l1_2_say";
  EXPECT_EQ(built_text(proof), "l1_2_say");
  EXPECT_EQ(built_model(proof), "l1_2_say.cpp");
  Proof written;
  written.mjcf.text = "<mujoco/>";
  EXPECT_EQ(built_text(written), "the model in the question");
  EXPECT_EQ(built_model(written), "the model in the question");
}

}  // namespace
}  // namespace mjcourse
