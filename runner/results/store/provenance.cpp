#include "store/provenance.h"

namespace morula {
namespace {

bool isIdentity(RunPart part) { return part == RunPart::scene || part == RunPart::program; }
bool isCondition(RunPart part) { return isIdentity(part) || part == RunPart::detail || part == RunPart::environment; }

std::vector<Item> compare(const RunRecord& before, const RunRecord& now, bool (*takes)(RunPart)) {
  std::vector<Item> items;
  eachFieldOf({.id = {}, .record = before, .started = {}, .ended = {}, .stateHash = {}, .failure = {}},
              [&](const RunField& field, const std::string& value) {
                if (takes(field.part)) items.push_back({field.name, field.label, value, {}});
              });
  std::size_t i = 0;
  eachFieldOf({.id = {}, .record = now, .started = {}, .ended = {}, .stateHash = {}, .failure = {}},
              [&](const RunField& field, const std::string& value) {
                if (takes(field.part)) items[i++].now = value;
              });
  return items;
}

}  // namespace

std::vector<Item> compareIdentity(const RunRecord& before, const RunRecord& now) {
  return compare(before, now, isIdentity);
}

std::vector<Item> compareConditions(const RunRecord& before, const RunRecord& now) {
  return compare(before, now, isCondition);
}

}  // namespace morula
