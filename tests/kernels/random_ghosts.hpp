#pragma once

#include <random>
#include <vector>

#include "kernels/table.hpp"
#include "tests/kernels/field.hpp"

namespace pliant::kernels::test {

/// Ghosts with up to 22 random particles each; some have none at all.
template <class T, int D>
struct RandomGhosts {
  static constexpr int width = record_width<D>, particles = 40, ghosts = 50;

  RandomGhosts() : records(particles * width) {
    std::mt19937 random(5);
    std::uniform_real_distribution<T> value(-1, 1);
    for (T& x : records) x = value(random);
    for (int g = 0; g < ghosts; ++g) {
      for (int i = static_cast<int>(random() % 23); i > 0; --i) {
        record.push_back(static_cast<std::int32_t>(random() % particles));
        for (Field<T>* fit : {&linear, &constrained, &surface}) fit->push_back(value(random));
      }
      begin.push_back(static_cast<std::int64_t>(record.size()));
    }
  }

  double sum(const Field<T>& fit, int ghost, int k) const {
    double total = 0;
    for (std::int64_t i = begin[ghost]; i < begin[ghost + 1]; ++i) {
      total += fit[i] * double(records[record[i] * width + k]);
    }
    return total;
  }

  GhostSums<T, D> sums(std::int64_t first, std::int64_t count, T* into) const {
    return {first,          count,          begin.data(),
            record.data(),  linear.data(),  constrained.data(),
            surface.data(), records.data(), into};
  }

  Field<T> records, linear, constrained, surface;
  std::vector<std::int64_t> begin = {0};
  std::vector<std::int32_t> record;
};

}  // namespace pliant::kernels::test
