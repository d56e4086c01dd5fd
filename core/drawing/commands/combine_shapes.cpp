#include "core/drawing/commands/combine_shapes.hpp"

#include "core/drawing/arrangement/arrangement.hpp"
#include "core/drawing/domain/domain_shapes.hpp"
#include "core/drawing/shapes/boundary_loops.hpp"
#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace forefront {
namespace {

constexpr double kTolerance = 1e-9; ///< fraction of the extent: the rounding of places that are meant to be the same

using ShapePointer = std::shared_ptr<const Shape>;

/// Builds the input of an arrangement that covers the result of an operation.
class Combination {
  public:
    Combination(const std::vector<ShapePointer> &shapes, double circleTolerance) {
        for (const ShapePointer &shape : shapes) {
            outlines_.push_back(outlineOf(*shape));
            chords_.push_back(chordsOf(*shape, outlines_.back(), circleTolerance));
            for (const Vec2 node : chords_.back().nodes) {
                box_.add(node);
            }
        }
        input_.tolerance = kTolerance * box_.diagonal();
        all_ = input_.addShape(input_.addFeature(1));
        shapes_ = &shapes;
    }

    ArrangementInput make(ShapeOperation operation) {
        const std::uint32_t first = input_.addContour(all_, FillRule::EvenOdd);
        addRing(first, 0);
        for (std::size_t k = 1; k < outlines_.size(); ++k) {
            switch (operation) {
            case ShapeOperation::Union:
                addRing(input_.addContour(all_, FillRule::EvenOdd), k);
                break;
            case ShapeOperation::Difference:
                addRing(input_.addContour(all_, FillRule::EvenOdd, true), k);
                break;
            case ShapeOperation::Intersection: {
                const std::uint32_t outside = input_.addContour(all_, FillRule::EvenOdd, true);
                addFrame(outside);
                addRing(outside, k);
                break;
            }
            case ShapeOperation::Exclusion:
                addRing(first, k);
                break;
            case ShapeOperation::Divide:
                addLine(k);
                break;
            }
        }
        return std::move(input_);
    }

  private:
    void addRing(std::uint32_t contour, std::size_t shape) { addPieces(shape, contour, PieceRole::Outline); }
    void addLine(std::size_t shape) { addPieces(shape, 0, PieceRole::Constraint); }

    void addPieces(std::size_t shape, std::uint32_t contour, PieceRole role) {
        const Outline &outline = outlines_[shape];
        const Chords &chords = chords_[shape];
        const auto firstCurve = static_cast<std::uint32_t>(input_.curves.size());
        input_.curves.insert(input_.curves.end(), outline.curves.begin(), outline.curves.end());
        for (std::size_t k = 0; k < chords.size(); ++k) {
            CurveStretch stretch = chords.stretches[k];
            stretch.curve += stretch.follows() ? firstCurve : 0;
            if (chords.from(k) != chords.to(k)) {
                const std::int32_t tag = segmentTag(*(*shapes_)[shape], outline.part(chords.segments[k]));
                input_.pieces.push_back({chords.from(k), chords.to(k), contour, tag, role, stretch});
            }
        }
    }

    /// Adds a rectangle around everything, so that the outside of a shape is an area.
    void addFrame(std::uint32_t contour) {
        const Box2 box = box_.grown(0.25 * box_.diagonal());
        input_.addRing(contour, std::array{box.min, Vec2{box.max.x, box.min.y}, box.max, Vec2{box.min.x, box.max.y}},
                       1);
    }

    const std::vector<ShapePointer> *shapes_ = nullptr;
    std::vector<Outline> outlines_;
    std::vector<Chords> chords_; ///< of the outlines
    Box2 box_;
    ArrangementInput input_;
    std::uint32_t all_ = 0;
};

Result<std::vector<ShapePointer>> chosenShapes(const Document &document, const std::set<std::uint32_t> &ids) {
    std::vector<ShapePointer> chosen;
    for (const ShapePointer &shape : document.shapes) {
        if (ids.contains(shape->id)) {
            if (!isClosed(*shape)) {
                return error("not-possible", displayName(*shape) + " is not a closed shape",
                             "close it, or leave it out of the selection");
            }
            chosen.push_back(shape);
        }
    }
    if (chosen.size() < ids.size()) {
        return error("no-such-shape", "shape not found");
    }
    if (chosen.size() < 2) {
        return error("not-possible", "cannot combine a single shape; expected at least two closed shapes",
                     "select more shapes");
    }
    return chosen;
}

} // namespace

bool canCombine(const Document &document, const Selection &selection) {
    if (selection.shapes.size() < 2) {
        return false;
    }
    // One pass over the document: menus ask this in every frame.
    return std::all_of(document.shapes.begin(), document.shapes.end(), [&](const ShapePointer &shape) {
        return isClosed(*shape) || !selection.shapes.contains(shape->id);
    });
}

Result<Document> combineShapes(const Document &document, const std::set<std::uint32_t> &ids, ShapeOperation operation,
                               Selection *result) {
    const Result<std::vector<ShapePointer>> chosen = chosenShapes(document, ids);
    if (!chosen) {
        return chosen.faults();
    }
    const ArrangementInput input = Combination(*chosen, document.circleTolerance).make(operation);
    Result<Arrangement> arranged = arrange(input);
    if (!arranged) {
        return arranged.faults();
    }
    Domain &domain = arranged->domain;
    if (domain.segments.empty()) {
        return error("not-possible", "the result would be empty", "select shapes that overlap");
    }
    for (std::size_t s = 0; s < domain.segments.size(); ++s) { // where lines coincide, the first shape gives the tag
        domain.segments[s].tag = input.pieces[arranged->stretches[s].piece].tag;
    }
    Document next = document;
    next.shapes.clear();
    Selection fresh;
    const Shape &first = *chosen->front();
    for (const ShapePointer &shape : document.shapes) {
        if (shape->id == first.id) {
            for (Shape &made : shapesOf(domain)) {
                made.id = next.nextId++;
                for (const ShapePointer &from : *chosen) {
                    takeNodeSizes(made, *from);
                }
                made.name = first.name;
                made.use = made.use == ShapeUse::Boundary ? first.use : ShapeUse::Constraint;
                if (Diagnostics faults = checkShape(made); !faults.empty()) {
                    return faults;
                }
                fresh.shapes.insert(made.id);
                next.shapes.push_back(std::make_shared<const Shape>(std::move(made)));
            }
        } else if (!ids.contains(shape->id)) {
            next.shapes.push_back(shape);
        }
    }
    if (result != nullptr) {
        *result = std::move(fresh);
    }
    return next;
}

} // namespace forefront
