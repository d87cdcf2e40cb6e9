#include "organism/gl_objects.h"

#include <string>

#include "base/error.h"

namespace morula {
namespace {

GLuint compile(GLenum kind, const std::string& text) {
  const char* source = text.c_str();
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (!good) {
    char log[2048] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    throw BugError(std::string("a shader does not compile: ") + log);
  }
  return shader;
}

}  // namespace

Program::Program(const std::string& vertexSource, const std::string& fragmentSource) : program_(glCreateProgram()) {
  const GLuint vertex = compile(GL_VERTEX_SHADER, vertexSource);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragmentSource);
  glAttachShader(program_, vertex);
  glAttachShader(program_, fragment);
  glLinkProgram(program_);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint good = 0;
  glGetProgramiv(program_, GL_LINK_STATUS, &good);
  if (!good) {
    char log[2048] = "";
    glGetProgramInfoLog(program_, sizeof log, nullptr, log);
    throw BugError(std::string("shaders do not link: ") + log);
  }
}

Program::~Program() { glDeleteProgram(program_); }
void Program::use() const { glUseProgram(program_); }
void Program::set(const char* name, int value) const { glUniform1i(glGetUniformLocation(program_, name), value); }
void Program::set(const char* name, const Texture& texture, int unit) const { texture.bind(unit), set(name, unit); }
void Program::set(const char* name, float value) const { glUniform1f(glGetUniformLocation(program_, name), value); }
void Program::set(const char* name, float x, float y) const { glUniform2f(glGetUniformLocation(program_, name), x, y); }

void Program::set(const char* name, float x, float y, float z) const {
  glUniform3f(glGetUniformLocation(program_, name), x, y, z);
}

void Program::set(const char* name, float x, float y, float z, float w) const {
  glUniform4f(glGetUniformLocation(program_, name), x, y, z, w);
}

void Program::setSize(const char* name, int x, int y) const { glUniform2i(glGetUniformLocation(program_, name), x, y); }

void Program::setMatrix(const char* name, const float* columns16) const {
  glUniformMatrix4fv(glGetUniformLocation(program_, name), 1, GL_FALSE, columns16);
}

Texture::Texture(int width, int height, GLenum internalFormat) : width_(width) {
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  GLenum format = GL_RGBA, type = GL_FLOAT;
  if (internalFormat == GL_R32UI) format = GL_RED_INTEGER, type = GL_UNSIGNED_INT;
  if (internalFormat == GL_DEPTH_COMPONENT32F) format = GL_DEPTH_COMPONENT;
  if (internalFormat == GL_DEPTH32F_STENCIL8) format = GL_DEPTH_STENCIL, type = GL_FLOAT_32_UNSIGNED_INT_24_8_REV;
  glTexImage2D(GL_TEXTURE_2D, 0, GLint(internalFormat), width, height, 0, format, type, nullptr);
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, name, GL_NEAREST);
  for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, name, GL_CLAMP_TO_EDGE);
}

Texture::~Texture() { glDeleteTextures(1, &texture_); }

void Texture::bind(int unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture_);
}

void Texture::setRows(int first, int rows, const float* texels) const {
  bind(15);  // a unit that no shader uses, so that bindings of other units stay
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, first, width_, rows, GL_RGBA, GL_FLOAT, texels);
}

Framebuffer::Framebuffer(std::initializer_list<const Texture*> colours, const Texture* depth, bool hasStencil) {
  glGenFramebuffers(1, &framebuffer_);
  bind();
  std::vector<GLenum> targets;
  for (const Texture* colour : colours) {
    targets.push_back(GLenum(GL_COLOR_ATTACHMENT0 + targets.size()));
    glFramebufferTexture2D(GL_FRAMEBUFFER, targets.back(), GL_TEXTURE_2D, colour->id(), 0);
  }
  if (depth)
    glFramebufferTexture2D(GL_FRAMEBUFFER, hasStencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                           GL_TEXTURE_2D, depth->id(), 0);
  glDrawBuffers(GLsizei(targets.size()), targets.data());
  MORULA_CHECK(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE, "OpenGL refuses the textures");
}

Framebuffer::~Framebuffer() { glDeleteFramebuffers(1, &framebuffer_); }
void Framebuffer::bind() const { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_); }

VertexBuffer::VertexBuffer(const void* data, std::size_t bytes, std::size_t stride,
                           std::initializer_list<VertexAttribute> attributes,
                           const std::vector<std::uint32_t>& indices) {
  glGenVertexArrays(1, &array_);
  glBindVertexArray(array_);
  glGenBuffers(1, &buffer_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(bytes), data, GL_STATIC_DRAW);
  if (!indices.empty()) {
    glGenBuffers(1, &indices_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(4 * indices.size()), indices.data(), GL_STATIC_DRAW);
  }
  GLuint location = 0;
  for (const VertexAttribute& attribute : attributes) {
    const void* offset = reinterpret_cast<const void*>(attribute.offset);
    glEnableVertexAttribArray(location);
    if (attribute.integer)
      glVertexAttribIPointer(location, attribute.components, attribute.type, GLsizei(stride), offset);
    else
      glVertexAttribPointer(location, attribute.components, attribute.type, attribute.normalised, GLsizei(stride),
                            offset);
    ++location;
  }
}

VertexBuffer::~VertexBuffer() {
  glDeleteBuffers(1, &buffer_);
  glDeleteBuffers(1, &indices_);
  glDeleteVertexArrays(1, &array_);
}

void VertexBuffer::drawTriangles(std::size_t firstCorner, std::size_t corners) const {
  glBindVertexArray(array_);
  if (indices_)
    glDrawElements(GL_TRIANGLES, GLsizei(corners), GL_UNSIGNED_INT, reinterpret_cast<const void*>(4 * firstCorner));
  else glDrawArrays(GL_TRIANGLES, GLint(firstCorner), GLsizei(corners));
}

void VertexBuffer::drawTriangles(const std::vector<std::pair<std::size_t, std::size_t>>& parts) const {
  glBindVertexArray(array_);
  std::vector<GLsizei> counts;
  std::vector<const void*> offsets;
  for (const auto& [first, corners] : parts) {
    counts.push_back(GLsizei(corners));
    offsets.push_back(reinterpret_cast<const void*>(4 * first));
  }
  glMultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, offsets.data(), GLsizei(parts.size()));
}

}  // namespace morula
