#pragma once

#include <sys/mman.h>

#include <cstdlib>
#include <new>
#include <vector>

namespace pliant::kernels::test {

/// Memory as in the storage of the engine: aligned to cache lines, large fields in huge pages.
template <class T>
struct FieldAllocator {
  using value_type = T;
  static constexpr std::size_t huge_page = std::size_t{2} << 20;

  FieldAllocator() = default;
  template <class U>
  FieldAllocator(const FieldAllocator<U>&) {}

  T* allocate(std::size_t n) {
    const std::size_t alignment = n * sizeof(T) >= huge_page ? huge_page : 64;
    const std::size_t bytes = (n * sizeof(T) + alignment - 1) / alignment * alignment;
    void* memory = std::aligned_alloc(alignment, bytes);
    if (memory == nullptr) throw std::bad_alloc();
    if (alignment == huge_page) madvise(memory, bytes, MADV_HUGEPAGE);
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  friend bool operator==(const FieldAllocator&, const FieldAllocator&) { return true; }
};

/// A field over all slots.
template <class T>
using Field = std::vector<T, FieldAllocator<T>>;

}  // namespace pliant::kernels::test
