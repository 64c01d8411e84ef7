#include "engine/case/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>
#include <tbb/enumerable_thread_specific.h>
#include <pliant/error.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace pliant {

namespace {

/// A parser keeps its variables.
struct FormulaOfThread {
  explicit FormulaOfThread(const std::string& formula) {
    parser.DefineVar("x", &x);
    parser.DefineVar("y", &y);
    parser.DefineVar("z", &z);
    parser.DefineVar("t", &t);
    parser.DefineConst("pi", std::numbers::pi);
    parser.SetExpr(formula);
  }

  double x = 0, y = 0, z = 0, t = 0;
  mu::Parser parser;
};

/// Replaces muParser's messages, which count from zero and differ in style.
std::string explain(const mu::ParserError& error) {
  const std::string& token = error.GetToken();
  const int position = error.GetPos() + 1;
  switch (error.GetCode()) {
    case mu::ecUNASSIGNABLE_TOKEN:
      return fmt::format("unknown name `{}` at position {}", token, position);
    case mu::ecUNEXPECTED_EOF:
      return "it ends where a value is expected";
    case mu::ecEMPTY_EXPRESSION:
      return "it is empty";
    case mu::ecMISSING_PARENS:
      return "a closing parenthesis is missing";
    case mu::ecTOO_MANY_PARAMS:
      return fmt::format("too many arguments of `{}` before position {}", token, position);
    case mu::ecEXPRESSION_TOO_LONG:
      return fmt::format("it is longer than {} characters", mu::MaxLenExpression);
    case mu::ecIDENTIFIER_TOO_LONG:
      return fmt::format("it holds a name of more than {} characters", mu::MaxLenIdentifier);
    case mu::ecTOO_FEW_PARAMS:
      return fmt::format("too few arguments of `{}` before position {}", token, position);
    default:
      return fmt::format("unexpected `{}` at position {}", token, position);
  }
}

/// muParser would accept `x = 1` as an assignment to its own variable.
void refuse_assignment(const std::string& formula) {
  for (std::size_t i = formula.find('='); i != std::string::npos; i = formula.find('=', i + 1)) {
    const bool closes = i > 0 && std::string("=<>!").find(formula[i - 1]) != std::string::npos;
    const bool opens = i + 1 < formula.size() && formula[i + 1] == '=';
    if (!closes && !opens) {
      throw std::invalid_argument(
          fmt::format("`=` at position {} assigns; equality is written `==`", i + 1));
    }
  }
}

[[noreturn]] void refuse_value(const mu::Parser& parser, const std::string& formula) {
  std::string place;
  for (const auto& [name, variable] : parser.GetUsedVar()) {
    place += fmt::format("{}{} = {:.6g}", place.empty() ? "" : ", ", name, *variable);
  }
  throw RunError(fmt::format(
      "the formula \"{}\" has no finite value at {}; give one that has a value wherever "
      "and whenever it acts",
      formula, place));
}

/// Sets up the parser; it already checks the length of the formula and its names.
template <class Parser>
std::unique_ptr<Parser> parse(const std::string& formula) {
  try {
    auto parser = std::make_unique<Parser>(formula);
    parser->present();
    return parser;
  } catch (const mu::ParserError& error) {
    throw std::invalid_argument(explain(error));
  }
}

}  // namespace

struct Expression::Parser {
  explicit Parser(const std::string& formula) : of_thread(formula) {}

  mu::Parser& present() { return of_thread.local().parser; }

  tbb::enumerable_thread_specific<FormulaOfThread> of_thread;  ///< parsed where first used
};

Expression::Expression(double constant) : text_(fmt::format("{}", constant)), constant_(constant) {}

Expression::Expression(const std::string& formula)
    : text_(formula), parser_(parse<Parser>(formula)) {
  refuse_assignment(formula);
  try {
    constant_ = parser_->present().Eval();
    if (parser_->present().GetNumResults() > 1) {
      throw std::invalid_argument("several values separated by commas, where one is expected");
    }
    if (!parser_->present().GetUsedVar().empty()) return;
  } catch (const mu::ParserError& error) {
    throw std::invalid_argument(explain(error));
  }
  if (!std::isfinite(constant_)) throw std::invalid_argument("its value is not finite");
  parser_.reset();
}

Expression::Expression(const Expression& other)
    : text_(other.text_),
      constant_(other.constant_),
      parser_(other.parser_ ? std::make_unique<Parser>(other.text_) : nullptr) {}

Expression::Expression(Expression&&) noexcept = default;

Expression& Expression::operator=(Expression other) noexcept {
  std::swap(text_, other.text_);
  std::swap(constant_, other.constant_);
  std::swap(parser_, other.parser_);
  return *this;
}

Expression::~Expression() = default;

double Expression::operator()(double x, double y, double z, double t) const {
  if (!parser_) return constant_;
  FormulaOfThread& formula = parser_->of_thread.local();
  formula.x = x;
  formula.y = y;
  formula.z = z;
  formula.t = t;
  const double value = formula.parser.Eval();
  if (!std::isfinite(value)) refuse_value(formula.parser, text_);
  return value;
}

bool Expression::uses(char variable) const {
  return parser_ && parser_->present().GetUsedVar().contains(std::string(1, variable));
}

}  // namespace pliant
