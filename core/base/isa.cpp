#include "base/isa.h"

#include <string>

#include "base/error.h"

namespace morula {

std::vector<Isa> availableIsas() {
  std::vector<Isa> all{Isa::scalar, Isa::narrow};
#if defined(MORULA_WITH_AVX)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2")) all.push_back(Isa::avx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))
    all.push_back(Isa::avx512);
#endif
  return all;
}

Isa bestIsa() {
  static const Isa best = availableIsas().back();
  return best;
}

const char* name(Isa isa) {
  constexpr const char* names[] = {"scalar", "narrow", "avx2", "avx512"};
  return names[static_cast<int>(isa)];
}

Isa parseIsa(std::string_view word) {
  std::string known;
  for (Isa isa : availableIsas()) {
    if (word == name(isa)) return isa;
    known += (known.empty() ? "" : ", ") + std::string(name(isa));
  }
  throw InputError("instruction set \"" + std::string(word) + "\" is not available here; available: " + known);
}

}  // namespace morula
