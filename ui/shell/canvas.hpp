#pragma once

#include "ui/canvas/canvas_painter.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace forefront {

class BackgroundList;
struct Shell;

/// The drawing area: draws all visible layers beneath the windows of Dear ImGui. The still parts of the layers are kept
/// in a texture.
class Canvas {
  public:
    /// `list`: of the window; it outlives the canvas.
    explicit Canvas(BackgroundList &list);
    ~Canvas();
    Canvas(const Canvas &) = delete;
    Canvas &operator=(const Canvas &) = delete;

    /// Draws to the target framebuffer, and overlays to Dear ImGui's background list. Call between NewFrame and Render.
    void draw(Shell &context);
    /// Returns how often the still parts were redrawn; for tests.
    std::uint64_t stillDraws() const;
    /// Returns the bytes that the meshes drawn take up here and in buffers of OpenGL; for tests.
    std::size_t meshBytes() const;
    /// Returns how often the segments of the front around an advance were searched for; for tests.
    std::size_t frontWalks() const;
    /// Returns the labels of the last frame; for tests.
    const std::vector<CanvasPainter::Placed> &labels() const;
    /// Returns true while the picture of a new large mesh is incomplete; a further mesh would restart it.
    bool pictureIncomplete() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace forefront
