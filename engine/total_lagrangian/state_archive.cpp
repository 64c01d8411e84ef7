#include "engine/total_lagrangian/state_archive.hpp"

#include "engine/undeformed/state_archive.hpp"

namespace pliant::total_lagrangian {

template <class T, int D>
void put_state(ArchiveWriter& archive, const State<T, D>& state) {
  undeformed::put_state<D>(archive, state);
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    undeformed::put_arrays(archive, b, state.bodies[b]);
  }
}

template <class T, int D>
void get_state(const ArchiveReader& archive, State<T, D>& state) {
  undeformed::get_state<D>(archive, state);
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    undeformed::get_arrays(archive, b, state.bodies[b]);
  }
  state.age_memory();
}

template void put_state<double, 2>(ArchiveWriter&, const State<double, 2>&);
template void put_state<double, 3>(ArchiveWriter&, const State<double, 3>&);
template void get_state<double, 2>(const ArchiveReader&, State<double, 2>&);
template void get_state<double, 3>(const ArchiveReader&, State<double, 3>&);
template void put_state<float, 2>(ArchiveWriter&, const State<float, 2>&);
template void put_state<float, 3>(ArchiveWriter&, const State<float, 3>&);
template void get_state<float, 2>(const ArchiveReader&, State<float, 2>&);
template void get_state<float, 3>(const ArchiveReader&, State<float, 3>&);

}  // namespace pliant::total_lagrangian
