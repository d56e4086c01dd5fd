#include "ui/gl/shader.hpp"

#include <glad/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace forefront {

namespace {

[[noreturn]] void fail(const std::string &what, const char *log) {
    std::fprintf(stderr, "shader %s: %s\n", what.c_str(), log);
    std::abort();
}

unsigned compile(unsigned kind, const std::string &name) {
    const char *text = shaderText(name);
    if (text == nullptr) {
        fail(name, "not embedded");
    }
    const unsigned shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    int done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done == 0) {
        std::array<char, 2048> log{};
        glGetShaderInfoLog(shader, static_cast<int>(log.size()), nullptr, log.data());
        fail(name, log.data());
    }
    return shader;
}

} // namespace

ShaderProgram::ShaderProgram(std::string_view name, std::string_view corners) : program_(glCreateProgram()) {
    const unsigned vertex = compile(GL_VERTEX_SHADER, std::string(corners.empty() ? name : corners) + "_vertex");
    const unsigned fragment = compile(GL_FRAGMENT_SHADER, std::string(name) + "_fragment");
    glAttachShader(program_, vertex);
    glAttachShader(program_, fragment);
    glLinkProgram(program_);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    int done = 0;
    glGetProgramiv(program_, GL_LINK_STATUS, &done);
    if (done == 0) {
        std::array<char, 2048> log{};
        glGetProgramInfoLog(program_, static_cast<int>(log.size()), nullptr, log.data());
        fail(std::string(name), log.data());
    }
}

ShaderProgram::~ShaderProgram() {
    glDeleteProgram(program_);
}

void ShaderProgram::use() const {
    glUseProgram(program_);
}

int ShaderProgram::location(const char *uniform) const {
    return glGetUniformLocation(program_, uniform);
}

void ShaderProgram::set(const char *uniform, float value) const {
    glUniform1f(location(uniform), value);
}
void ShaderProgram::set(const char *uniform, int value) const {
    glUniform1i(location(uniform), value);
}
void ShaderProgram::set(const char *uniform, std::span<const float> values) const {
    glUniform1fv(location(uniform), static_cast<int>(values.size()), values.data());
}
void ShaderProgram::set(const char *uniform, const glm::vec2 &value) const {
    glUniform2fv(location(uniform), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char *uniform, const Colour &colour) const {
    glUniform4fv(location(uniform), 1, glm::value_ptr(colour.channels()));
}

} // namespace forefront
