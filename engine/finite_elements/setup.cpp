#include "engine/finite_elements/setup.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "engine/finite_elements/parameters.hpp"
#include "engine/method/decompositions.hpp"
#include "engine/method/initial_stress.hpp"
#include "engine/point_based/bonds/bonds.hpp"
#include "engine/point_based/setup.hpp"
#include "engine/point_based/surface/surface.hpp"

namespace pliant::finite_elements {

namespace {

using point_based::Body;
using point_based::GivenBonds;

/// [corner][axis]
template <int D>
using Gradients = Eigen::Matrix<double, D + 1, D>;

/// An element; its corners are in the order of their slots.
template <int D>
struct Element {
  std::array<std::int32_t, D + 1> slots;
  Gradients<D> gradient;  ///< of the corners [1/m]
  double volume;          ///< [m^D]
  Eigen::Matrix<double, D, D> stress = Eigen::Matrix<double, D, D>::Zero();  ///< S0 [Pa]
};

template <class T, int D>
Element<D> make_element(const std::array<std::int32_t, D + 1>& slots, const Body<T, D>& body) {
  Element<D> element;
  element.slots = slots;
  std::sort(element.slots.begin(), element.slots.end());
  Eigen::Matrix<double, D, D> edges;
  for (int a = 0; a < D; ++a) {
    for (int i = 0; i < D; ++i) {
      edges(i, a) = body.start[element.slots[a + 1]][i] - body.start[element.slots[0]][i];
    }
  }
  element.gradient.template bottomRows<D>() = edges.inverse();
  element.gradient.row(0) = -element.gradient.template bottomRows<D>().colwise().sum();
  element.volume = std::abs(edges.determinant()) / (D == 2 ? 2 : 6);
  return element;
}

// The mean of a stress that is linear in x is its value at the centre of an element.
template <class T, int D>
void prestress(const BodyCase& source, const Body<T, D>& body, std::vector<Element<D>>& elements) {
  if (!source.stress) return;
  for (Element<D>& element : elements) {
    Vector middle = {};
    for (const std::int32_t slot : element.slots) {
      for (int a = 0; a < D; ++a) middle[a] += body.start[slot][a] / (D + 1);
    }
    const auto stress = initial_stress_in<D>(source, middle);
    for (int i = 0; i < D; ++i) {
      for (int j = 0; j < D; ++j) {
        element.stress(i, j) = stress[kernels::symmetric_index<D>(i, j)];
      }
    }
  }
}

/// The elements of the mesh, in the order of the slots of their corners, and so by blocks.
template <class T, int D>
std::vector<Element<D>> elements_of(const point_based::NodeCloud<D>& cloud,
                                    const Body<T, D>& body) {
  std::vector<std::int32_t> slot_of(cloud.positions.size());
  body.for_each_node(
      [&](std::int64_t slot) { slot_of[body.number[slot]] = static_cast<std::int32_t>(slot); });
  std::vector<Element<D>> elements;
  elements.reserve(cloud.elements.size());
  for (const auto& corners : cloud.elements) {
    std::array<std::int32_t, D + 1> slots;
    for (int a = 0; a <= D; ++a) slots[a] = slot_of[corners[a]];
    elements.push_back(make_element<T, D>(slots, body));
  }
  std::sort(elements.begin(), elements.end(),
            [](const Element<D>& a, const Element<D>& b) { return a.slots < b.slots; });
  return elements;
}

/// Bonds along the edges. Their gradients are the means over the elements at a node, (FE.7).
template <class T, int D>
std::vector<GivenBonds<D>> bonds_along_edges(const std::vector<Element<D>>& elements,
                                             const Body<T, D>& body) {
  std::vector<std::map<std::int32_t, Point<D>>> gradient(body.slots);
  for (const Element<D>& element : elements) {
    for (const std::int32_t node : element.slots) {
      const double share = element.volume / (D + 1) / body.volume[node];
      for (int a = 0; a <= D; ++a) {
        if (element.slots[a] == node) continue;
        Point<D>& g = gradient[node][element.slots[a]];
        for (int j = 0; j < D; ++j) g[j] += share * element.gradient(a, j);
      }
    }
  }
  std::vector<GivenBonds<D>> bonds(body.slots);
  for (std::int64_t slot = 0; slot < body.slots; ++slot) {
    for (const auto& [neighbour, g] : gradient[slot]) {
      bonds[slot].slot.push_back(neighbour);
      bonds[slot].gradient.push_back(g);
    }
  }
  return bonds;
}

/// omega^2 of (FE.6) for one element at rest with its masses at its corners [1/s^2].
template <int D>
double highest_square(const Element<D>& element, const kernels::Material<double>& material) {
  constexpr int size = D * (D + 1);
  const double mu = material.shear_modulus, lambda = material.bulk_modulus - 2. / 3 * mu;
  const Gradients<D>& g = element.gradient;
  Eigen::Matrix<double, size, size> stiffness;
  for (int a = 0; a <= D; ++a) {
    for (int b = 0; b <= D; ++b) {
      const double dot = g.row(a).dot(g.row(b));
      const double taut = g.row(a) * element.stress * g.row(b).transpose();
      for (int i = 0; i < D; ++i) {
        for (int j = 0; j < D; ++j) {
          stiffness(D * a + i, D * b + j) = lambda * g(a, i) * g(b, j) +
                                            mu * (g(a, j) * g(b, i) + (i == j ? dot : 0)) +
                                            (i == j ? taut : 0);
        }
      }
    }
  }
  return largest_eigenvalue(stiffness) * (D + 1) / material.density;
}

template <class T, int D>
void store(const Element<D>& element, std::int64_t number, const Body<T, D>& body,
           const point_based::NodeBlock& block, Elements<T, D>& elements) {
  constexpr int lanes = kernels::slots_per_pack;
  const std::int64_t pack = number / lanes, lane = number % lanes;
  for (int a = 0; a <= D; ++a) {
    const std::int64_t local = body.local_number(block, element.slots[a]);
    elements.corner[(pack * (D + 1) + a) * lanes + lane] =
        static_cast<std::uint16_t>(kernels::point_stride * local);
  }
  T* const shape = &elements.shape[pack * kernels::element_values<D> * lanes + lane];
  for (int a = 1; a <= D; ++a) {
    for (int j = 0; j < D; ++j) {
      shape[((a - 1) * D + j) * lanes] = static_cast<T>(element.gradient(a, j));
    }
  }
  shape[D * D * lanes] = static_cast<T>(element.volume);
  if (elements.is_prestressed()) {
    for (int i = 0; i < D; ++i) {
      for (int j = i; j < D; ++j) {
        const int component = kernels::symmetric_index<D>(i, j);
        elements.initial_stress[elements.stress_place(number, component)] =
            static_cast<T>(element.stress(i, j));
      }
    }
  }
  elements.slots[number] = element.slots;
}

// Packs are padded with elements of zero volume at the first node of their block.
template <class T, int D>
void store_in_blocks(const std::vector<Element<D>>& all, const Body<T, D>& body,
                     Elements<T, D>& elements) {
  constexpr int lanes = kernels::slots_per_pack;
  std::vector<std::size_t> begin = {0};
  std::int64_t count = 0;
  for (const point_based::NodeBlock& block : body.blocks) {
    std::size_t end = begin.back();
    while (end < all.size() && all[end].slots[0] < block.first + block.count) ++end;
    const auto own = static_cast<int>(end - begin.back());
    elements.blocks.push_back({count, (own + lanes - 1) / lanes * lanes});
    count += elements.blocks.back().count;
    begin.push_back(end);
  }
  elements.corner.grow(count * (D + 1), 0);
  elements.shape.grow(count * kernels::element_values<D>, T(0));
  if (body.is_prestressed()) {
    elements.initial_stress.grow(count * kernels::symmetric_components<D>, T(0));
  }
  elements.slots.resize(count);
  for (std::size_t b = 0; b < body.blocks.size(); ++b) {
    for (std::size_t e = begin[b]; e < begin[b + 1]; ++e) {
      const auto number = elements.blocks[b].first + static_cast<std::int64_t>(e - begin[b]);
      store(all[e], number, body, body.blocks[b], elements);
    }
  }
}

template <class T, int D>
void set_material(const Body<T, D>& body, Elements<T, D>& elements) {
  elements.material = body.material;
  elements.volumetric_modulus = body.material.lame_modulus;
  elements.material.lame_modulus = 0;
  if (body.material.law == kernels::ElasticLaw::reduced_polynomial) {
    elements.volumetric_modulus = 2 / body.material.polynomial.compressibility;
    elements.material.polynomial.compressibility = std::numeric_limits<T>::infinity();
  }
}

}  // namespace

template <class T, int D>
void make_body(const Case& settings, const BodyCase& source, const Boundaries<D>& boundaries,
               Body<T, D>& body, Elements<T, D>& elements) {
  const point_based::PlacedNodes<D> nodes =
      point_based::place_nodes<D>(settings, source, boundaries);
  point_based::make_nodes(settings, source, nodes, boundaries,
                          point_based::PressureForces::of_loads, body);
  std::vector<Element<D>> all = elements_of(nodes.cloud, body);
  prestress(source, body, all);
  point_based::make_bonds(bonds_along_edges(all, body), body);
  point_based::make_loads(boundaries, body);
  store_in_blocks(all, body, elements);
  set_material(body, elements);
  double square = 0;
  for (const Element<D>& element : all) {
    square = std::max(square, highest_square<D>(element, source.material));
  }
  elements.highest_frequency = std::sqrt(square);
  if (parameters_of(settings).pressure == ElementPressure::averaged) {
    elements.pressure.grow(body.slots, T(0));
  }
}

template void make_body(const Case&, const BodyCase&, const Boundaries<2>&, Body<double, 2>&,
                        Elements<double, 2>&);
template void make_body(const Case&, const BodyCase&, const Boundaries<3>&, Body<double, 3>&,
                        Elements<double, 3>&);
template void make_body(const Case&, const BodyCase&, const Boundaries<2>&, Body<float, 2>&,
                        Elements<float, 2>&);
template void make_body(const Case&, const BodyCase&, const Boundaries<3>&, Body<float, 3>&,
                        Elements<float, 3>&);

}  // namespace pliant::finite_elements
