#pragma once
// All code that depends on OSMesa, which provides OpenGL without a display. Mesa 25.1 and later lack OSMesa: to use
// another provider there (such as a surfaceless EGL context), change gl_context.cpp; nothing else depends on it.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <memory>
#include <string>

// The functions of OpenGL that are called.
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

// OSMesa's library, and LLVM with it, is loaded with the first context: it takes three quarters of the time that a
// command needs to start, and most draw nothing. Within this namespace OpenGL's names are of pointers to it.
#define MORULA_GL_FUNCTION(name) extern decltype(&::name) name;
MORULA_GL_FUNCTIONS(MORULA_GL_FUNCTION)
#undef MORULA_GL_FUNCTION

/// OpenGL breaks down where memory fails it. Throws a NumericalError that wants memory, with a sentence, if there are
/// not so many bytes; `remedy` ends it.
void requireMemoryToDraw(double bytes, const std::string& remedy);

/// On how many threads to draw: 1 where the system gives no more.
int threadsToDraw();

/// An OpenGL 4.3 core context without a window, current on the thread that made it. It draws into framebuffer
/// objects only. Throws BugError if the library cannot give one, and FileError if it is not there.
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
  std::unique_ptr<Handle> handle_;
};

}  // namespace morula
