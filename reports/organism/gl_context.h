#pragma once
// The OpenGL context of OSMesa, which needs no display. Mesa 25.1 and later lack OSMesa: another provider (such as a
// surfaceless EGL context) would replace gl_context.cpp; nothing else depends on OSMesa.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <memory>
#include <string>

// The OpenGL functions in use.
// clang-format off
#define MORULA_GL_FUNCTIONS(X) \
  X(glActiveTexture) X(glAttachShader) X(glBindBuffer) X(glBindBufferBase) X(glBindFramebuffer) X(glBindTexture) \
  X(glBindVertexArray) X(glBufferData) X(glCheckFramebufferStatus) X(glClearBufferfv) X(glClearBufferiv) \
  X(glClearBufferuiv) X(glColorMask) X(glCompileShader) X(glCreateProgram) X(glCreateShader) X(glCullFace) \
  X(glDeleteBuffers) X(glDeleteFramebuffers) X(glDeleteProgram) X(glDeleteShader) X(glDeleteTextures) \
  X(glDeleteVertexArrays) X(glDepthFunc) X(glDepthMask) X(glDisable) X(glDrawArrays) X(glDrawBuffers) \
  X(glDrawElements) X(glEnable) X(glEnableVertexAttribArray) X(glFramebufferTexture2D) X(glGenBuffers) \
  X(glGenFramebuffers) X(glGenTextures) X(glGenVertexArrays) X(glGetProgramInfoLog) X(glGetProgramiv) \
  X(glGetShaderInfoLog) X(glGetShaderiv) X(glGetString) X(glGetUniformLocation) X(glLinkProgram) X(glMapBufferRange) \
  X(glMemoryBarrier) X(glMultiDrawElements) X(glPixelStorei) X(glReadBuffer) X(glReadPixels) X(glScissor) \
  X(glShaderSource) X(glStencilFunc) X(glStencilOp) X(glStencilOpSeparate) X(glTexImage2D) X(glTexParameteri) \
  X(glTexSubImage2D) X(glUniform1f) X(glUniform1i) X(glUniform2f) X(glUniform2i) X(glUniform3f) \
  X(glUniform4f) X(glUniformMatrix4fv) X(glUnmapBuffer) X(glUseProgram) X(glVertexAttribIPointer) \
  X(glVertexAttribPointer) X(glViewport)
// clang-format on

namespace morula {

// The first context loads OSMesa's library, and LLVM with it: linked, they would take three quarters of the start of
// every command, and most commands draw nothing. Within this namespace OpenGL's names are pointers to functions of the
// library.
#define MORULA_GL_FUNCTION(name) extern decltype(&::name) name;
MORULA_GL_FUNCTIONS(MORULA_GL_FUNCTION)
#undef MORULA_GL_FUNCTION

/// Throws NumericalError that wants memory if there are not `bytes` free, because OpenGL crashes when memory runs out.
/// `remedy` ends its message.
void requireMemoryToDraw(double bytes, const std::string& remedy);

/// Returns the number of threads to draw with; 1 if the system has no more.
int threadsToDraw();

/// An OpenGL 4.3 core context without a window, current on the thread that made it. It draws only into framebuffer
/// objects. Throws BugError if the library gives no context, and FileError if the library is missing.
class OffscreenContext {
 public:
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  /// Makes the context current again, for other code on this thread may have made another context current.
  void makeCurrent();

 private:
  struct Handle;
  std::unique_ptr<Handle> handle_;
};

}  // namespace morula
