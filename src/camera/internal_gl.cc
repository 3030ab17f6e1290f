#include "camera/internal_gl.h"

#include <stdexcept>

namespace smile::camera::internal {
namespace {

using GetLog = void (*)(GLuint, GLsizei, GLsizei*, GLchar*);

/// Throws std::runtime_error with the log of the driver's compiler.
[[noreturn]] void FailWithLog(const char* call, GetLog get_log, GLuint name) {
  char log[2048] = "";
  get_log(name, sizeof log, nullptr, log);
  throw std::runtime_error(std::string("OpenGL: ") + call + ": " + log);
}

/// Compiles a shader and adds it to a program.
/// @throws std::runtime_error with the compiler's log.
void Attach(GLuint program, GLenum kind, const std::string& source) {
  const GLuint shader = glCreateShader(kind);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint is_compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &is_compiled);
  if (!is_compiled) FailWithLog("glCompileShader", glGetShaderInfoLog, shader);
  glAttachShader(program, shader);
  glDeleteShader(shader);  // is deleted with its program
}

std::string NameOf(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "out of memory";
    default:
      return "error " + std::to_string(error);
  }
}

}  // namespace

Program::Program(const std::string& vertex_source, const std::string& fragment_source)
    : name_(glCreateProgram()) {
  // Prepended here, as it must be the first line of each shader.
  const std::string version = "#version 330 core\n";
  Attach(name_, GL_VERTEX_SHADER, version + vertex_source);
  Attach(name_, GL_FRAGMENT_SHADER, version + fragment_source);
  glLinkProgram(name_);
  GLint is_linked = 0;
  glGetProgramiv(name_, GL_LINK_STATUS, &is_linked);
  if (!is_linked) FailWithLog("glLinkProgram", glGetProgramInfoLog, name_);
}

Program::~Program() { glDeleteProgram(name_); }

void CheckGl(const char* doing) {
  // Errors are recorded by OpenGL and read once per picture: reading after each call would make the
  // driver wait.
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  // OpenGL may have recorded several errors; later checks must not report these again.
  while (glGetError() != GL_NO_ERROR) continue;
  throw std::runtime_error(std::string("OpenGL: ") + doing + ": " + NameOf(error));
}

}  // namespace smile::camera::internal
