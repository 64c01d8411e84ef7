#include "engine/total_lagrangian/prestress.hpp"

#include "engine/geometry/padded.hpp"
#include "engine/method/initial_stress.hpp"
#include "engine/total_lagrangian/stress_point.hpp"

namespace pliant::total_lagrangian {

template <class T, int D>
void prestress(const BodyCase& source, Body<T, D>& body) {
  if (!body.is_prestressed()) return;
  const Layout<D>& layout = body.layout;
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (body.fraction[p] == 0) return;
      const Vector place = padded<D>(stress_point_place<T, D>(body, p, cell));
      const auto stress = initial_stress_in<D>(source, place);
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
