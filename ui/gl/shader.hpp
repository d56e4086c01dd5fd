#pragma once

#include "ui/style/colour.hpp"

#include <glm/vec2.hpp>

#include <span>
#include <string_view>

namespace forefront {

/// Returns the text of shaders/NAME.glsl, embedded at build time, or null if there is none.
const char *shaderText(std::string_view name);

/// A program linked from shaders/NAME_vertex.glsl and shaders/NAME_fragment.glsl. A shader that fails to compile is a
/// bug: the error is printed and the program ends.
class ShaderProgram {
  public:
    /// Compiles the shaders NAME_vertex and NAME_fragment. `corners`: the name for the vertices, if it is another one.
    explicit ShaderProgram(std::string_view name, std::string_view corners = {});
    ~ShaderProgram();
    ShaderProgram(const ShaderProgram &) = delete;
    ShaderProgram &operator=(const ShaderProgram &) = delete;

    void use() const;
    // Sets a uniform; the program must be in use.
    void set(const char *uniform, float value) const;
    void set(const char *uniform, int value) const;
    void set(const char *uniform, std::span<const float> values) const;
    void set(const char *uniform, const glm::vec2 &value) const;
    void set(const char *uniform, const Colour &colour) const;

  private:
    int location(const char *uniform) const;

    unsigned program_ = 0;
};

} // namespace forefront
