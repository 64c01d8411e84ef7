#pragma once

#include "engine/case/case.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/lattice/lattice.hpp"

namespace pliant {

/// The acceleration by the body force of a case (RP.71).
template <int D>
class Gravity {
 public:
  explicit Gravity(const Case& settings) : formula_(settings.gravity) {
    for (int a = 0; a < D; ++a) {
      const Expression& g = formula_[a];
      acts_ = acts_ || !g.is_constant() || g(0) != 0;
      is_uniform_ = is_uniform_ && !g.uses_place();
    }
  }

  bool acts() const { return acts_; }
  bool is_uniform() const { return is_uniform_; }

  /// Gravity at one time [m/s^2].
  class Now {
   public:
    Now(const Gravity& gravity, double t)
        : formula_(gravity.formula_), t_(t), is_uniform_(gravity.is_uniform_) {
      if (is_uniform_ && gravity.acts_) uniform_ = evaluate({});
    }
    Point<D> operator()(const Point<D>& x) const { return is_uniform_ ? uniform_ : evaluate(x); }

   private:
    Point<D> evaluate(const Point<D>& x) const {
      const Vector at = padded<D>(x);
      Point<D> g;
      for (int a = 0; a < D; ++a) g[a] = formula_[a](at[0], at[1], at[2], t_);
      return g;
    }

    const VectorExpression& formula_;
    double t_;
    bool is_uniform_;
    Point<D> uniform_ = {};
  };

 private:
  VectorExpression formula_;
  bool acts_ = false, is_uniform_ = true;
};

}  // namespace pliant
