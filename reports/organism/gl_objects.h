#pragma once
// OpenGL objects that free themselves, with only the functions that pictures need.
#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "organism/gl_context.h"

namespace morula {

/// A linked pair of shaders. Throws BugError with the compiler's text if the sources are wrong.
class Program {
 public:
  Program(const std::string& vertexSource, const std::string& fragmentSource);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void use() const;
  /// Set uniforms of the program in use; a texture is also bound to the unit. Names that the shader does not use are
  /// ignored.
  void set(const char* name, int value) const;
  void set(const char* name, const class Texture& texture, int unit) const;
  void set(const char* name, float value) const;
  void set(const char* name, float x, float y) const;
  void set(const char* name, float x, float y, float z) const;
  void set(const char* name, float x, float y, float z, float w) const;
  void setSize(const char* name, int x, int y) const;
  void setMatrix(const char* name, const float* columns16) const;

 private:
  GLuint program_;
};

/// A texture as large as a picture, read texel by texel.
class Texture {
 public:
  Texture(int width, int height, GLenum internalFormat);
  ~Texture();
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;
  GLuint id() const { return texture_; }
  void bind(int unit) const;
  /// Sets rows of a GL_RGBA32F texture, counted from the bottom, four numbers to a texel.
  void setRows(int first, int rows, const float* texels) const;

 private:
  GLuint texture_;
  int width_;
};

/// A target for drawing: colour textures, up to the first null one, and optionally a depth texture, which may hold a
/// stencil.
class Framebuffer {
 public:
  Framebuffer(std::initializer_list<const Texture*> colours, const Texture* depth, bool hasStencil = false);
  ~Framebuffer();
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;
  void bind() const;

 private:
  GLuint framebuffer_;
};

struct VertexAttribute {
  GLint components;
  GLenum type;
  bool integer;     // the shader reads an integer
  bool normalised;  // the shader reads 0..255 as 0..1
  std::size_t offset;
};

/// Vertices on the graphics side; attribute number i is at location i. Each three vertices are a triangle, or, with
/// indices, each three indices.
class VertexBuffer {
 public:
  VertexBuffer(const void* data, std::size_t bytes, std::size_t stride,
               std::initializer_list<VertexAttribute> attributes, const std::vector<std::uint32_t>& indices = {});
  ~VertexBuffer();
  VertexBuffer(const VertexBuffer&) = delete;
  VertexBuffer& operator=(const VertexBuffer&) = delete;
  void drawTriangles(std::size_t firstCorner, std::size_t corners) const;
  /// Draws several ranges of the indices, one after the other: first corner and number of corners.
  void drawTriangles(const std::vector<std::pair<std::size_t, std::size_t>>& parts) const;

 private:
  GLuint buffer_ = 0, array_ = 0, indices_ = 0;
};

}  // namespace morula
