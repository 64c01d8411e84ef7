#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <span>
#include <string>

#include "engine/output/archive.hpp"
#include "engine/undeformed/state.hpp"

/// What the checkpoints of all methods on the undeformed body hold.
namespace pliant::undeformed {

template <int D>
void put_state(ArchiveWriter& archive, const State<D>& state);
template <int D>
void get_state(const ArchiveReader& archive, State<D>& state);

/// Calls f(name, buffer) for every array that a checkpoint holds; `declaration(field)` comes from
/// the namespace of the field.
template <class Body, class F>
void for_each_saved_array(Body& body, std::size_t number, F&& f) {
  body.for_each_array([&](auto field, auto components) {
    if (!declaration(field).is_saved) return;
    for (std::size_t c = 0; c < components.size(); ++c) {
      f(fmt::format("body/{}/{}/{}", number, declaration(field).name, c), components[c]);
    }
  });
}

template <class Body>
void put_arrays(ArchiveWriter& archive, std::size_t number, const Body& body) {
  for_each_saved_array(body, number, [&](const std::string& name, const auto& values) {
    archive.put(name, std::span(std::as_const(values).get(), body.slots));
  });
}

template <class Body>
void get_arrays(const ArchiveReader& archive, std::size_t number, Body& body) {
  for_each_saved_array(body, number, [&](const std::string& name, auto& values) {
    archive.read(name, std::span(values.get(), body.slots));
  });
}

}  // namespace pliant::undeformed
