#include "engine/remeshed/setup/regions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "engine/remeshed/state/resources.hpp"
#include "tests/invariants/sample_runs.hpp"

// The resources of the scheduler partition the memory of the fields.
namespace pliant::test {
namespace {

using remeshed::Field;
using remeshed::Group;

using Region = std::span<std::byte>;

struct Regions : OfSampleRuns {};
INSTANTIATE_TEST_SUITE_P(runs, Regions, testing::ValuesIn(sample_runs()), name_of);

std::vector<Region> of_all_blocks(Solver& solver, scheduler::FieldId resource) {
  std::vector<Region> all;
  for (int block = 0; block < std::ssize(solver.state().blocks); ++block) {
    const auto of_block = remeshed::regions(solver.state(), resource, block);
    all.insert(all.end(), of_block.begin(), of_block.end());
  }
  return all;
}

/// The regions of every field that phases of a step write or read on the present lattice.
std::map<scheduler::FieldId, std::vector<Region>> present(Solver& solver) {
  std::map<scheduler::FieldId, std::vector<Region>> found;
  for (int id = 0; id < remeshed::resource_numbers.count(); ++id) {
    if (remeshed::resource_numbers[id].group >= Group::new_state) break;
    found[id] = of_all_blocks(solver, id);
  }
  return found;
}

TEST_P(Regions, no_two_resources_of_a_step_share_memory) {
  Solver solver(GetParam().settled(), {1, kernels::widest_supported()});
  advance(solver, GetParam().middle);
  std::map<const std::byte*, std::pair<const std::byte*, scheduler::FieldId>> owners;
  const auto names = remeshed::resource::names();
  for (const auto& [id, of_resource] : present(solver)) {
    for (const Region region : of_resource) {
      const auto [at, is_new] = owners.insert({region.data(), {region.data() + region.size(), id}});
      EXPECT_TRUE(is_new) << names[id] << " begins where " << names[at->second.second] << " does";
    }
  }
  for (auto next = owners.begin(), region = next++; next != owners.end(); region = next++) {
    ASSERT_LE(region->second.first, next->first)
        << names[region->second.second] << " overlaps " << names[next->second.second];
  }
}

TEST_P(Regions, every_slot_of_the_state_belongs_to_a_resource) {
  Solver solver(GetParam().settled(), {1, kernels::widest_supported()});
  advance(solver, GetParam().middle);
  std::vector<Region> all;
  for (const auto& [id, of_resource] : present(solver)) {
    all.insert(all.end(), of_resource.begin(), of_resource.end());
  }
  for (Body& body : solver.state().bodies) {
    std::size_t slots = 0;
    for (const Block<2>& block : body.population.layout.blocks()) {
      body.population.layout.for_each_slot(block, [&](auto, auto) { ++slots; });
    }
    for (const auto& store : body.stage) {
      for (const remeshed::Declaration& field : remeshed::state_fields) {
        for (const Buffer<double>& component : store[field.field]) {
          const auto* begin = reinterpret_cast<const std::byte*>(component.get());
          std::size_t bytes = 0;
          for (const Region region : all) {
            const bool is_inside =
                region.data() >= begin && region.data() < begin + component.bytes();
            bytes += is_inside ? region.size() : 0;
          }
          EXPECT_EQ(bytes, slots * sizeof(double)) << field.name;
        }
      }
    }
  }
}

// Phases are ordered by resources, so these must have one.
TEST(resources, of_the_odd_stress_are_those_of_the_fields_in_whose_place_it_lies) {
  Solver solver(sample_runs()[0].settled(), {1, kernels::widest_supported()});
  Body& body = solver.state().bodies[0];
  using namespace remeshed::resource;
  const auto odd = *particles(Group::stress, 1).begin();
  EXPECT_EQ(odd, *particles(Group::constants, 1).begin());
  EXPECT_NE(odd, *particles(Group::stress, 0).begin());
  const auto regions = of_all_blocks(solver, odd);
  for (const double* component : std::as_const(body).stress_view(1)) {
    const auto* begin = reinterpret_cast<const std::byte*>(component);
    const std::size_t bytes = body.population.layout.slots() * sizeof(double);
    EXPECT_TRUE(std::ranges::any_of(regions, [&](const Region region) {
      return region.data() >= begin && region.data() < begin + bytes;
    }));
  }
}

TEST(resources, have_names_of_their_own) {
  const auto names = remeshed::resource::names();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  for (int id = 0; id < std::ssize(names); ++id) {
    EXPECT_EQ(remeshed::resource_numbers(remeshed::resource_numbers[id]), id);
  }
}

}  // namespace
}  // namespace pliant::test
