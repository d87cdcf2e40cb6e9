#pragma once
// Arrays that start on a cache line, as the kernels expect.
#include <cstddef>
#include <vector>

namespace morula {

/// Returns memory that starts on a cache line. freeLines needs the same number of bytes. Large arrays lie in huge pages
/// where the system has some, so random reads miss the address cache (TLB) less. Throws std::bad_alloc.
void* allocateLines(std::size_t bytes);
void freeLines(void* memory, std::size_t bytes);

template <class T>
struct CacheLineAllocator {
  using value_type = T;
  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(allocateLines(n * sizeof(T))); }
  void deallocate(T* p, std::size_t n) { freeLines(p, n * sizeof(T)); }
  friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }
};

template <class T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

}  // namespace morula
