#pragma once

#include <memory>
#include <string>

namespace pliant {

/// A number, or a formula of x, y, z [m] and t [s], as in case files.
///
/// Evaluation is thread-safe: every thread has its own parser.
class Expression {
 public:
  Expression(double constant = 0);
  /// Throws std::invalid_argument with the parser's message when `formula` is not valid.
  explicit Expression(const std::string& formula);
  Expression(const Expression& other);
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression other) noexcept;
  ~Expression();

  double operator()(double x, double y, double z, double t) const;
  double operator()(double t) const { return (*this)(0, 0, 0, t); }

  bool is_constant() const { return parser_ == nullptr; }
  /// Whether the value depends on `variable`: one of x, y, z, t.
  bool uses(char variable) const;
  bool uses_place() const { return uses('x') || uses('y') || uses('z'); }
  const std::string& text() const { return text_; }

 private:
  struct Parser;
  std::string text_;
  double constant_ = 0;
  std::unique_ptr<Parser> parser_;
};

}  // namespace pliant
