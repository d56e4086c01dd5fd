#pragma once

#include "tests/ui/edit_driver.hpp"
#include "ui/style/colour.hpp"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>

namespace forefront::test {

/// A rectangle with a mesh of about 170 elements, large enough to look at and to click.
class MeshedSquare : public Draughtsman {
  public:
    MeshedSquare() {
        rectangle({1, 1}, {9, 8});
        Document sized = document();
        sized.spacing.size = 0.9;
        context().document.apply(std::move(sized), "Size");
        key('V');
        key(key::kEscape);
        key(key::kF5);
        settle();
    }
    const TriMesh &mesh() { return run().mesh->mesh; }
    Vec2 nodeAt(std::size_t element, std::size_t corner) {
        return mesh().nodes[index(mesh().elements[element][corner])];
    }
    Vec2 middleOf(std::size_t element) {
        return (1.0 / 3.0) * (nodeAt(element, 0) + nodeAt(element, 1) + nodeAt(element, 2));
    }
    void hideLayers(std::initializer_list<const char *> layers) {
        for (const char *layer : layers) {
            showLayer(context().layers, layer, false);
        }
    }
};

/// Returns the largest difference between two colours in any channel, 0 to 255.
inline int difference(Colour a, Colour b) {
    const glm::ivec3 d = glm::abs(glm::ivec3(a) - glm::ivec3(b));
    return std::max({d.r, d.g, d.b});
}

inline Colour colourAt(const Driver::Picture &picture, Pixel pixel) {
    const auto at = 4 * (static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(picture.size.width) +
                         static_cast<std::size_t>(pixel.x));
    return rgb(static_cast<std::uint32_t>(picture.rgba[at] << 16 | picture.rgba[at + 1] << 8 | picture.rgba[at + 2]));
}

} // namespace forefront::test
