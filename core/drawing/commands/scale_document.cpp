#include "core/drawing/commands/scale_document.hpp"

#include "core/drawing/commands/transform.hpp"
#include "core/drawing/formulas/bring_formulas.hpp"
#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/place_formulas.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/number_text.hpp"

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace forefront {
namespace {

void scaleSizes(std::optional<double> &size, double factor) {
    size = size ? std::optional(factor * *size) : std::nullopt;
}

void scalePaint(PaintedSpacing &paint, const PlaneMap &map, double factor) {
    paint.origin = map(paint.origin);
    paint.pitch *= factor;
    for (auto &[place, tile] : paint.tiles) {
        auto scaled = std::make_shared<PaintedSpacing::Tile>(*tile);
        for (float &value : *scaled) {
            value = static_cast<float>(factor * static_cast<double>(value));
        }
        tile = std::move(scaled);
    }
}

/// Scales the spacing except its sources, which are mapped with the drawing.
void scaleSpacing(SpacingSpec &spacing, const PlaneMap &map, double factor) {
    scaleSizes(spacing.size, factor);
    scaleSizes(spacing.minimum, factor);
    scaleSizes(spacing.maximum, factor);
    for (SizeSource &source : spacing.sources) {
        source.size *= factor;
        scaleSizes(source.endSize, factor);
    }
    for (auto &[tag, part] : spacing.partSizes) {
        part.size *= factor;
    }
    scalePaint(spacing.paint, map, factor);
    for (auto &[name, raster] : spacing.rasters) { // the values have units of their own
        Raster scaled = *raster;
        scaled.origin = map(scaled.origin);
        scaled.pitch = factor * scaled.pitch;
        raster = std::make_shared<const Raster>(std::move(scaled));
    }
    if (spacing.background) {
        BackgroundMesh mesh = *spacing.background;
        for (Vec2 &node : mesh.nodes) {
            node = map(node);
        }
        for (double &value : mesh.values) {
            value *= factor;
        }
        spacing.background = std::make_shared<const BackgroundMesh>(std::move(mesh));
    }
}

/// Returns the place on the axis of a coordinate that scaling does not move; 0 for other numbers.
double fixedPlace(Quantity what, Vec2 fixed) {
    const bool across = what == Quantity::X || what == Quantity::X2 || what == Quantity::Left;
    const bool upwards = what == Quantity::Y || what == Quantity::Y2 || what == Quantity::Bottom;
    return across ? fixed.x : upwards ? fixed.y : 0.0;
}

/// Scales the formulas of a document with its numbers.
void scaleFormulas(Document &next, const Document &before, Vec2 fixed, double factor) {
    next.formulas.clear();
    for (const auto &[address, text] : before.formulas) {
        const double rest = (1.0 - factor) * fixedPlace(address.quantity, fixed);
        const std::string scaled = timesLength(text, factor, lengthPower(before, address));
        next.formulas[address] = rest == 0.0 ? scaled : sumFormula(exactText(rest), scaled);
    }
    pruneFormulas(next);
}

} // namespace

Result<Document> scaleDocument(const Document &document, Vec2 fixed, double factor) {
    if (!(factor > 0.0) || !std::isfinite(factor)) {
        return error("bad-number", "invalid factor " + numberText(factor, 6) + "; expected a positive number");
    }
    const PlaneMap map = PlaneMap::scaling({factor, factor}, fixed);
    Result<Document> scaled = transformSelection(document, everythingIn(document), map);
    if (!scaled) {
        return scaled;
    }
    Document next = *std::move(scaled);
    for (auto &pointer : next.shapes) {
        if (!pointer->nodeSizes.empty() || !pointer->segmentSizes.empty()) {
            Shape shape = *pointer;
            for (auto &[segment, size] : shape.segmentSizes) {
                size.size *= factor;
            }
            for (auto &[handle, size] : shape.nodeSizes) {
                size.size *= factor;
            }
            pointer = std::make_shared<const Shape>(std::move(shape));
        }
    }
    for (MarkedRegion &marker : next.regionMarkers) {
        marker.maxArea *= factor * factor;
        marker.size *= factor;
    }
    for (LayerSpec &layer : next.layers) {
        layer.first *= factor;
        scaleSizes(layer.thickness, factor);
    }
    for (StripSpec &spec : next.strips) {
        spec.width *= factor;
    }
    next.curveTolerance *= factor;
    scaleSpacing(next.spacing, map, factor);
    for (Guide &guide : next.guides) {
        const double origin = guide.upright ? fixed.x : fixed.y;
        guide.at = origin + factor * (guide.at - origin);
    }
    if (next.picture) {
        next.picture = scaledAbout(*next.picture, fixed, factor);
    }
    scaleFormulas(next, document, fixed, factor);
    return next;
}

} // namespace forefront
