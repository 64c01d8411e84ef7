#pragma once

#include <concepts>
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

namespace pliant::scheduler {

/// Contiguous values of one type in memory.
struct MemoryPiece {
  std::byte* data;
  std::size_t size;        ///< bytes
  std::size_t value_size;  ///< bytes
  /// Changes a value to another one with which a phase can still run; nullptr: impossible.
  void (*disturb)(std::byte* value);

  std::span<const std::byte> bytes() const { return {data, size}; }
};

/// The memory of a field in one block. Pieces may overlap those of other fields.
class FieldMemory {
 public:
  template <std::floating_point T>
  void add(T* values, std::size_t count) {
    add_values(values, count, [](std::byte* value) {
      T x;
      std::memcpy(&x, value, sizeof(T));
      x = T(1.25) * x + T(1e-6);
      std::memcpy(value, &x, sizeof(T));
    });
  }

  /// Adds values that are 0 or 1.
  template <class T>
  void add_flags(T* flags, std::size_t count) {
    add_values(flags, count, [](std::byte* value) {
      T flag;
      std::memcpy(&flag, value, sizeof(T));
      flag = flag == T{} ? T(1) : T{};
      std::memcpy(value, &flag, sizeof(T));
    });
  }

  /// Adds values that must stay valid, such as indices: a check sees writes to them, but no reads.
  template <class T>
  void add_fixed(T* values, std::size_t count) {
    add_values(values, count, nullptr);
  }

  void clear() { pieces_.clear(); }
  const std::vector<MemoryPiece>& pieces() const { return pieces_; }

 private:
  template <class T>
  void add_values(T* values, std::size_t count, void (*disturb)(std::byte*)) {
    if (count == 0) return;
    pieces_.push_back(
        {reinterpret_cast<std::byte*>(values), count * sizeof(T), sizeof(T), disturb});
  }

  std::vector<MemoryPiece> pieces_;
};

}  // namespace pliant::scheduler
