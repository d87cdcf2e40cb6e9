#include "organism/renderer_name.h"

#include <sys/utsname.h>

#include "organism/gl_context.h"

namespace morula {
namespace {

/// "3.3 (Core Profile) Mesa 22.3.6" → "22.3.6".
std::string mesaVersion() {
  const OffscreenContext context;
  const auto* text = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  const std::string version = text ? text : "unknown";
  return version.substr(version.rfind(' ') + 1);
}

}  // namespace

std::string rendererName() {
  utsname machine{};
  const std::string kind = uname(&machine) == 0 ? machine.machine : "unknown";
  return "mesa-" + mesaVersion() + '/' + kind;
}

}  // namespace morula
