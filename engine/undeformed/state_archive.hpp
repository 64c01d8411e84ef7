#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <span>
#include <string>

#include "engine/output/archive/archive.hpp"
#include "engine/undeformed/state.hpp"

/// The common part of the checkpoints of all methods on the undeformed body.
namespace pliant::undeformed {

/// Clock, energy, and the totals of boundaries.
template <int D>
void put_totals(ArchiveWriter& archive, const State<D>& state);
template <int D>
void get_totals(const ArchiveReader& archive, State<D>& state);

/// Calls f(name, buffer) for every array that a checkpoint holds.
template <class Body, class F>
void for_each_saved_array(Body& body, std::size_t number, F&& f) {
  body.for_each_array([&](const auto& field, auto components) {
    if (!field.is_saved) return;
    for (std::size_t c = 0; c < components.size(); ++c) {
      f(fmt::format("body/{}/{}/{}", number, field.name, c), components[c]);
    }
  });
}

/// Writes everything that the next step reads and that set-up does not compute.
template <template <class, int> class S, class T, int D>
void put_state(ArchiveWriter& archive, const S<T, D>& state) {
  put_totals<D>(archive, state);
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const auto& body = state.bodies[b];
    for_each_saved_array(body, b, [&](const std::string& name, const auto& values) {
      archive.put(name, std::span(std::as_const(values).get(), body.slots));
    });
  }
}

/// Reads into the state of the same case. Throws OutputError when the archive does not fit it.
template <template <class, int> class S, class T, int D>
void get_state(const ArchiveReader& archive, S<T, D>& state) {
  get_totals<D>(archive, state);
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    auto& body = state.bodies[b];
    for_each_saved_array(body, b, [&](const std::string& name, auto& values) {
      archive.read(name, std::span(values.get(), body.slots));
    });
  }
}

}  // namespace pliant::undeformed
