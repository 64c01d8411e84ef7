#include "engine/total_lagrangian/prestress.hpp"

#include "engine/method/initial_stress.hpp"

namespace pliant::total_lagrangian {

// The initial stress is evaluated at the mean place of a cell's corners.
template <class T, int D>
void prestress(const BodyCase& source, Body<T, D>& body) {
  if (!body.is_prestressed()) return;
  const Layout<D>& layout = body.layout;
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (body.fraction[p] == 0) return;
      Vector middle = {};
      for (const std::int64_t q : body.corners(cell)) {
        const Point<D> x = body.place(q, layout.cell(q));
        for (int a = 0; a < D; ++a) middle[a] += x[a] / (1 << D);
      }
      const auto stress = initial_stress_in<D>(source, middle);
      for (std::size_t c = 0; c < stress.size(); ++c) {
        body.initial_stress[c][p] = static_cast<T>(stress[c]);
      }
    });
  }
}

template void prestress(const BodyCase&, Body<double, 2>&);
template void prestress(const BodyCase&, Body<double, 3>&);
template void prestress(const BodyCase&, Body<float, 2>&);
template void prestress(const BodyCase&, Body<float, 3>&);

}  // namespace pliant::total_lagrangian
