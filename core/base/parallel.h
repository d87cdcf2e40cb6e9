#pragma once
// Threads split work by index only; each index writes its own memory, so the number of threads cannot change a bit.
#include <type_traits>

namespace morula {

/// Calls body(context, i) for i in 0 … count−1 on up to `threads` threads. With one thread, or one index, it is a loop.
void parallelFor(int count, int threads, void (*body)(void* context, int index), void* context);

template <class Body>
void parallelFor(int count, int threads, Body&& body) {
  parallelFor(
      count, threads, [](void* context, int index) { (*static_cast<std::remove_reference_t<Body>*>(context))(index); },
      &body);
}

/// Returns this thread's number within the running parallelFor, 0 … threads−1, which selects its scratch memory.
int threadNumber();

}  // namespace morula
