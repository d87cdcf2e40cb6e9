#pragma once
// Tables of records for other programs: the columns follow from a record's one list of fields [base/record.h].
#include <concepts>
#include <limits>
#include <string>
#include <string_view>

#include "base/cell_path.h"
#include "base/hash.h"
#include "base/vec3.h"
#include "library/morula.h"
#include "observation/measure_fields.h"

namespace morula {

/// Calls take(field, kind, isAbsent, value) for each column of a member; most members have one. The value is a number,
/// or a text for the kinds text and bytes.
template <class Member>
void eachColumn(const FieldInfo& field, const Member& member, const auto& take, bool isAbsent = false) {
  using Kind = DataColumn::Kind;
  if constexpr (IsMeasures<Member>) {
    member.each([&](const auto& m, std::size_t i) {
      const auto& value = member.of.values[i];
      take(FieldInfo{m.name, m.meaning, m.unit}, m.isWhole ? Kind::whole : Kind::real, !value, value.value_or(0));
    });
  } else if constexpr (requires { member.isAbsent; }) {
    eachColumn(field, member.of, take, isAbsent || member.isAbsent);
  } else if constexpr (IsOptional<Member>) {
    eachColumn(field, member.value_or(typename Member::value_type{}), take, isAbsent || !member);
  } else if constexpr (IsTemplate<Member, AnyReal> || IsTemplate<Member, AllBits>) {
    eachColumn(field, member.of, take, isAbsent);
  } else if constexpr (std::same_as<Member, Vector>) {
    for (const auto& [axis, value] : {std::pair("_x", member.x), std::pair("_y", member.y), std::pair("_z", member.z)})
      take(FieldInfo{(field.name + std::string(axis)).c_str(), field.meaning, field.unit}, Kind::real, isAbsent, value);
  } else if constexpr (IsTemplate<Member, TextOf> || IsTemplate<Member, BytesOf>) {
    const Kind kind = IsTemplate<Member, TextOf> ? Kind::text : Kind::bytes;
    take(field, kind, isAbsent, isAbsent ? std::string() : std::string(member.write()));
  } else if constexpr (std::floating_point<Member>) {
    take(field, Kind::real, isAbsent, member);
  } else if constexpr (std::integral<Member>) {
    take(field, Kind::whole, isAbsent, double(member));
  } else if constexpr (HasChoices<Member>) {
    take(field, Kind::text, isAbsent, std::string(nameOf(member)));
  } else if constexpr (std::same_as<Member, Hash> || std::same_as<Member, CellPath>) {
    take(field, Kind::text, isAbsent, member.text());
  } else {
    take(field, Kind::text, isAbsent, std::string(member));
  }
}

inline void addValue(DataColumn& column, bool isAbsent, double value) {
  column.numbers.push_back(isAbsent ? std::numeric_limits<double>::quiet_NaN() : value);
}
inline void addValue(DataColumn& column, bool isAbsent, std::string value) {
  if (isAbsent) column.texts.emplace_back();
  else column.texts.emplace_back(std::move(value));
}

/// Appends a row: the values of the context, then the row's own. A table without columns gets them first. `context`:
/// the names of the context's columns, with blanks between: "time".
template <Record Row, class... Context>
void addRow(DataTable& table, std::string_view context, const Row& row, const Context&... values) {
  const bool isNew = table.columns.empty();
  std::size_t place = 0;
  const auto take = [&](const FieldInfo& field, DataColumn::Kind kind, bool isAbsent, auto&& value) {
    if (isNew) table.columns.push_back({field.name, field.unit, field.meaning, kind, {}, {}});
    addValue(table.columns[place++], isAbsent, value);
  };
  [[maybe_unused]] const auto takeContext = [&](const auto& value) {
    const auto end = context.find(' ');
    const std::string name(context.substr(0, end));
    context.remove_prefix(end == context.npos ? context.size() : end + 1);
    eachColumn(FieldInfo{.name = name.c_str(), .unit = name == "time" ? "time" : ""}, value, take);
  };
  (takeContext(values), ...);
  listFields(row, [&](const FieldInfo& field, const auto& member) { eachColumn(field, member, take); });
}

/// Returns a table without rows.
template <Record Row, class... Context>
DataTable tableWithout(std::string name, std::string_view context, const Context&... values) {
  DataTable table{std::move(name), {}};
  addRow(table, context, Row{}, values...);
  for (DataColumn& column : table.columns) column.numbers.clear(), column.texts.clear();
  return table;
}

}  // namespace morula
