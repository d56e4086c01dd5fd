#pragma once

#include "ui/gl/shader.hpp"

#include <string_view>

namespace forefront {

/// The OpenGL objects for drawing a texture over the view: a program that makes its own vertices, a texture, and an
/// array without attributes. The OpenGL context must be current.
struct TexturedView {
    /// Compiles the program of a name: see ShaderProgram.
    explicit TexturedView(std::string_view name);
    ~TexturedView();
    TexturedView(const TexturedView &) = delete;
    TexturedView &operator=(const TexturedView &) = delete;

    ShaderProgram program;
    unsigned texture = 0, emptyArray = 0;
};

} // namespace forefront
