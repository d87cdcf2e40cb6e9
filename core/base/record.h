#pragma once
// Records: structs with one list of their fields. The database's columns and their comments, JSON out and in, and
// tables for people come from that list. A field of the struct that is not in its list does not compile.
//
//   template <IsA<TimeStepRecord> T>
//   void listFields(T& change, auto&& field) {
//     auto& [time, step, timeStep] = change;  // all members, in the order of the struct
//     field({"step"}, step);
//     field({"time_step", "in force from here on", "time"}, timeStep);
//   }
#include <concepts>
#include <optional>
#include <type_traits>

#include "base/choice.h"

namespace morula {

template <class A, class T>
concept IsA = std::same_as<std::remove_const_t<A>, T>;

/// The properties of a field beside its type.
struct FieldInfo {
  const char* name;            // of the column, and of the member in JSON
  const char* meaning = "";    // for people, on one line; "": the name says it
  const char* unit = "";       // "time"; "": a pure number, or none
  const char* oneOf = "";      // of a text: all allowed values with one blank between them; "": any text
  const char* refersTo = "";   // of a key: the table that it is the key of
  bool anyCharacters = false;  // of a text: may have line breaks and control characters
};

struct IgnoreFields {
  void operator()(const FieldInfo&, const auto&) const {}
};
template <class T>
concept Record = requires(T& record) {
  listFields(record, IgnoreFields{});
};

// Wrappers that a list may give in place of a member itself.

/// A member that is null where `isAbsent`, which may depend on any field. Reading null leaves the member as it is.
template <class Member>
struct NullIf {
  bool isAbsent;
  Member& of;
};
template <class Member>
NullIf(bool, Member&) -> NullIf<Member>;

/// A number that may be infinite or NaN; NaN is written as null.
template <class Real>
struct AnyReal {
  Real& of;
};
template <class Real>
AnyReal(Real&) -> AnyReal<Real>;

/// A number of 64 bits without a sign, which a signed column holds as two's complement.
template <class Number>
struct AllBits {
  Number& of;
};
template <class Number>
AllBits(Number&) -> AllBits<Number>;

/// A text made of members when the record is written. `read` sets the members from the text, or does nothing.
template <class Write, class Read>
struct TextOf {
  Write write;  // std::string()
  Read read;    // void(std::string)
};
template <class Write, class Read>
TextOf(Write, Read) -> TextOf<Write, Read>;

/// A member that is written and read as bytes.
template <class Write, class Read>
struct BytesOf {
  Write write;
  Read read;
};
template <class Write, class Read>
BytesOf(Write, Read) -> BytesOf<Write, Read>;

/// A value of any type made of members, for JSON.
template <class Write, class Read>
struct ValueOf {
  Write write;
  Read read;  // void(the same type)
};
template <class Write, class Read>
ValueOf(Write, Read) -> ValueOf<Write, Read>;

inline constexpr auto notRead = [](const auto&) {};

// Kinds of members, for code that stores or sends them.

template <class T, template <class...> class Kind>
inline constexpr bool isTemplate = false;
template <template <class...> class Kind, class... Of>
inline constexpr bool isTemplate<Kind<Of...>, Kind> = true;
template <class T, template <class...> class Kind>
concept IsTemplate = isTemplate<T, Kind>;
template <class T>
concept IsOptional = IsTemplate<T, std::optional>;
template <class T>
concept HasChoices = std::is_enum_v<T> && requires {
  choices<T>.size();
};

}  // namespace morula
