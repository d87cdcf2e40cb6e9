#pragma once
// A value of a YAML tree as one line that reads back as the same value: how an override holds it.
#include <string>

#include "yaml/node.h"

namespace morula {

/// In YAML's flow notation, as scenario::readYamlValue reads it. A text without quotes gets none where it reads back as
/// the same without them, so that numbers stay numbers. "null" for an empty value.
std::string overrideText(const scenario::Node& node);

}  // namespace morula
