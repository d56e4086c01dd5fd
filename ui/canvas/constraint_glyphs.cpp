#include "ui/canvas/constraint_glyphs.hpp"

#include "ui/style/icons.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace forefront {
namespace {

constexpr double kLabelRim = 5.0, kLabelRimY = 2.0; ///< of the plate around a text, see CanvasPainter::labelRect()
constexpr double kFromLine = 8.0;                   ///< between a line and the plates beside it

} // namespace

const char *glyphOf(ConstraintKind kind) {
    constexpr std::array<const char *, 13> kGlyphs = {
        icon::kMarkCoincident, icon::kMarkOnCurve,  icon::kMarkMidpoint,      icon::kMarkHorizontal,
        icon::kMarkVertical,   icon::kMarkParallel, icon::kMarkPerpendicular, icon::kMarkCollinear,
        icon::kMarkTangent,    icon::kMarkEqual,    icon::kMarkConcentric,    icon::kMarkSymmetric,
        icon::kMarkFixed};
    return isDimension(kind) ? "" : kGlyphs[static_cast<std::size_t>(kind)];
}

std::vector<Pixel> glyphOffsets(const GlyphAnchor &anchor, Pixel size, double gap) {
    const Pixel along{anchor.along.x, -anchor.along.y};
    const Pixel up = along.x >= 0.0 ? Pixel(along.y, -along.x) : Pixel(-along.y, along.x); // upper side of the line
    const Pixel half = 0.5 * size;
    // The distance of two plates that touch along a direction, and of a plate from the line.
    const auto reach = [&](Pixel way) {
        const double x = std::abs(way.x) > 1e-9 ? half.x / std::abs(way.x) : 1e9;
        const double y = std::abs(way.y) > 1e-9 ? half.y / std::abs(way.y) : 1e9;
        return std::min(x, y);
    };
    const double step = 2.0 * reach(along) + gap, rise = 2.0 * reach(up) + gap;
    const double first = std::abs(up.x) * half.x + std::abs(up.y) * half.y + kFromLine;
    std::vector<Pixel> offsets;
    for (int row = 0; row < 3; ++row) {
        for (const double side : {1.0, -1.0}) {
            for (const int place : {0, 1, -1, 2, -2, 3, -3}) {
                const Pixel middle = side * (first + row * rise) * up + (place * step) * along;
                offsets.push_back(middle - half + Pixel(kLabelRim, kLabelRimY));
            }
        }
    }
    return offsets;
}

std::string dimensionText(const Document &document, const SketchConstraint &constraint) {
    const char *before = constraint.kind == ConstraintKind::Radius     ? "R "
                         : constraint.kind == ConstraintKind::Diameter ? "\xe2\x88\x85 "
                                                                       : "";
    const char *after = constraint.kind == ConstraintKind::Angle ? "\xc2\xb0" : "";
    const auto formula = document.formulas.find({NumberOwner::ofConstraint(constraint.id), Quantity::Value});
    const std::string value = before + ui::number(constraint.value, 5) + after;
    return formula == document.formulas.end() ? value : formula->second + " = " + value;
}

} // namespace forefront
