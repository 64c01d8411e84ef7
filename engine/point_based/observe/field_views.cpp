#include "engine/point_based/observe/field_views.hpp"

#include "engine/geometry/padded.hpp"

namespace pliant::point_based {

template <class T, int D>
std::vector<SlotRun> slot_runs(const Body<T, D>& body) {
  std::vector<SlotRun> runs;
  runs.reserve(body.blocks.size());
  for (const NodeBlock& block : body.blocks)
    runs.push_back({block.first, block.first + block.nodes});
  return runs;
}

template <class T, int D>
std::vector<std::array<double, 3>> present_positions(const Body<T, D>& body) {
  std::vector<std::array<double, 3>> list;
  list.reserve(body.particles);
  body.for_each_node([&](std::int64_t slot) { list.push_back(padded<D>(body.position(slot))); });
  return list;
}

template std::vector<SlotRun> slot_runs<double, 2>(const Body<double, 2>&);
template std::vector<std::array<double, 3>> present_positions<double, 2>(const Body<double, 2>&);
template std::vector<SlotRun> slot_runs<double, 3>(const Body<double, 3>&);
template std::vector<std::array<double, 3>> present_positions<double, 3>(const Body<double, 3>&);
template std::vector<SlotRun> slot_runs<float, 2>(const Body<float, 2>&);
template std::vector<std::array<double, 3>> present_positions<float, 2>(const Body<float, 2>&);
template std::vector<SlotRun> slot_runs<float, 3>(const Body<float, 3>&);
template std::vector<std::array<double, 3>> present_positions<float, 3>(const Body<float, 3>&);

}  // namespace pliant::point_based
