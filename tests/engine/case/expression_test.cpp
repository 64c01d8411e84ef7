#include "engine/case/expression.hpp"

#include <gtest/gtest.h>
#include <pliant/error.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace pliant {
namespace {

double value(const std::string& formula, double x = 0, double y = 0, double z = 0, double t = 0) {
  return Expression(formula)(x, y, z, t);
}

TEST(expression, a_number_is_a_constant) {
  const Expression number(0.1);
  EXPECT_TRUE(number.is_constant());
  EXPECT_EQ(number(3, 4, 5, 6), 0.1);
  EXPECT_EQ(number.text(), "0.1");
}

TEST(expression, formulas_see_place_and_time) {
  EXPECT_EQ(value("x + 10*y + 100*z + 1000*t", 1, 2, 3, 4), 4321);
  EXPECT_EQ(value("-25*y", 0, 0.5), -12.5);
}

// The same double arithmetic as in the C library: equal up to the last bits.
TEST(expression, functions_are_those_of_the_c_library) {
  EXPECT_DOUBLE_EQ(value("sin(2*pi*x)", 0.1), std::sin(2 * std::numbers::pi * 0.1));
  EXPECT_DOUBLE_EQ(value("cosh(x) - sinh(x)", 0.5), std::cosh(0.5) - std::sinh(0.5));
  EXPECT_DOUBLE_EQ(value("exp(-x)*sqrt(2)", 0.5), std::exp(-0.5) * std::sqrt(2.0));
  EXPECT_EQ(value("max(abs(x), min(y, 3))", -2, 7), 3);
}

TEST(expression, comparisons_give_one_or_zero) {
  EXPECT_EQ(value("abs(y) < 0.6*(1 - 25*t)", 0, 0.5, 0, 0), 1);
  EXPECT_EQ(value("abs(y) < 0.6*(1 - 25*t)", 0, 0.5, 0, 0.02), 0);
  EXPECT_EQ(value("x > 0 && y > 0 || t > 0", 1, -1, 0, 0), 0);
  EXPECT_EQ(value("x >= 1 ? 5 : 7", 1), 5);
}

TEST(expression, a_formula_without_variables_is_a_constant) {
  EXPECT_TRUE(Expression("sqrt(pi/800)").is_constant());
  EXPECT_FALSE(Expression("0*x").is_constant());
}

TEST(expression, it_knows_what_it_depends_on) {
  const Expression formula("3*t + y");
  EXPECT_TRUE(formula.uses('t'));
  EXPECT_TRUE(formula.uses('y'));
  EXPECT_FALSE(formula.uses('x'));
  EXPECT_FALSE(Expression(2.0).uses('x'));
}

TEST(expression, several_threads_evaluate_one_formula) {
  const Expression formula("x + 10*y + 100*z + 1000*t");
  std::array<int, 4> right = {};
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k) {
    threads.emplace_back([&, k] {
      for (int i = 0; i < 10'000; ++i) right[k] += formula(k, i, 2, 3) == k + 10 * i + 3200;
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const int count : right) EXPECT_EQ(count, 10'000);
}

TEST(expression, a_value_that_is_not_finite_is_refused_where_it_occurs) {
  const Expression formula("sqrt(0.5 - t) + 1/y");
  EXPECT_EQ(formula(7, 1, 0, 0.25), 1.5);
  const auto complaint = [&](double y, double t) -> std::string {
    try {
      formula(7, y, 0, t);
      return "";
    } catch (const RunError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(complaint(1, 0.75),
            "the formula \"sqrt(0.5 - t) + 1/y\" has no finite value at t = 0.75, y = 1; give one "
            "that has a value wherever and whenever it acts");
  EXPECT_NE(complaint(0, 0), "");
}

TEST(expression, copies_evaluate_by_themselves) {
  Expression original("x*x");
  Expression copy = original;
  original = Expression("x + 1");
  EXPECT_EQ(copy(3, 0, 0, 0), 9);
  EXPECT_EQ(original(3, 0, 0, 0), 4);
  const Expression moved = std::move(copy);
  EXPECT_EQ(moved(4, 0, 0, 0), 16);
}

struct WrongFormula {
  const char* formula;
  const char* message;
};

class WrongFormulas : public testing::TestWithParam<WrongFormula> {};

TEST_P(WrongFormulas, are_explained) {
  try {
    const Expression formula{std::string(GetParam().formula)};
    FAIL() << GetParam().formula << " was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), GetParam().message);
  }
}

INSTANTIATE_TEST_SUITE_P(
    expression, WrongFormulas,
    testing::Values(WrongFormula{"2*yy", "unknown name `yy` at position 3"},
                    WrongFormula{"sine(x)", "unknown name `sine` at position 1"},
                    WrongFormula{"sin(x", "a closing parenthesis is missing"},
                    WrongFormula{"x)", "unexpected `)` at position 2"},
                    WrongFormula{"2*", "it ends where a value is expected"},
                    WrongFormula{"x**2", "unexpected `*` at position 3"},
                    WrongFormula{"2 x", "unexpected `x` at position 3"},
                    WrongFormula{"", "it is empty"},
                    WrongFormula{"1,2",
                                 "several values separated by commas, where one is expected"},
                    WrongFormula{"x = 1", "`=` at position 3 assigns; equality is written `==`"},
                    WrongFormula{"1/0", "its value is not finite"},
                    WrongFormula{"sin(x, 2)", "too many arguments of `sin` before position 9"}));

}  // namespace
}  // namespace pliant
