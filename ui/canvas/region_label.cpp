#include "ui/canvas/region_label.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace forefront {

std::vector<Pixel> regionLabelOffsets(const CanvasPainter &painter, const FaceMap *faces, Vec2 marker,
                                      std::string_view name, ImFont *font) {
    constexpr double kRight = 12.0, kLevel = -8.0, kAbove = -28.0, kBelow = 12.0; // design pixels from the marker
    const double width = painter.labelRect(marker, {}, name, font).width / painter.scale();
    const double centred = 5.0 - 0.5 * width, left = 10.0 - kRight - width;
    std::vector<Pixel> offsets{{kRight, kLevel}, {centred, kBelow}, {centred, kAbove}, {left, kLevel},
                               {kRight, kBelow}, {kRight, kAbove},  {left, kBelow},    {left, kAbove}};
    const std::uint32_t face = faces != nullptr ? faces->faceAt(marker) : kNoIndex;
    if (face == kNoIndex) {
        return offsets;
    }
    std::stable_partition(offsets.begin(), offsets.end(), [&](Pixel offset) {
        const PixelRect rect = painter.labelRect(marker, offset, name, font);
        const std::array<Pixel, 4> corners{{{rect.x, rect.y},
                                            {rect.x + rect.width, rect.y},
                                            {rect.x, rect.y + rect.height},
                                            {rect.x + rect.width, rect.y + rect.height}}};
        return std::all_of(corners.begin(), corners.end(),
                           [&](Pixel corner) { return faces->faceAt(painter.camera().toPlane(corner)) == face; });
    });
    return offsets;
}

} // namespace forefront
