#pragma once

#include <epoxy/gl.h>

#include <string>
#include <utility>

namespace smile::camera::internal {

/// Owner of the name of one OpenGL object. Constructed and destroyed while its context is current.
template <class Kind>
class GlObject {
 public:
  GlObject() { Kind::Generate(&name_); }
  ~GlObject() {
    if (name_ != 0) Kind::Delete(&name_);
  }
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }

  GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

struct BufferKind {
  static void Generate(GLuint* name) { glGenBuffers(1, name); }
  static void Delete(const GLuint* name) { glDeleteBuffers(1, name); }
};
struct VertexArrayKind {
  static void Generate(GLuint* name) { glGenVertexArrays(1, name); }
  static void Delete(const GLuint* name) { glDeleteVertexArrays(1, name); }
};
struct TextureKind {
  static void Generate(GLuint* name) { glGenTextures(1, name); }
  static void Delete(const GLuint* name) { glDeleteTextures(1, name); }
};
struct RenderbufferKind {
  static void Generate(GLuint* name) { glGenRenderbuffers(1, name); }
  static void Delete(const GLuint* name) { glDeleteRenderbuffers(1, name); }
};
struct FramebufferKind {
  static void Generate(GLuint* name) { glGenFramebuffers(1, name); }
  static void Delete(const GLuint* name) { glDeleteFramebuffers(1, name); }
};

using Buffer = GlObject<BufferKind>;
using VertexArray = GlObject<VertexArrayKind>;
using Texture = GlObject<TextureKind>;
using Renderbuffer = GlObject<RenderbufferKind>;
using FramebufferName = GlObject<FramebufferKind>;

/// Program of a vertex and a fragment shader.
class Program {
 public:
  /// @throws std::runtime_error with the compiler's log.
  Program(const std::string& vertex_source, const std::string& fragment_source);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void Use() const { glUseProgram(name_); }
  GLint Uniform(const char* name) const { return glGetUniformLocation(name_, name); }

 private:
  GLuint name_;
};

/// @throws std::runtime_error `OpenGL: <doing>: <reason>` if OpenGL has recorded an error since the
///         last check.
void CheckGl(const char* doing);

}  // namespace smile::camera::internal
