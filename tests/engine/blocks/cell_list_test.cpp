#include "engine/blocks/cell_list.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <tuple>

namespace pliant {
namespace {

template <int D>
struct Box {
  Point<D> extent;
  Cell<D> period;
  double radius;
};

/// Slot and image of everything within the radius of a point.
template <int D>
using Found = std::set<std::pair<std::int32_t, Cell<D>>>;

template <int D>
std::vector<Site<D>> random_sites(const Box<D>& box, int count) {
  std::mt19937 random(7);
  std::vector<Site<D>> sites(count);
  for (int i = 0; i < count; ++i) {
    sites[i].slot = i;
    for (int a = 0; a < D; ++a) {
      sites[i].position[a] = std::uniform_real_distribution<double>(0, box.extent[a])(random);
    }
  }
  return sites;
}

template <int D>
double distance2(const Point<D>& at, const Site<D>& site, const Cell<D>& shift) {
  double sum = 0;
  for (int a = 0; a < D; ++a) {
    sum += std::pow(site.position[a] + shift[a] - at[a], 2);
  }
  return sum;
}

template <int D>
Found<D> found_by_trying_all(const Box<D>& box, const std::vector<Site<D>>& sites,
                             const Point<D>& at) {
  Found<D> found;
  Cell<D> most = {}, periods;
  for (int a = 0; a < D; ++a) {
    if (box.period[a] > 0) most[a] = static_cast<int>(std::ceil(box.radius / box.period[a])) + 1;
  }
  for (const Site<D>& site : sites) {
    for (int a = 0; a < D; ++a) periods[a] = -most[a];
    while (true) {
      Cell<D> shift;
      for (int a = 0; a < D; ++a) shift[a] = periods[a] * box.period[a];
      if (distance2<D>(at, site, shift) < box.radius * box.radius) found.emplace(site.slot, shift);
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

template <int D>
void expect_all_found(const Box<D>& box, const std::vector<Site<D>>& sites) {
  CellList<D> list;
  list.cover({}, box.extent, box.period, box.radius, sites.size());
  list.sort(sites.size(), [&](auto&& f) {
    for (const Site<D>& site : sites) f(site);
  });
  EXPECT_LE(list.cubes(), sites.size());
  for (const Site<D>& site : sites) {
    Found<D> found;
    list.any_near(site.position, [&](const Site<D>& q, const Cell<D>& shift) {
      if (distance2<D>(site.position, q, shift) < box.radius * box.radius) {
        EXPECT_TRUE(found.emplace(q.slot, shift).second) << "found twice";
      }
      return false;
    });
    ASSERT_EQ(found, found_by_trying_all<D>(box, sites, site.position));
  }
}

template <int D>
void expect_all_found(const Box<D>& box) {
  expect_all_found(box, random_sites<D>(box, 300));
}

TEST(cell_list, finds_all_sites_within_the_radius) {
  expect_all_found<2>({{20, 13}, {}, 2.6});
  expect_all_found<3>({{7, 9, 8}, {}, 1.8});
}

TEST(cell_list, finds_images_across_periods) {
  expect_all_found<2>({{20, 13}, {20, 0}, 2.6});
  expect_all_found<2>({{20, 13}, {20, 13}, 2.6});
  expect_all_found<3>({{7, 9, 8}, {7, 0, 8}, 1.8});
}

TEST(cell_list, goes_round_short_periods_more_than_once) {
  expect_all_found<2>({{2, 30}, {2, 30}, 2.6});
  expect_all_found<2>({{1, 4}, {1, 4}, 2.6});
}

TEST(cell_list, strays_cost_no_memory) {
  const Box<2> box = {{20, 13}, {}, 2.6};
  auto sites = random_sites(box, 300);
  sites[5].position = {1e9, 3};
  sites[6].position = {4, 1e12};
  expect_all_found<2>({{1e9, 1e12}, {}, 2.6}, sites);
}

TEST(cell_list, stops_at_the_first_that_counts) {
  const Box<2> box = {{20, 13}, {}, 2.6};
  const auto sites = random_sites(box, 300);
  CellList<2> list;
  list.cover({}, box.extent, box.period, box.radius, sites.size());
  list.sort(sites.size(), [&](auto&& f) {
    for (const Site<2>& site : sites) f(site);
  });
  int calls = 0;
  EXPECT_TRUE(list.any_near({10, 6}, [&](const Site<2>&, const Cell<2>&) { return ++calls == 3; }));
  EXPECT_EQ(calls, 3);
}

}  // namespace
}  // namespace pliant
