#pragma once
// All code that depends on OSMesa, which provides OpenGL without a display. Mesa 25.1 and later lack OSMesa: to use another
// provider there (such as a surfaceless EGL context), change gl_context.cpp and the link line; nothing else depends on it.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <string>

namespace morula {

/// OpenGL breaks down where memory fails it. Throws a NumericalError that wants memory, with a sentence, if there are not so
/// many bytes; `remedy` ends it.
void requireMemoryToDraw(double bytes, const std::string& remedy);

/// An OpenGL 4.3 core context without a window, current on the thread that made it. It draws into framebuffer
/// objects only. Throws BugError if the library cannot give one.
class OffscreenContext {
 public:
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  /// Other code on this thread may have made another context current meanwhile.
  void makeCurrent();

 private:
  struct Handle;
  Handle* handle_;
};

}  // namespace morula
