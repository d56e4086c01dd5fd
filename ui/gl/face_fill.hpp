#pragma once

#include "ui/canvas/camera.hpp"
#include "ui/gl/face_raster.hpp"

#include <memory>
#include <vector>

namespace forefront {

struct TexturedView;

/// Tints faces over the canvas. The tints are drawn into a texture, one texel per design pixel, which is kept until
/// the view or the tints change.
class FaceFill {
  public:
    FaceFill();
    ~FaceFill();
    FaceFill(const FaceFill &) = delete;
    FaceFill &operator=(const FaceFill &) = delete;

    /// Draws the faces with one tint each. `scale`: pixels per design pixel; `rimWidth` in design pixels. Needs the
    /// OpenGL context.
    void draw(const std::shared_ptr<const FaceMap> &map, const std::vector<FaceTint> &tints, const Camera &camera,
              double scale, double rimWidth);

  private:
    std::unique_ptr<TexturedView> parts_; ///< null until first used, since most drawings have no regions
    std::shared_ptr<const FaceMap> map_;
    std::vector<FaceTint> tints_;
    Camera camera_;
};

} // namespace forefront
