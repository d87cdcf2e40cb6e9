#pragma once
// Requests and results as text between two processes: a word, then numbers; doubles in their shortest exact
// form.
#include <iosfwd>

#include "engines/bullet_scene.h"

namespace morula {

void writeRequest(std::ostream& out, const BulletRequest& request);
/// Throws InputError that names what was expected.
BulletRequest readRequest(std::istream& in);

void writeResult(std::ostream& out, const BulletResult& result);
/// Throws InputError that names what was expected.
BulletResult readResult(std::istream& in);

}  // namespace morula
