#pragma once
// Measured values as fields of records [base/record.h]: each under its measure's name.
#include "base/record.h"
#include "observation/measures.h"

namespace morula {

/// The measured values of one thing for which `takes` is true, in their order, a column each.
template <class Of, class M>
struct MeasuresIn {
  M& of;  // a Measured<Of>
  bool (*takes)(const Measure<Of>&);
  /// Calls visit(measure, its place in `of.values`).
  void each(auto&& visit) const {
    const auto rows = sampledMeasures<Of>();
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (takes(rows[i])) visit(rows[i], i);
  }
};
template <class Of>
auto measuresIn(Measured<Of>& of, std::type_identity_t<bool (*)(const Measure<Of>&)> takes) {
  return MeasuresIn<Of, Measured<Of>>{of, takes};
}
template <class Of>
auto measuresIn(const Measured<Of>& of, std::type_identity_t<bool (*)(const Measure<Of>&)> takes) {
  return MeasuresIn<Of, const Measured<Of>>{of, takes};
}

template <class T>
concept IsMeasures = IsTemplate<T, MeasuresIn>;

}  // namespace morula
