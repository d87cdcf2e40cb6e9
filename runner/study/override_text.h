#pragma once
// A value of a YAML tree as one line that reads back as the same value: how an override holds it.
#include <string>

#include "yaml/node.h"

namespace morula {

/// In YAML's flow notation, as scenario::readYamlValue reads it: texts without quotes stay so where that says the same,
/// so that numbers stay numbers. "null" for nothing.
std::string overrideText(const scenario::Node& node);

}  // namespace morula
