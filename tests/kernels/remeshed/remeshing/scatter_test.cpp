#include <cmath>

#include "tests/kernels/body.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {
namespace {

/// M4' as in (RP.31).
double kernel(double s) {
  s = std::abs(s);
  if (s < 1) return 1 - 2.5 * s * s + 1.5 * s * s * s;
  return s < 2 ? (1 - s) * (2 - s) * (2 - s) / 2 : 0;
}

/// A body whose particles have drifted by up to 1.4 cells, and the buffer of a tile around it.
template <class T, int D>
struct Tile {
  explicit Tile(Model model) : body(small_box<T, D>(), T(0.1), model) {
    State<T, D>& state = body.states[0];
    jitter(state.drift, T(1.4) * body.patch.spacing, 7);
    jitter(displacement, T(0.3), 8);
    std::mt19937 random(9);
    std::uniform_real_distribution<T> value(-1, 1);
    for (T& phi : level_set) phi = value(random);
    components = material_component_count<D>(model);
    width = node_width_for<D>(components);
    constexpr int margin = 3;
    lower.fill(-margin);
    extent = small_box<T, D>();
    for (std::int32_t& n : extent) n += 2 * margin;
    std::size_t size = width;
    for (const std::int32_t n : extent) size *= n;
    nodes.assign(size, T(0));
    rows = whole_rows<D>(extent);
  }

  void scatter() {
    Scatter<T, D> arguments{body.patch.segments.data(),
                            static_cast<int>(body.patch.segments.size()),
                            body.patch.kind.data(),
                            1 / body.patch.spacing,
                            shift,
                            components,
                            body.mass.data(),
                            level_set.data(),
                            {},
                            std::as_const(body.states[0]).evolving(),
                            nodes.data(),
                            rows.data(),
                            lower,
                            extent};
    for (int i = 0; i < D; ++i) arguments.displacement[i] = displacement[i].data();
    baseline_table<T, D>().scatter(arguments);
  }

  std::vector<double> values(std::int64_t p) const {
    using Value = NodeField<D>;
    const State<T, D>& q = body.states[0];
    std::vector<double> r(node_fields<D>, 0.);
    const double m = body.mass[p], v = q.volume[p];
    r[Value::weight] = 1;
    r[Value::mass] = m;
    r[Value::volume] = v;
    r[Value::level_set] = level_set[p];
    for (int i = 0; i < D; ++i) {
      r[Value::momentum + i] = m * q.velocity[i][p];
      r[Value::displacement + i] = v * (double(displacement[i][p]) + q.drift[i][p]);
    }
    for (int c = 0; c < components; ++c) r[Value::material + c] = v * q.material[c][p];
    return r;
  }

  /// Calls `f(node, cell)` with the values of each node.
  template <class F>
  void for_each_node(F&& f) const {
    std::array<std::int32_t, D> cell = lower;
    for (std::size_t n = 0; n < nodes.size(); n += width) {
      f(&nodes[n], cell);
      for (int i = 0; i < D; ++i) {
        if (++cell[i] < lower[i] + extent[i]) break;
        cell[i] = lower[i];
      }
    }
  }

  Body<T, D> body;
  std::array<Field<T>, D> displacement = filled();
  Field<T> level_set = Field<T>(body.patch.slots), nodes;
  std::vector<NodeRow> rows;
  std::array<std::int32_t, D> shift = {}, lower, extent;
  int components, width;

 private:
  std::array<Field<T>, D> filled() const {
    std::array<Field<T>, D> fields;
    fields.fill(Field<T>(body.patch.slots));
    return fields;
  }
};

template <class T>
class scatter : public testing::Test {};
TYPED_TEST_SUITE(scatter, Dimensions);

TYPED_TEST(scatter, conserves_what_it_carries) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  Tile<T, D> tile(Model::linear);
  tile.scatter();
  const int fields = NodeField<D>::material + tile.components;
  std::vector<double> particles(fields, 0.), nodes(fields, 0.);
  double size = 0;
  tile.body.patch.for_each_interior([&](std::int64_t p, const auto&) {
    const auto r = tile.values(p);
    for (int f = 0; f < fields; ++f) particles[f] += r[f];
    size += 1;
  });
  tile.for_each_node([&](const T* node, const auto&) {
    for (int f = 0; f < fields; ++f) nodes[f] += node[f];
  });
  for (int f = 0; f < fields; ++f) {
    EXPECT_NEAR(nodes[f], particles[f], size * 100 * std::numeric_limits<T>::epsilon()) << f;
  }
}

TYPED_TEST(scatter, agrees_with_a_plain_sum_over_particles) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  for (const Model model : {Model::linear, Model::reduced_polynomial}) {
    Tile<T, D> tile(model);
    for (int i = 0; i < D; ++i) {
      tile.shift[i] = i == 0 ? -5 : 4;  // as in a periodic image; particles leave the buffer
      tile.lower[i] += 2;
    }
    tile.scatter();
    const double h = tile.body.patch.spacing;
    double worst = 0;
    tile.for_each_node([&](const T* node, const auto& cell) {
      std::vector<double> sum(node_fields<D>, 0.);
      tile.body.patch.for_each_interior([&](std::int64_t p, const auto& from) {
        double weight = 1;
        for (int i = 0; i < D; ++i) {
          const double x = from[i] + tile.shift[i] + tile.body.states[0].drift[i][p] / h;
          weight *= kernel(x - cell[i]);
        }
        if (weight == 0) return;
        const auto r = tile.values(p);
        for (int f = 0; f < node_fields<D>; ++f) sum[f] += weight * r[f];
      });
      const int fields = NodeField<D>::material + tile.components;
      for (int f = 0; f < fields; ++f) worst = std::max(worst, std::abs(node[f] - sum[f]));
      for (int f = fields; f < tile.width; ++f) EXPECT_EQ(node[f], 0);
    });
    // The reference rounds cell coordinates up to 60; the kernel keeps fractions separate.
    EXPECT_LT(worst, 1000 * std::numeric_limits<T>::epsilon());
  }
}

TYPED_TEST(scatter, onto_rows_of_different_lengths_finds_the_same_sums) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  Tile<T, D> box(Model::linear), ragged(Model::linear);
  box.scatter();
  std::int64_t first = 0;
  int at = 0;
  for (NodeRow& row : ragged.rows) {
    row.begin = at % 5 == 0 ? 0 : at % 7;  // every fifth row has no nodes
    row.end = at % 5 == 0 ? 0 : row.end - at % 11;
    row.first = first;
    first += row.end - row.begin;
    ++at;
  }
  ragged.scatter();
  for (std::size_t r = 0; r < ragged.rows.size(); ++r) {
    const NodeRow &part = ragged.rows[r], &whole = box.rows[r];
    for (int x = part.begin; x < part.end; ++x) {
      for (int f = 0; f < box.width; ++f) {
        ASSERT_EQ(ragged.nodes[(part.first + x - part.begin) * box.width + f],
                  box.nodes[(whole.first + x) * box.width + f]);
      }
    }
  }
  for (std::size_t n = first * box.width; n < ragged.nodes.size(); ++n) {
    ASSERT_EQ(ragged.nodes[n], 0);
  }
}

TEST(scatter, leaves_out_vacant_slots_and_images) {
  Tile<double, 2> tile(Model::linear);
  for (Kind& kind : tile.body.patch.kind) {
    kind = kind == Kind::interior ? Kind::image : Kind::vacant;
  }
  tile.scatter();
  for (const double value : tile.nodes) EXPECT_EQ(value, 0);
}

}  // namespace
}  // namespace pliant::kernels::test
