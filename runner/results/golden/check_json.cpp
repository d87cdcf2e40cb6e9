#include "golden/check_json.h"

namespace morula {

Json toJson(const CheckResult& r) {
  return {{"check", r.check},
          {"kind", r.kind},
          {"passed", r.passed},
          {"class", r.failureClass},
          {"first_step", orNull(r.firstStep)},
          {"cell", orNull(r.cell)},
          {"field", r.field},
          {"share_of_tolerance", orNull(r.share)},
          {"expected", r.expected},
          {"actual", r.actual},
          {"tolerance", r.tolerance},
          {"message", r.message}};
}

CheckResult checkResultFrom(const Json& j) {
  CheckResult r;
  j.at("check").get_to(r.check), j.at("kind").get_to(r.kind), j.at("expected").get_to(r.expected);
  j.at("actual").get_to(r.actual), j.at("tolerance").get_to(r.tolerance), j.at("passed").get_to(r.passed);
  j.at("field").get_to(r.field), j.at("class").get_to(r.failureClass), j.at("message").get_to(r.message);
  if (!j.at("first_step").is_null()) r.firstStep = j["first_step"].get<std::uint64_t>();
  if (!j.at("cell").is_null()) r.cell = j["cell"].get<std::string>();
  if (!j.at("share_of_tolerance").is_null()) r.share = j["share_of_tolerance"].get<double>();
  return r;
}

}  // namespace morula
