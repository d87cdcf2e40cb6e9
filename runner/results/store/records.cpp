#include "store/records.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/number_text.h"

namespace morula {
namespace {

template <class Member>
std::string valueText(const Member& member) {
  if constexpr (requires { member.isAbsent; }) return member.isAbsent ? "" : valueText(member.of);
  else if constexpr (IsOptional<Member>) return member ? valueText(*member) : "";
  else if constexpr (IsTemplate<Member, AllBits>) return valueText(member.of);
  else if constexpr (IsTemplate<Member, TextOf>) return member.write();
  else if constexpr (HasChoices<Member>) return nameOf(member);
  else if constexpr (std::floating_point<Member>) return numberText(member);
  else if constexpr (std::integral<Member>) return std::to_string(member);
  else return member;
}

bool isIdentity(RunPart part) { return part == RunPart::scene || part == RunPart::program; }
bool isCondition(RunPart part) { return isIdentity(part) || part == RunPart::detail || part == RunPart::environment; }

std::vector<Item> compare(const RunRecord& before, const RunRecord& now, bool (*takes)(RunPart)) {
  std::vector<Item> items;
  eachFieldOf({.record = before}, [&](const RunField& field, const std::string& value) {
    if (takes(field.part)) items.push_back({field.name, field.label, value, {}});
  });
  auto item = items.begin();
  eachFieldOf({.record = now}, [&](const RunField& field, const std::string& value) {
    if (takes(field.part)) (item++)->now = value;
  });
  return items;
}

}  // namespace

void eachFieldOf(const StoredRun& run, const std::function<void(const RunField&, const std::string&)>& visit) {
  listFields(run, [&](const RunField& field, const auto& member) { visit(field, valueText(member)); });
}

std::string headingOf(const RunField& field) {
  std::string label = field.label;
  label[0] = static_cast<char>(std::toupper(label[0]));
  return label;
}

std::vector<Item> compareIdentity(const RunRecord& before, const RunRecord& now) {
  return compare(before, now, isIdentity);
}

std::vector<Item> compareConditions(const RunRecord& before, const RunRecord& now) {
  return compare(before, now, isCondition);
}

RunPart partOf(const std::string& column) {
  static const auto parts = [] {
    std::map<std::string, RunPart> parts;
    eachFieldOf({}, [&](const RunField& field, const std::string&) { parts[field.name] = field.part; });
    return parts;
  }();
  return parts.at(column);
}

std::string runId(const RunRecord& record) {
  Hasher hasher;
  hasher.field("scenario_hash").add(record.scenarioHash);
  if (!record.referenceHash.empty()) hasher.field("reference_hash").add(record.referenceHash);
  hasher.field("seed").add(record.seed);
  hasher.field("build_id").add(buildId(record.build));
  return hasher.digest().text().substr(0, 16);  // 64 bits: a million runs collide with probability 3e-8
}

void sortByDistance(std::vector<AgainstCell>& cells) {
  std::ranges::sort(cells, {}, [](const AgainstCell& c) { return std::pair(-c.distance.value_or(-1), c.path); });
}

}  // namespace morula
