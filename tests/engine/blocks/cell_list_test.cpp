#include "engine/blocks/cell_list.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <utility>

namespace pliant {
namespace {

template <class T, int D>
struct Region {
  std::array<T, D> extent, period;
  T radius;
};

/// Label and image of everything within the search radius of a position.
template <class T, int D>
using Found = std::set<std::pair<std::int32_t, std::array<T, D>>>;

template <class T, int D>
std::vector<Site<T, D>> random_sites(const Region<T, D>& region, int count) {
  std::mt19937 random(7);
  std::vector<Site<T, D>> sites(count);
  for (int i = 0; i < count; ++i) {
    sites[i].label = i;
    for (int a = 0; a < D; ++a) {
      sites[i].position[a] = std::uniform_real_distribution<T>(0, region.extent[a])(random);
    }
  }
  return sites;
}

template <class T, int D>
T squared_distance(const std::array<T, D>& at, const Site<T, D>& site,
                   const std::array<T, D>& shift) {
  T sum = 0;
  for (int a = 0; a < D; ++a) {
    const T d = site.position[a] + shift[a] - at[a];
    sum += d * d;
  }
  return sum;
}

template <class T, int D>
Found<T, D> found_by_trying_all(const Region<T, D>& region, const std::vector<Site<T, D>>& sites,
                                const std::array<T, D>& at) {
  Found<T, D> found;
  std::array<int, D> most = {}, periods;
  for (int a = 0; a < D; ++a) {
    if (region.period[a] > 0) {
      most[a] = static_cast<int>(std::ceil(region.radius / region.period[a])) + 1;
    }
  }
  for (const Site<T, D>& site : sites) {
    for (int a = 0; a < D; ++a) periods[a] = -most[a];
    while (true) {
      std::array<T, D> shift;
      for (int a = 0; a < D; ++a) shift[a] = static_cast<T>(periods[a]) * region.period[a];
      if (squared_distance<T, D>(at, site, shift) < region.radius * region.radius) {
        found.emplace(site.label, shift);
      }
      int a = 0;
      while (a < D && ++periods[a] > most[a]) {
        periods[a] = -most[a];
        ++a;
      }
      if (a == D) break;
    }
  }
  return found;
}

template <class T, int D>
CellList<T, D> list_of(const Region<T, D>& region, const std::vector<Site<T, D>>& sites) {
  CellList<T, D> list;
  list.cover({}, region.extent, region.period, region.radius, sites.size());
  list.sort(sites.size(), [&](auto&& f) {
    for (const Site<T, D>& site : sites) f(site);
  });
  return list;
}

template <class T, int D>
void expect_all_found(const Region<T, D>& region, const std::vector<Site<T, D>>& sites) {
  const CellList<T, D> list = list_of(region, sites);
  EXPECT_LE(list.bins(), sites.size());
  for (const Site<T, D>& site : sites) {
    Found<T, D> found;
    list.any_near(site.position, [&](const Site<T, D>& q, const std::array<T, D>& shift) {
      if (squared_distance<T, D>(site.position, q, shift) < region.radius * region.radius) {
        EXPECT_TRUE(found.emplace(q.label, shift).second) << "found twice";
      }
      return false;
    });
    ASSERT_EQ(found, (found_by_trying_all<T, D>(region, sites, site.position)));
  }
}

template <class T, int D>
void expect_all_found(const Region<T, D>& region) {
  expect_all_found(region, random_sites<T, D>(region, 300));
}

template <class T>
struct CellListOf : testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(CellListOf, Scalars);

TYPED_TEST(CellListOf, finds_all_sites_within_the_radius) {
  using T = TypeParam;
  expect_all_found<T, 2>({{20, 13}, {}, T(2.6)});
  expect_all_found<T, 3>({{7, 9, 8}, {}, T(1.8)});
  expect_all_found<T, 2>({{T(2e-3), T(1.3e-3)}, {}, T(2.6e-4)});
}

TYPED_TEST(CellListOf, finds_images_across_periods) {
  using T = TypeParam;
  expect_all_found<T, 2>({{20, 13}, {20, 0}, T(2.6)});
  expect_all_found<T, 2>({{20, 13}, {20, 13}, T(2.6)});
  expect_all_found<T, 3>({{7, 9, 8}, {7, 0, 8}, T(1.8)});
}

TYPED_TEST(CellListOf, finds_images_across_periods_of_any_length) {
  using T = TypeParam;
  expect_all_found<T, 2>({{T(0.37), T(1.1)}, {T(0.37), 0}, T(0.11)});
  expect_all_found<T, 3>({{T(0.37), T(1.1), T(0.2)}, {T(0.37), T(1.1), T(0.2)}, T(0.3)});
}

TYPED_TEST(CellListOf, passes_short_periods_more_than_once) {
  using T = TypeParam;
  expect_all_found<T, 2>({{2, 30}, {2, 30}, T(2.6)});
  expect_all_found<T, 2>({{1, 4}, {1, 4}, T(2.6)});
}

TEST(cell_list, points_far_from_the_others_cost_no_memory) {
  const Region<double, 2> region = {{20, 13}, {}, 2.6};
  auto sites = random_sites(region, 300);
  sites[5].position = {1e9, 3};
  sites[6].position = {4, 1e12};
  expect_all_found<double, 2>({{1e9, 1e12}, {}, 2.6}, sites);
}

TEST(cell_list, stops_at_the_first_that_counts) {
  const Region<double, 2> region = {{20, 13}, {}, 2.6};
  const auto list = list_of(region, random_sites(region, 300));
  int calls = 0;
  EXPECT_TRUE(list.any_near({10, 6}, [&](const auto&, const auto&) { return ++calls == 3; }));
  EXPECT_EQ(calls, 3);
}

TEST(cell_list, sites_carry_any_label_and_keep_their_order) {
  struct Label {
    const char* name;
    int number;
  };
  using List = CellList<double, 2, Label>;
  const std::vector<List::Site> sites = {
      {{1, 1}, {"a", 1}}, {{9, 9}, {"far", 2}}, {{1, 1}, {"b", 3}}};
  List list;
  list.cover({0, 0}, {9, 9}, {}, 1, sites.size());
  list.sort(sites.size(), [&](auto&& f) {
    for (const List::Site& site : sites) f(site);
  });
  std::string names;
  list.any_near({1, 1}, [&](const List::Site& site, const auto&) {
    names += site.label.name;
    return false;
  });
  EXPECT_EQ(names.substr(0, 2), "ab");  // points farther away may follow
}

}  // namespace
}  // namespace pliant
