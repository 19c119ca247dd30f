#include <mjcourse/mjcourse.hpp>
#include <random>

using namespace mjcourse;

double helper(double x);  // is there for its reader

// A number whose square is x.
double root(double x) {
  // #region answer
  return helper(x);
  // #starter
  // return 0;
  // #wrong same: the square of f(9) is 9
  // return x;
  // #wrong of-nine: the square of another
  // return helper(9);
  // #wrong changes-its-mind: it is the same each time
  // static int calls = 0;
  // return ++calls % 8 == 0 ? -helper(x) : helper(x);
  // #wrong one-here-one-there: four times the number
  // return x > 4 ? -helper(x) : helper(x);
  // #endregion
}

double helper(double x) {
  return std::sqrt(x);
}

const double kRoot = std::sqrt(2.0);

int main() {
  std::mt19937 random(seed());
  if (!expect_near(root(9) * root(9), 9, 1e-9, "the square of f(9) is 9")) return 0;
  const double x = 1 + std::uniform_real_distribution(0.0, 1.0)(random) * kRoot;
  if (!expect_near(root(x) * root(x), x, 1e-9, "the square of another is another")) return 0;
  // Both roots are right.
  expect_alike(root(4 * x), 2 * root(x), 1e-9, "four times the number is twice the root");
  expect(root(x) == root(x), "it is the same each time");
}
