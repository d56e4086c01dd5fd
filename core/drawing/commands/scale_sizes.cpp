#include "core/drawing/commands/scale_sizes.hpp"

#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/engine/spacing/scaled_sizes.hpp"

#include <memory>
#include <string>
#include <utility>

namespace forefront {
namespace {

void scaleShapes(Document &document, double factor) {
    for (auto &pointer : document.shapes) {
        if (pointer->nodeSizes.empty() && pointer->segmentSizes.empty()) {
            continue;
        }
        Shape shape = *pointer;
        for (auto &[handle, size] : shape.nodeSizes) {
            size.size *= factor;
        }
        for (auto &[segment, size] : shape.segmentSizes) {
            size.size *= factor;
        }
        pointer = std::make_shared<const Shape>(std::move(shape));
    }
}

/// Returns the formula of a number after scaling; the formula itself if the number is not scaled.
std::string scaledFormula(const NumberAddress &address, const std::string &formula, double factor,
                          const Document &before, const Document &after) {
    switch (address.quantity) {
    case Quantity::Size:
    case Quantity::EndSize:
    case Quantity::SegmentSize:
        return scaledExpression(formula, factor);
    case Quantity::Maximum:
        return before.spacing.maximum != after.spacing.maximum ? scaledExpression(formula, factor) : formula;
    case Quantity::Area:
        return scaledExpression(formula, factor * factor);
    case Quantity::SegmentsPerTurn:
    case Quantity::ElementsAcross:
        return scaledExpression(formula, 1.0 / factor);
    default:
        return formula;
    }
}

} // namespace

Document scaleSizes(const Document &document, double factor) {
    if (factor == 1.0) {
        return document;
    }
    Document next = document;
    next.spacing = scaledSizes(document.spacing, factor, toDomain(document));
    scaleShapes(next, factor);
    for (MarkedRegion &marker : next.regionMarkers) {
        marker.size *= factor;
        marker.maxArea *= factor * factor;
    }
    for (auto &[address, formula] : next.formulas) {
        formula = scaledFormula(address, formula, factor, document, next);
    }
    pruneFormulas(next);
    return next;
}

} // namespace forefront
