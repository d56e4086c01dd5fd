#include "core/drawing/constraints/sketch_state.hpp"

#include "core/drawing/constraints/constraint_equations.hpp"
#include "core/drawing/constraints/free_numbers.hpp"
#include "core/drawing/constraints/orient.hpp"
#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/sketch/freedom.hpp"

#include <algorithm>
#include <vector>

namespace forefront {
namespace {

/// Returns the ids of the shapes that constraints name.
std::set<std::uint32_t> shapesOfSketch(const Document &document) {
    std::set<std::uint32_t> shapes;
    for (const auto &constraint : document.constraints) {
        for (const SketchPart &part : constraint->parts) {
            shapes.insert(part.shape);
        }
    }
    return shapes;
}

/// Returns the points, segments and centres of the shapes that constraints name.
std::set<SketchPart> partsOfSketch(const Document &document) {
    std::set<SketchPart> parts;
    for (const std::uint32_t id : shapesOfSketch(document)) {
        const Shape *const shape = findShape(document, id);
        for (std::uint32_t k = 0; shape != nullptr && k < handleCount(*shape); ++k) {
            parts.insert({id, SketchPartKind::Node, k});
        }
        for (std::uint32_t k = 0; shape != nullptr && k < taggedSegments(*shape); ++k) {
            parts.insert({id, SketchPartKind::Segment, k});
        }
    }
    std::erase_if(parts, [&](const SketchPart &part) { return formOfPart(document, part) == PartForm::None; });
    return parts;
}

} // namespace

SketchState sketchState(const Document &document) {
    SketchState state;
    DocumentSketch sketch(document);
    for (const auto &constraint : document.constraints) {
        if (partsFault(document, constraint->kind, constraint->parts).empty()) {
            addEquations(sketch, *constraint, document);
            if (!holdsIn(document, *constraint) || isSlantedDistance(document, *constraint)) {
                state.violated.insert(constraint->id);
            }
        }
    }
    std::map<SketchPart, std::vector<std::uint32_t>> unknowns;
    for (const SketchPart &part : partsOfSketch(document)) {
        unknowns.emplace(part, sketch.unknownsOf(part));
    }
    sketch.finish({.places = &document});
    const SketchFreedom freedom = freedomOf(sketch.system);
    state.degrees = freedom.degrees + freeNumbersBeside(sketch, document);
    state.redundant.insert(freedom.redundant.begin(), freedom.redundant.end());
    for (const auto &[part, list] : unknowns) {
        state.determined.emplace(
            part, std::all_of(list.begin(), list.end(), [&](std::uint32_t k) { return freedom.determined[k]; }));
    }
    return state;
}

} // namespace forefront
