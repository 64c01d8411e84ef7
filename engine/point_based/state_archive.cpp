#include "engine/point_based/state_archive.hpp"

#include "engine/undeformed/state_archive.hpp"

namespace pliant::point_based {

template <class T, int D>
void put_state(ArchiveWriter& archive, const State<T, D>& state) {
  undeformed::put_state<D>(archive, state);
  archive.put("clock/frequency2", state.frequency2);
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    undeformed::put_arrays(archive, b, state.bodies[b]);
  }
}

template <class T, int D>
void get_state(const ArchiveReader& archive, State<T, D>& state) {
  undeformed::get_state<D>(archive, state);
  state.frequency2 = archive.scalar<double>("clock/frequency2");
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    undeformed::get_arrays(archive, b, state.bodies[b]);
  }
}

template void put_state<double, 2>(ArchiveWriter&, const State<double, 2>&);
template void put_state<double, 3>(ArchiveWriter&, const State<double, 3>&);
template void get_state<double, 2>(const ArchiveReader&, State<double, 2>&);
template void get_state<double, 3>(const ArchiveReader&, State<double, 3>&);
template void put_state<float, 2>(ArchiveWriter&, const State<float, 2>&);
template void put_state<float, 3>(ArchiveWriter&, const State<float, 3>&);
template void get_state<float, 2>(const ArchiveReader&, State<float, 2>&);
template void get_state<float, 3>(const ArchiveReader&, State<float, 3>&);

}  // namespace pliant::point_based
