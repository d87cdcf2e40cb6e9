#pragma once
// Records [base/record.h] as JSON: an object with a member for each field.
//
// Vectors in space are lists of three numbers; a list of vectors is one flat list x, y, z, x, … A number that is not
// finite is written as null and read as NaN. Any JSON that was not so written is a Json::exception.
#include <limits>
#include <vector>

#include "base/cell_path.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/vec3.h"
#include "observation/measure_fields.h"
#include "system/json.h"

namespace morula {

/// Returns a whole number of this type. Throws Json::exception for anything else, and for a number that does not fit.
template <std::integral Whole>
Whole wholeFrom(const Json& json) {
  const auto refuse = [] {
    throw Json::out_of_range::create(401, "needs a whole number that is not too large", nullptr);
  };
  if (!json.is_number_integer()) refuse();
  if (json.is_number_unsigned() ? !std::in_range<Whole>(json.get<std::uint64_t>())
                                : !std::in_range<Whole>(json.get<std::int64_t>()))
    refuse();
  return json.get<Whole>();
}

template <Record T>
Json toJson(const T& record);

template <class Member>
Json memberJson(const Member& member) {
  if constexpr (Record<Member>) return toJson(member);
  else if constexpr (requires { member.isAbsent; }) return member.isAbsent ? Json() : memberJson(member.of);
  else if constexpr (IsOptional<Member>) return member ? memberJson(*member) : Json();
  else if constexpr (IsTemplate<Member, AllBits> || IsTemplate<Member, AnyReal>) return member.of;
  else if constexpr (IsTemplate<Member, TextOf>) return member.write();
  else if constexpr (IsTemplate<Member, ValueOf>) return memberJson(member.write());
  else if constexpr (HasChoices<Member>) return nameOf(member);
  else if constexpr (std::same_as<Member, Vector>) return Json::array({member.x, member.y, member.z});
  else if constexpr (requires { member.text(); }) return member.text();
  else if constexpr (IsTemplate<Member, std::vector>) {
    Json list = Json::array();
    for (const auto& item : member)
      if constexpr (std::same_as<typename Member::value_type, Vector>)
        for (const double x : {item.x, item.y, item.z}) list.push_back(x);
      else list.push_back(memberJson<typename Member::value_type>(item));
    return list;
  } else return member;
}

template <Record T>
Json toJson(const T& record) {
  Json json = Json::object();
  listFields(record, [&]<class Member>(const FieldInfo& field, const Member& member) {
    if constexpr (IsMeasures<Member>)
      member.each([&](const auto& measure, std::size_t i) {
        const std::optional<double>& v = member.of.values[i];
        if (v && measure.isWhole) json[measure.name] = static_cast<std::int64_t>(*v);
        else json[measure.name] = orNull(v);
      });
    else json[field.name] = memberJson(member);
  });
  return json;
}

template <Record T>
void readRecord(const Json& json, T& record);

template <class Member>
void readMember(const Json& json, Member&& to) {
  using T = std::remove_cvref_t<Member>;
  if constexpr (Record<T>) readRecord(json, to);
  else if constexpr (requires { to.isAbsent; }) {
    if (!json.is_null()) readMember(json, to.of);
  } else if constexpr (IsOptional<T>) {
    if (!json.is_null()) readMember(json, to.emplace());
  } else if constexpr (IsTemplate<T, AllBits> || IsTemplate<T, AnyReal>) readMember(json, to.of);
  else if constexpr (IsTemplate<T, TextOf>) to.read(json.get<std::string>());
  else if constexpr (IsTemplate<T, ValueOf>) {
    if constexpr (!std::same_as<decltype(to.read), std::remove_const_t<decltype(notRead)>>) {
      decltype(to.write()) value{};
      readMember(json, value);
      to.read(value);
    }
  } else if constexpr (HasChoices<T>) {
    const auto name = json.get<std::string>();
    for (const auto& row : choices<T>)
      if (row.name == name) return void(to = row.value);
    throw Json::other_error::create(501, "'" + name + "' is not " + namesOf<T>(), nullptr);
  } else if constexpr (std::same_as<T, Vector>) {
    for (int i = 0; double* x : {&to.x, &to.y, &to.z}) readMember(json.at(i++), *x);
  } else if constexpr (std::same_as<T, CellPath>) {
    to = CellPath::parse(json.get<std::string>());
  } else if constexpr (std::same_as<T, Hash>) {
    const auto hash = readHash(json.get<std::string>());
    if (!hash) throw Json::other_error::create(501, "'" + json.get<std::string>() + "' is no hash", nullptr);
    to = *hash;
  } else if constexpr (IsTemplate<T, std::vector>) {
    if (!json.is_array()) throw Json::type_error::create(302, "needs a list", nullptr);
    to.clear();
    if constexpr (std::same_as<typename T::value_type, Vector>) {
      for (std::size_t i = 0; i < json.size(); i += 3) {
        Vector& v = to.emplace_back();
        for (std::size_t k = 0; double* x : {&v.x, &v.y, &v.z}) readMember(json.at(i + k++), *x);
      }
    } else {
      for (const Json& item : json) readMember(item, to.emplace_back());
    }
  } else if constexpr (std::is_enum_v<T>) to = static_cast<T>(wholeFrom<int>(json));
  else if constexpr (std::same_as<T, double>)
    to = json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
  else if constexpr (std::integral<T> && !std::same_as<T, bool>) to = wholeFrom<T>(json);
  else json.get_to(to);
}

template <Record T>
void readRecord(const Json& json, T& record) {
  listFields(record, [&]<class Member>(const FieldInfo& field, Member&& member) {
    using Kind = std::remove_cvref_t<Member>;
    if constexpr (IsMeasures<Kind>)
      member.each([&](const auto& measure, std::size_t i) {
        if (const Json& v = json.at(measure.name); !v.is_null()) member.of.values[i] = v.get<double>();
      });
    else readMember(json.at(field.name), member);
  });
}

/// Reads a record. Throws Json::exception for anything that toJson did not write.
template <Record T>
T fromJson(const Json& json) {
  T record{};
  readRecord(json, record);
  return record;
}

}  // namespace morula
