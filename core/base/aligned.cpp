#include "base/aligned.h"

#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace morula {
namespace {

constexpr std::size_t line = 64;
#if defined(MADV_HUGEPAGE)
constexpr std::size_t hugePage = 2 << 20;
#else
constexpr std::size_t hugePage = line;  // this system has no huge pages
#endif

std::align_val_t alignmentOf(std::size_t bytes) { return std::align_val_t(bytes < hugePage ? line : hugePage); }

}  // namespace

void* allocateLines(std::size_t bytes) {
  void* memory = ::operator new(bytes, alignmentOf(bytes));
#if defined(MADV_HUGEPAGE)
  // Advises whole huge pages only: the rest keeps small pages, so that no memory is taken but what was asked for. A
  // system that declines does no harm.
  if (bytes >= hugePage) madvise(memory, bytes / hugePage * hugePage, MADV_HUGEPAGE);
#endif
  return memory;
}

void freeLines(void* memory, std::size_t bytes) { ::operator delete(memory, alignmentOf(bytes)); }

}  // namespace morula
