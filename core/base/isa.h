#pragma once
// The instruction set of the kernels. It changes speed, never a bit of the result: the lanes of every set
// do the same IEEE operations in the same order.
#include <string_view>
#include <vector>

namespace morula {

enum class Isa {
  scalar,  // one cell at a time: the oracle
  narrow,  // two side by side: SSE2, NEON; every machine has it
  avx2,    // four, without fused multiply-add
  avx512,  // eight, without fused multiply-add
};

/// Returns the widest set that this program was built with and this processor has.
Isa bestIsa();
/// Returns all sets that this program was built with and this processor has, narrowest first.
std::vector<Isa> availableIsas();
const char* name(Isa isa);
/// Throws InputError for an unknown name, or for a set that is not available on this machine.
Isa parseIsa(std::string_view word);

/// A kernel table has one entry per Isa; sets that were not built stand as null.
template <class Table>
struct PerIsa {
  const Table* scalar;
  const Table* narrow;
  const Table* avx2;
  const Table* avx512;
  const Table& operator[](Isa isa) const {
    switch (isa) {
      case Isa::scalar: return *scalar;
      case Isa::narrow: return *narrow;
      case Isa::avx2: return *avx2;
      case Isa::avx512: return *avx512;
    }
    return *scalar;
  }
};

// Declares the tables `name` of type Table in the instruction sets' namespaces, and gathers them as `tables`; for use
// in namespace morula. `suffix` of the namespaces: nothing, or _single for kernels that compute with floats.
#define MORULA_DECLARE_TABLE(Table, isa, name) \
  namespace isa {                              \
  extern const Table name;                     \
  }
#if defined(MORULA_WITH_AVX)
#define MORULA_TABLES(Table, name, tables, suffix)                                                     \
  MORULA_DECLARE_TABLE(Table, scalar##suffix, name)                                                    \
  MORULA_DECLARE_TABLE(Table, narrow##suffix, name)                                                    \
  MORULA_DECLARE_TABLE(Table, avx2##suffix, name)                                                      \
  MORULA_DECLARE_TABLE(Table, avx512##suffix, name)                                                    \
  static const PerIsa<Table> tables{&scalar##suffix::name, &narrow##suffix::name, &avx2##suffix::name, \
                                    &avx512##suffix::name};
#else
#define MORULA_TABLES(Table, name, tables, suffix)  \
  MORULA_DECLARE_TABLE(Table, scalar##suffix, name) \
  MORULA_DECLARE_TABLE(Table, narrow##suffix, name) \
  static const PerIsa<Table> tables{&scalar##suffix::name, &narrow##suffix::name, nullptr, nullptr};
#endif

}  // namespace morula
