#include "ui/gl/line_batch.hpp"

#include "ui/gl/gl_kit.hpp"

#include <glad/gl.h>

#include <cstddef>

namespace forefront {

namespace {

void pointAttribute(unsigned location, std::size_t stride, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, 4, GL_FLOAT, GL_FALSE, static_cast<int>(stride),
                          // OpenGL takes the offset as a pointer. NOLINTNEXTLINE(performance-no-int-to-ptr)
                          reinterpret_cast<const void *>(offset));
    glVertexAttribDivisor(location, 1);
}

void colourAttribute(unsigned location, std::size_t stride, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, 4, GL_UNSIGNED_BYTE, GL_TRUE, static_cast<int>(stride),
                          // OpenGL takes the offset as a pointer. NOLINTNEXTLINE(performance-no-int-to-ptr)
                          reinterpret_cast<const void *>(offset));
    glVertexAttribDivisor(location, 1);
}

template <class Item>
void upload(unsigned buffer, const std::vector<Item> &items) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(items.size() * sizeof(Item)), items.data(), GL_DYNAMIC_DRAW);
}

} // namespace

LineBatch::LineBatch() {
    glGenVertexArrays(1, &array_);
    glGenBuffers(1, &buffer_);
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    pointAttribute(0, sizeof(Segment), offsetof(Segment, a));
    pointAttribute(1, sizeof(Segment), offsetof(Segment, b));
    colourAttribute(2, sizeof(Segment), offsetof(Segment, colour));
    glBindVertexArray(0);
}

LineBatch::~LineBatch() {
    glDeleteBuffers(1, &buffer_);
    glDeleteVertexArrays(1, &array_);
}

void LineBatch::add(Vec2 a, Vec2 b, Colour colour) {
    segments_.push_back({SplitPoint(a), SplitPoint(b), colour});
    dirty_ = true;
}

void LineBatch::draw(GlKit &gl, const Camera &camera, const LineStyle &style) {
    if (dirty_) {
        upload(buffer_, segments_);
        dirty_ = false;
    }
    if (segments_.empty()) {
        return;
    }
    const ShaderProgram &program = gl.lines();
    program.use();
    gl.setCamera(program, camera);
    program.set("width", static_cast<float>(style.width));
    program.set("arrow", static_cast<float>(style.arrow));
    glBindVertexArray(array_);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<int>(segments_.size()));
    glBindVertexArray(0);
}

BoxBatch::BoxBatch() {
    glGenVertexArrays(1, &array_);
    glGenBuffers(1, &buffer_);
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    pointAttribute(0, sizeof(Box), offsetof(Box, min));
    pointAttribute(1, sizeof(Box), offsetof(Box, max));
    colourAttribute(2, sizeof(Box), offsetof(Box, fill));
    colourAttribute(3, sizeof(Box), offsetof(Box, frame));
    glBindVertexArray(0);
}

BoxBatch::~BoxBatch() {
    glDeleteBuffers(1, &buffer_);
    glDeleteVertexArrays(1, &array_);
}

void BoxBatch::add(const Box2 &box, Colour fill, Colour frame) {
    boxes_.push_back({SplitPoint(box.min), SplitPoint(box.max), fill, frame});
    dirty_ = true;
}

void BoxBatch::draw(GlKit &gl, const Camera &camera, double frameWidth) {
    if (dirty_) {
        upload(buffer_, boxes_);
        dirty_ = false;
    }
    if (boxes_.empty()) {
        return;
    }
    const ShaderProgram &program = gl.boxes();
    program.use();
    gl.setCamera(program, camera);
    program.set("frameWidth", static_cast<float>(frameWidth));
    glBindVertexArray(array_);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<int>(boxes_.size()));
    glBindVertexArray(0);
}

} // namespace forefront
