#pragma once

#include "engine/undeformed/bulk_memory.hpp"
#include "engine/undeformed/network_memory.hpp"

namespace pliant::undeformed {

/// The memory of a viscous body as kernels read it.
template <class T>
struct BodyMemory {
  BulkMemory<T> bulk;
  NetworkMemory<T> shear;

  template <class Body>
  explicit BodyMemory(const Body& body) : bulk(body.prony), shear(body.prony_shear) {}

  /// For the stress `age` [s] after the last one. What the body remembers of it replaces the old.
  template <class Body>
  void prepare(double age, Body& body) {
    const BulkArrays<T> arrays = {body.memory_pressure, body.volume_change};
    bulk.prepare(age, body.material.polynomial.bulk_modulus, arrays, arrays);
    shear.prepare(age, body.network, body.network);
  }
};

}  // namespace pliant::undeformed
