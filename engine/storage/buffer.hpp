#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <utility>

namespace pliant {

/// A 64-byte aligned array of plain values that grows but never shrinks, so that a warm step
/// allocates nothing. Large arrays ask for huge pages, which is worth about a tenth of the speed.
template <class T>
class Buffer {
 public:
  Buffer() = default;
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer&& other) noexcept {
    swap(other);
    return *this;
  }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  ~Buffer() { std::free(values_); }

  /// Makes room for `size` values and gives every value beyond the old capacity the value
  /// `filling`. Values below it are kept.
  void grow(std::size_t size, T filling) {
    if (size <= capacity_) return;
    const std::size_t alignment = size * sizeof(T) >= huge_page ? huge_page : 64;
    // A tenth of slack keeps a slowly growing body from reallocating at every remeshing.
    const std::size_t bytes = rounded((size + size / 10) * sizeof(T), alignment);
    auto* grown = static_cast<T*>(std::aligned_alloc(alignment, bytes));
    if (grown == nullptr) throw std::bad_alloc();
    if (alignment == huge_page) madvise(grown, bytes, MADV_HUGEPAGE);
    const std::size_t capacity = bytes / sizeof(T);
    std::copy(values_, values_ + capacity_, grown);
    std::fill(grown + capacity_, grown + capacity, filling);
    std::free(values_);
    values_ = grown;
    capacity_ = capacity;
  }

  T* get() { return values_; }
  const T* get() const { return values_; }
  T& operator[](std::size_t i) { return values_[i]; }
  const T& operator[](std::size_t i) const { return values_[i]; }
  std::size_t bytes() const { return capacity_ * sizeof(T); }

  void swap(Buffer& other) noexcept {
    std::swap(values_, other.values_);
    std::swap(capacity_, other.capacity_);
  }

 private:
  static constexpr std::size_t huge_page = std::size_t{2} << 20;
  static std::size_t rounded(std::size_t bytes, std::size_t unit) {
    return (bytes + unit - 1) / unit * unit;
  }

  T* values_ = nullptr;
  std::size_t capacity_ = 0;
};

}  // namespace pliant
