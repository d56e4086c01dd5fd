#pragma once

#include "core/drawing/shapes/plane_map.hpp"
#include "ui/canvas/camera.hpp"
#include "ui/canvas/picture.hpp"

#include <memory>

namespace forefront {

struct TexturedView;

/// A picture in the memory of the graphics card, with smaller copies for when it is seen from afar.
class PictureTexture {
  public:
    PictureTexture();
    ~PictureTexture();
    PictureTexture(const PictureTexture &) = delete;
    PictureTexture &operator=(const PictureTexture &) = delete;

    /// Uploads a picture unless it is the one uploaded last. Needs the OpenGL context, as does draw().
    void update(const std::shared_ptr<const Picture> &picture);
    /// Draws the picture into a rectangle of the plane: the image of the unit square.
    void draw(const Camera &camera, const PlaneMap &unitSquare, double opacity);

  private:
    std::unique_ptr<TexturedView> parts_; ///< null until the first picture, since most drawings have none
    std::shared_ptr<const Picture> uploaded_;
};

} // namespace forefront
