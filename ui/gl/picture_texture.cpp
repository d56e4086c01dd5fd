#include "ui/gl/picture_texture.hpp"

#include "ui/gl/textured_view.hpp"

#include <glad/gl.h>

namespace forefront {

PictureTexture::PictureTexture() = default;

PictureTexture::~PictureTexture() = default;

void PictureTexture::update(const std::shared_ptr<const Picture> &picture) {
    if (picture == uploaded_) {
        return;
    }
    uploaded_ = picture;
    if (!picture) {
        parts_.reset();
        return;
    }
    if (!parts_) {
        parts_ = std::make_unique<TexturedView>("picture");
    }
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, parts_->texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture->columns, picture->rows, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 picture->rgba.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glGenerateMipmap(GL_TEXTURE_2D);
}

void PictureTexture::draw(const Camera &camera, const PlaneMap &unitSquare, double opacity) {
    if (!parts_) {
        return;
    }
    const ShaderProgram &program = parts_->program;
    program.use();
    // Differences in double precision, so that a picture far from the origin does not tremble.
    const Vec2 origin = camera.zoom * (unitSquare.shift - camera.centre);
    const Vec2 right = camera.zoom * unitSquare.u, up = camera.zoom * unitSquare.v;
    program.set("origin", glm::vec2(origin.x, origin.y));
    program.set("right", glm::vec2(right.x, right.y));
    program.set("up", glm::vec2(up.x, up.y));
    program.set("viewport", glm::vec2(camera.viewport.width, camera.viewport.height));
    program.set("opacity", static_cast<float>(opacity));
    program.set("picture", 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, parts_->texture);
    glBindVertexArray(parts_->emptyArray);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glBindVertexArray(0);
}

} // namespace forefront
