#include "engine/batch/sobol.hpp"

#include <array>
#include <bit>
#include <random>
#include <stdexcept>

namespace pliant::batch {

namespace {

constexpr int bits = 32;

/// A primitive polynomial, by its degree and inner coefficients, and its first direction numbers.
struct Generator {
  int degree;
  std::uint32_t coefficients;
  std::array<std::uint32_t, 7> first;
};

// From the second dimension on; the first is the van der Corput sequence.
constexpr std::array<Generator, SobolSequence::most_dimensions - 1> generators = {{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
}};

std::vector<std::uint32_t> directions_of(int dimension) {
  std::vector<std::uint32_t> v(bits);
  if (dimension == 0) {
    for (int i = 0; i < bits; ++i) v[static_cast<std::size_t>(i)] = 1u << (bits - 1 - i);
    return v;
  }
  const Generator& generator = generators[static_cast<std::size_t>(dimension - 1)];
  const auto s = static_cast<std::size_t>(generator.degree);
  for (std::size_t i = 0; i < s; ++i) v[i] = generator.first[i] << (bits - 1 - i);
  for (std::size_t i = s; i < bits; ++i) {
    v[i] = v[i - s] ^ (v[i - s] >> s);
    for (std::size_t k = 1; k < s; ++k) {
      if ((generator.coefficients >> (s - 1 - k) & 1u) != 0) v[i] ^= v[i - k];
    }
  }
  return v;
}

}  // namespace

SobolSequence::SobolSequence(int dimensions, std::uint64_t seed) {
  if (dimensions < 1 || dimensions > most_dimensions) {
    throw std::invalid_argument("a Sobol sequence has from 1 to 20 dimensions");
  }
  std::mt19937_64 random(seed);
  dimensions_.reserve(static_cast<std::size_t>(dimensions));
  for (int d = 0; d < dimensions; ++d) {
    dimensions_.push_back({static_cast<std::uint32_t>(random() >> 32), 0, directions_of(d)});
  }
}

// Gray code: a point differs from the one before in the direction of the lowest zero bit of n - 1.
std::vector<double> SobolSequence::next() {
  std::vector<double> point;
  point.reserve(dimensions_.size());
  const auto changed = static_cast<std::size_t>(std::countr_one(count_ - 1));
  for (Dimension& dimension : dimensions_) {
    if (count_ > 0) dimension.value ^= dimension.directions[changed];
    point.push_back((dimension.value ^ dimension.shift) * 0x1p-32);
  }
  ++count_;
  return point;
}

}  // namespace pliant::batch
