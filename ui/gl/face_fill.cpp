#include "ui/gl/face_fill.hpp"

#include "ui/gl/textured_view.hpp"

#include <glad/gl.h>

#include <cmath>

namespace forefront {

FaceFill::FaceFill() = default;

FaceFill::~FaceFill() = default;

void FaceFill::draw(const std::shared_ptr<const FaceMap> &map, const std::vector<FaceTint> &tints, const Camera &camera,
                    double scale, double rimWidth) {
    if (!parts_) {
        parts_ = std::make_unique<TexturedView>("faces");
    }
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, parts_->texture);
    if (map != map_ || tints != tints_ || camera != camera_) {
        map_ = map;
        tints_ = tints;
        camera_ = camera;
        Camera coarse = camera;
        coarse.zoom = camera.zoom / scale;
        coarse.viewport = {0, 0, std::ceil(camera.viewport.width / scale), std::ceil(camera.viewport.height / scale)};
        const std::vector<Colour> pixels = rasteriseFaces(*map, tints, coarse, rimWidth);
        const int filter = scale == 1.0 ? GL_NEAREST : GL_LINEAR;
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, static_cast<int>(coarse.viewport.width),
                     static_cast<int>(coarse.viewport.height), 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    }
    const ShaderProgram &program = parts_->program;
    program.use();
    program.set("faces", 0);
    // The texture has the centre of the view in its middle, and may reach a little beyond the view.
    program.set("extent", glm::vec2(camera.viewport.width / (scale * std::ceil(camera.viewport.width / scale)),
                                    camera.viewport.height / (scale * std::ceil(camera.viewport.height / scale))));
    glBindVertexArray(parts_->emptyArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

} // namespace forefront
