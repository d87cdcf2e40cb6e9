#include "organism/renderer_name.h"

#include <ft2build.h>
#include FT_FREETYPE_H
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

std::string freetypeVersion() {
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library)) return "unknown";
  FT_Int major = 0, minor = 0, patch = 0;
  FT_Library_Version(library, &major, &minor, &patch);
  FT_Done_FreeType(library);
  return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(patch);
}

}  // namespace

std::string rendererName() {
  utsname machine{};
  const std::string kind = uname(&machine) == 0 ? machine.machine : "unknown";
  return "mesa-" + mesaVersion() + "/freetype-" + freetypeVersion() + '/' + kind;
}

}  // namespace morula
