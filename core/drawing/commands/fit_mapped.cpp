#include "core/drawing/commands/fit_mapped.hpp"

#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/constraints/held_numbers.hpp"
#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {
namespace {

using Shapes = std::set<std::uint32_t>;

/// Returns true if a constraint binds some shapes to others or to the axes.
bool crosses(const SketchConstraint &constraint, const Shapes &shapes) {
    const auto inside = std::count_if(constraint.parts.begin(), constraint.parts.end(),
                                      [&](const SketchPart &part) { return shapes.contains(part.shape); });
    return inside > 0 && static_cast<std::size_t>(inside) < constraint.parts.size();
}

/// Returns true if the given shapes differ between two documents by one common translation.
bool areMoved(const Document &from, const Document &to, const Shapes &shapes) {
    constexpr double kNear = 1e-7;
    const double near = kNear * boundsOf(from).diagonal();
    std::optional<Vec2> by;
    for (const std::uint32_t id : shapes) {
        const Shape *const a = findShape(from, id), *const b = findShape(to, id);
        const std::vector<Vec2> old = a != nullptr ? handlesOf(*a) : std::vector<Vec2>();
        const std::vector<Vec2> now = b != nullptr ? handlesOf(*b) : std::vector<Vec2>();
        if (old.size() != now.size()) {
            return false;
        }
        for (std::size_t k = 0; k < old.size(); ++k) {
            by = by.value_or(now[k] - old[k]);
            if (distance(now[k], old[k] + *by) > near) {
                return false;
            }
        }
    }
    return true;
}

/// Returns how far a node of some shapes is from where a constraint has it; none if no constraint places one.
std::optional<Vec2> wayToAnchor(const Document &document, const Shapes &shapes) {
    for (const auto &constraint : document.constraints) {
        if (constraint->kind != ConstraintKind::Coincident || !crosses(*constraint, shapes)) {
            continue;
        }
        const bool first = shapes.contains(constraint->parts[0].shape);
        const std::optional<Vec2> own = placeOfPart(document, constraint->parts[first ? 0 : 1]);
        const std::optional<Vec2> other = placeOfPart(document, constraint->parts[first ? 1 : 0]);
        if (own && other) {
            return *other - *own;
        }
    }
    return std::nullopt;
}

Document movedBy(Document document, const Shapes &shapes, Vec2 by) {
    for (auto &place : document.shapes) {
        if (shapes.contains(place->id)) {
            Shape shape = *place;
            moveShape(shape, by);
            place = std::make_shared<const Shape>(std::move(shape));
        }
    }
    return document;
}

/// Returns a document with the places and forms that its shapes have in another one, so that nothing is left to be
/// solved when the command is completed. All else is still to be carried from the document before the command.
Document withPlacesOf(Document document, const Document &settled) {
    for (auto &pointer : document.shapes) {
        const Shape *const there = findShape(settled, pointer->id);
        if (there != nullptr && (there->nodes != pointer->nodes || there->form != pointer->form)) {
            Shape shape = *pointer;
            shape.nodes = there->nodes;
            shape.form = there->form;
            pointer = std::make_shared<const Shape>(std::move(shape));
        }
    }
    return document;
}

} // namespace

Result<Document> fitMapped(const Document &before, Document mapped, const Shapes &shapes) {
    if (std::none_of(mapped.constraints.begin(), mapped.constraints.end(),
                     [&](const auto &constraint) { return crosses(*constraint, shapes); })) {
        return mapped;
    }
    const Result<Document> settled = completeCommand(before, mapped);
    if (settled && areMoved(mapped, *settled, shapes)) {
        return withPlacesOf(std::move(mapped), *settled);
    }
    if (const std::optional<Vec2> by = wayToAnchor(mapped, shapes)) {
        Document moved = movedBy(mapped, shapes, *by);
        const Result<Document> there = completeCommand(before, moved);
        if (there && areMoved(moved, *there, shapes)) {
            return withPlacesOf(std::move(moved), *there);
        }
    }
    if (!settled) {
        return settled.faults();
    }
    const std::optional<HeldNumbers> held = heldNumbers(*settled, mapped, *settled);
    const std::string names = held && !held->names.empty() ? held->names : "the constraints with other shapes";
    const Shape *const first = findShape(mapped, *shapes.begin());
    return error("constraint-conflict",
                 (first != nullptr ? displayName(*first) : "the selection") + " cannot have this form with " + names,
                 "select what it is bound to as well, or remove these constraints");
}

} // namespace forefront
