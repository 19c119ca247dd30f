#include "page/html/formula_text.h"

#include <gtest/gtest.h>

#include "script/bundle.h"
#include "script/typeset.h"

namespace mjcourse {
namespace {

class FormulaText : public testing::Test {
 protected:
  std::string of(const std::string& tex) {
    return formula_text(typesetter_.typeset(tex, false).value());
  }

  Typesetter typesetter_{bundle("typeset")};
};

TEST_F(FormulaText, HasLettersAboveAndBelow) {
  EXPECT_EQ(of("x^2"), "x²");
  EXPECT_EQ(of("n_q = 7"), "n_q = 7");
  EXPECT_EQ(of("q_{i+1}^{-1}"), "qᵢ₊₁⁻¹");
  EXPECT_EQ(of("J^T f"), "Jᵀf");
  EXPECT_EQ(of("v_{t+h}"), "vₜ₊ₕ");
  EXPECT_EQ(of("e^{a b + c}"), "e^(ab + c)");
}

TEST_F(FormulaText, HasSigns) {
  EXPECT_EQ(of("a \\le -b + 2"), "a ≤ −b + 2");
  EXPECT_EQ(of("f(x, y)"), "f(x, y)");
  EXPECT_EQ(of("\\dot q"), "q̇");
  EXPECT_EQ(of("\\hat{\\mathbf n}"), "n̂");
  EXPECT_EQ(of("\\sin\\theta"), "sin θ");
}

TEST_F(FormulaText, HasFractionsAndRootsInALine) {
  EXPECT_EQ(of("\\frac{1}{2}"), "1/2");
  EXPECT_EQ(of("\\frac{a}{b + 1}"), "a/(b + 1)");
  EXPECT_EQ(of("\\sqrt{1 - x^2}"), "√(1 − x²)");
  EXPECT_EQ(of("\\begin{pmatrix}1 & 0\\\\0 & 1\\end{pmatrix}"), "(1, 0; 0, 1)");
  EXPECT_EQ(of("9.81\\,\\text{m/s}^2"), "9.81 m/s²");
}

TEST_F(FormulaText, TellsWhatMayBeWiderThanAPhone) {
  EXPECT_FALSE(is_wide_formula(typesetter_.typeset("n_q = 7", false).value()));
  EXPECT_FALSE(is_wide_formula(typesetter_.typeset("\\mathbf{\\ddot{q}}", false).value()));
  EXPECT_TRUE(is_wide_formula(
      typesetter_.typeset("\\frac{a + b + c + d + e + f + g + h}{2}", false).value()));
  EXPECT_FALSE(is_wide_formula(typesetter_.typeset("a\\quad b\\hspace{8em} c", false).value()));
  EXPECT_TRUE(is_wide_formula(typesetter_.typeset("a\\hspace{12em} b", false).value()));
}

TEST_F(FormulaText, IsEmptyWithoutMathml) {
  EXPECT_EQ(formula_text("<span>x</span>"), "");
  EXPECT_EQ(formula_text(""), "");
}

}  // namespace
}  // namespace mjcourse
