#include "ui/gl/textured_view.hpp"

#include <glad/gl.h>

namespace forefront {

TexturedView::TexturedView(std::string_view name) : program(name) {
    glGenTextures(1, &texture);
    glGenVertexArrays(1, &emptyArray);
}

TexturedView::~TexturedView() {
    glDeleteTextures(1, &texture);
    glDeleteVertexArrays(1, &emptyArray);
}

} // namespace forefront
