#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <utility>

namespace pliant {

/// A 64-byte aligned array of plain values that grows but never shrinks, so that later steps do not
/// allocate. Large arrays request huge pages, which gain about a tenth in speed. Memory without
/// values yet costs nothing.
///
/// If all large arrays started at the beginning of a page, one slot of twenty fields would compete
/// for the same set of a cache. A store would also look like the load of another field, since
/// processors compare only twelve bits of addresses. Each array therefore starts a different number
/// of cache lines after the start of its memory.
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
  ~Buffer() { std::free(memory_); }

  /// Makes room for `size` values. Old values are kept, new ones are `filling`.
  void grow(std::size_t size, T filling) {
    if (size > capacity_) reallocate(size);
    if (size > size_) std::fill(values_ + size_, values_ + size, filling);
    size_ = std::max(size_, size);
  }

  T* get() { return values_; }
  const T* get() const { return values_; }
  T& operator[](std::size_t i) { return values_[i]; }
  const T& operator[](std::size_t i) const { return values_[i]; }
  std::size_t bytes() const { return size_ * sizeof(T); }

  void swap(Buffer& other) noexcept {
    std::swap(memory_, other.memory_);
    std::swap(values_, other.values_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

 private:
  static constexpr std::size_t line = 64, page = 4096, huge_page = std::size_t{2} << 20;

  void reallocate(std::size_t size) {
    const std::size_t alignment = size * sizeof(T) >= huge_page ? huge_page : line;
    const std::size_t start = size * sizeof(T) >= page ? next_start() : 0;
    // A tenth of slack avoids a reallocation at every remeshing of a slowly growing body.
    const std::size_t bytes = rounded(start + (size + size / 10) * sizeof(T), line);
    auto* memory =
        static_cast<std::byte*>(std::aligned_alloc(alignment, rounded(bytes, alignment)));
    if (memory == nullptr) throw std::bad_alloc();
    // The last pages stay small, since they are less than a huge page.
    if (alignment == huge_page) madvise(memory, bytes / huge_page * huge_page, MADV_HUGEPAGE);
    T* grown = reinterpret_cast<T*>(memory + start);
    std::copy(values_, values_ + size_, grown);
    std::free(memory_);
    memory_ = memory;
    values_ = grown;
    capacity_ = (bytes - start) / sizeof(T);
  }

  static std::size_t rounded(std::size_t bytes, std::size_t unit) {
    return (bytes + unit - 1) / unit * unit;
  }

  // Starts are nine lines apart: more than a chunk of slots takes, and 64 arrays before two
  // coincide.
  static std::size_t next_start() {
    static std::atomic<std::size_t> count{0};
    return count++ * 9 * line % page;
  }

  std::byte* memory_ = nullptr;
  T* values_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace pliant
