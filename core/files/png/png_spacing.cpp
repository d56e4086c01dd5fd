#include "core/engine/base/number_text.hpp"
#include "core/files/common/cell_grid.hpp"
#include "core/files/png/png.hpp"

#include <cmath>
#include <string>

namespace forefront {
namespace {

Diagnostics faultsOf(const PictureSizes &sizes) {
    for (const double size : {sizes.black, sizes.white}) {
        if (!(std::isfinite(size) && size > 0.0)) {
            return error("bad-size", "invalid size " + numberText(size, 6) + " of a picture; expected a number above 0",
                         "enter a length in domain units");
        }
    }
    const Vec2 extent = sizes.box.empty() ? Vec2{} : sizes.box.size();
    if (!(((extent.x > 0.0 && extent.y > 0.0) || sizes.around) && isFinite(sizes.box.min) && isFinite(sizes.box.max))) {
        return error("bad-box", "the rectangle of the picture has no area; expected finite corners that differ");
    }
    return {};
}

} // namespace

Result<SpacingSpec> spacingOfPicture(const GreyPicture &picture, const PictureSizes &sizes, const SourceText &source) {
    if (Diagnostics faults = faultsOf(sizes); !faults.empty()) {
        return faults;
    }
    if (picture.columns < picture.pixelColumns || picture.rows < picture.pixelRows) {
        source.note("picture-averaged",
                    "the picture has " + std::to_string(picture.pixelColumns) + " x " +
                        std::to_string(picture.pixelRows) + " pixels; averaged to " + std::to_string(picture.columns) +
                        " x " + std::to_string(picture.rows),
                    0);
    }
    const Box2 box = sizes.around ? pictureBoxAround(sizes.box, static_cast<double>(picture.pixelColumns),
                                                     static_cast<double>(picture.pixelRows))
                                  : sizes.box;
    CellGrid grid;
    grid.columns = picture.columns;
    grid.rows = picture.rows;
    grid.low = box.min;
    grid.step = {box.size().x / static_cast<double>(grid.columns), box.size().y / static_cast<double>(grid.rows)};
    grid.values.reserve(picture.values.size());
    for (const double grey : picture.values) {
        grid.values.push_back(grey == kNoGrey ? 0.0 : sizes.black + grey * (sizes.white - sizes.black));
    }
    return spacingOfGrid(grid, source);
}

Result<SpacingSpec> readPngSpacing(const SourceText &source) {
    if (!source.options.picture) {
        return error("missing-sizes", "a picture has no sizes of its own; expected sizes for black and white",
                     "give both sizes");
    }
    const Result<GreyPicture> picture = readGreyPicture(source, kMaxGridValues);
    return picture ? spacingOfPicture(*picture, *source.options.picture, source) : picture.faults();
}

} // namespace forefront
