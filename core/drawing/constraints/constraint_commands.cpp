#include "core/drawing/constraints/constraint_commands.hpp"

#include "core/drawing/constraints/conflict.hpp"
#include "core/drawing/constraints/constraint_equations.hpp"
#include "core/drawing/constraints/constraint_figures.hpp"
#include "core/drawing/constraints/settle.hpp"
#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/sketch/judge_constraint.hpp"
#include "core/drawing/sketch/solve_sketch.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace forefront {
namespace {

Diagnostics noSuchConstraint() {
    return error("no-such-constraint", "constraint not found");
}

/// Returns the index of a constraint; the number of constraints if there is none.
std::size_t indexOf(const Document &document, std::uint32_t id) {
    const auto &list = document.constraints;
    const auto found = std::lower_bound(list.begin(), list.end(), id, [](const auto &constraint, std::uint32_t wanted) {
        return constraint->id < wanted;
    });
    return static_cast<std::size_t>((found != list.end() && (*found)->id == id ? found : list.end()) - list.begin());
}

/// Returns the nodes at the ends of a segment; for a slot, the centres at the ends of its sides.
std::vector<SketchPart> endsOf(const Document &document, const SketchPart &segment) {
    const Shape *const shape = findShape(document, segment.shape);
    if (segment.kind != SketchPartKind::Segment || shape == nullptr) {
        return {};
    }
    const bool slot = shape->is<SlotForm>();
    const auto count = slot ? 2U : static_cast<std::uint32_t>(handleCount(*shape));
    const std::uint32_t first = slot ? 0 : segment.index;
    return {{shape->id, SketchPartKind::Node, first}, {shape->id, SketchPartKind::Node, (first + 1) % count}};
}

/// Returns the nodes at which two curves of paths, or a curve and a circle, meet at an end; empty if they do not.
std::vector<SketchPart> jointOf(const Document &document, const SketchPart &first, const SketchPart &second) {
    const auto ends = [&](const SketchPart &part) {
        const Shape *const shape = findShape(document, part.shape);
        return shape != nullptr && isPath(*shape) ? endsOf(document, part) : std::vector<SketchPart>();
    };
    const double near = 1e-9 * boundsOf(document).diagonal();
    const std::vector<SketchPart> a = ends(first), b = ends(second);
    for (const SketchPart &p : a) {
        for (const SketchPart &q : b) {
            if (p == q || distance(*placeOfPart(document, p), *placeOfPart(document, q)) <= near) {
                return {p, q};
            }
        }
    }
    const auto onCircle = [&](const SketchPart &circle, Vec2 p) {
        DocumentSketch sketch(document);
        const DocumentSketch::Round round = sketch.round(circle);
        return std::fabs(distance(sketch.system.place(round.centre), p) - sketch.system.values[round.radius]) <= near;
    };
    if (b.empty() && formOfPart(document, second) == PartForm::Circle) { // a whole circle, or the end of a slot
        for (const SketchPart &p : a) {
            if (onCircle(second, *placeOfPart(document, p))) {
                return {p, p};
            }
        }
    }
    return {};
}

/// Completes the parts of a constraint, see makeConstraint().
std::vector<SketchPart> completed(const Document &document, ConstraintKind kind, std::vector<SketchPart> parts) {
    if (kind == ConstraintKind::Tangent && parts.size() == 4) {
        return parts;
    }
    parts = inOrder(document, std::move(parts));
    if (kind == ConstraintKind::Length && parts.size() == 1 && formOfPart(document, parts[0]) == PartForm::Line) {
        return endsOf(document, parts[0]);
    }
    if (kind == ConstraintKind::Tangent && parts.size() == 2) {
        const std::vector<SketchPart> joint = jointOf(document, parts[0], parts[1]);
        parts.insert(parts.end(), joint.begin(), joint.end());
    }
    return parts;
}

std::string valueFault(const SketchConstraint &constraint) {
    if (!isDimension(constraint.kind)) {
        return {};
    }
    const double limit = constraint.kind == ConstraintKind::Angle ? 360.0 : INFINITY;
    if (constraint.value > 0.0 && constraint.value < limit) {
        return {};
    }
    return "invalid value " + numberText(constraint.value, 6) + "; expected a number above 0" +
           (constraint.kind == ConstraintKind::Angle ? " and below 360" : "");
}

/// Returns a document with a constraint in place of the one with its id, or after the others.
Document with(Document document, SketchConstraint constraint) {
    const std::size_t at = indexOf(document, constraint.id);
    auto pointer = std::make_shared<const SketchConstraint>(std::move(constraint));
    if (at < document.constraints.size()) {
        document.constraints[at] = std::move(pointer);
    } else {
        document.nextId = std::max(document.nextId, pointer->id + 1);
        document.constraints.push_back(std::move(pointer));
    }
    return document;
}

/// Adds the ids of the constraints that a fault names; joints have none.
Diagnostics naming(Diagnostics faults, const DocumentSketch &sketch, const std::set<std::uint32_t> &ids) {
    std::copy_if(ids.begin(), ids.end(), std::back_inserter(faults.front().ids),
                 [&](std::uint32_t id) { return id < sketch.jointId(0); });
    return faults;
}

} // namespace

const SketchConstraint *findConstraint(const Document &document, std::uint32_t id) {
    const std::size_t index = indexOf(document, id);
    return index < document.constraints.size() ? document.constraints[index].get() : nullptr;
}

std::string kindName(ConstraintKind kind) {
    constexpr std::array<const char *, 20> kNames = {"Coincident",
                                                     "On curve",
                                                     "Midpoint",
                                                     "Horizontal",
                                                     "Vertical",
                                                     "Parallel",
                                                     "Perpendicular",
                                                     "Collinear",
                                                     "Tangent",
                                                     "Equal",
                                                     "Concentric",
                                                     "Symmetric",
                                                     "Fixed",
                                                     "Length",
                                                     "Distance",
                                                     "Horizontal distance",
                                                     "Vertical distance",
                                                     "Angle",
                                                     "Radius",
                                                     "Diameter"};
    return kNames[static_cast<std::size_t>(kind)];
}

std::string freeConstraintName(const Document &document, ConstraintKind kind) {
    std::set<std::string> taken;
    for (const auto &constraint : document.constraints) {
        taken.insert(constraint->name);
    }
    const std::string stem = kindName(kind) + ' ';
    std::size_t number = 1;
    while (taken.contains(stem + std::to_string(number))) {
        ++number;
    }
    return stem + std::to_string(number);
}

Result<SketchConstraint> makeConstraint(const Document &document, ConstraintKind kind, std::vector<SketchPart> parts) {
    SketchConstraint constraint;
    constraint.id = document.nextId;
    constraint.kind = kind;
    constraint.name = freeConstraintName(document, kind);
    constraint.parts = completed(document, kind, std::move(parts));
    if (const std::string fault = partsFault(document, kind, constraint.parts); !fault.empty()) {
        return error("bad-constraint", kindName(kind) + ": " + fault, "select these and try again");
    }
    DocumentSketch sketch(document);
    constraint = oriented(sketch, std::move(constraint));
    constraint.value = measured(sketch, constraint);
    if (const std::string fault = valueFault(constraint); !fault.empty()) {
        return error("bad-constraint", kindName(kind) + ": " + fault, "select other parts");
    }
    return constraint;
}

std::string constraintFault(const Document &document, const SketchConstraint &constraint) {
    std::string fault = partsFault(document, constraint.kind, constraint.parts);
    return fault.empty() ? valueFault(constraint) : fault;
}

Result<Document> addConstraint(const Document &document, SketchConstraint constraint) {
    if (const std::string fault = constraintFault(document, constraint); !fault.empty()) {
        return error("bad-constraint", constraint.name + ": " + fault);
    }
    const std::uint32_t id = constraint.id;
    const std::string name = constraint.name;
    const Document next = with(document, std::move(constraint));
    const DocumentSketch sketch = sketchOf(next, document, {.places = &next});
    const ConstraintJudgement judgement = judgeConstraint(sketch.system, id);
    const std::set<std::uint32_t> others(judgement.with.begin(), judgement.with.end());
    if (judgement.verdict == ConstraintVerdict::Redundant) {
        return naming(error("constraint-redundant",
                            others.empty() ? name + " always holds here: the form of the shapes implies it"
                                           : name + " follows from " + relationNames(sketch, others),
                            "leave it out, or remove one of these first"),
                      sketch, others);
    }
    if (judgement.verdict == ConstraintVerdict::Conflict) {
        std::set<std::uint32_t> all = others;
        all.insert(id);
        const std::string with = others.empty() ? "" : " together with " + relationNames(sketch, others);
        return naming(error("constraint-conflict",
                            cannotHold(sketch.system, all, nearestValues(sketch.system))
                                ? name + " cannot hold" + (others.empty() ? " here" : with)
                                : "no solution was found near by for " + name + with,
                            clashAdvice(sketch, others)),
                      sketch, others);
    }
    return settle(document, next);
}

Result<Document> addConstraint(const Document &document, ConstraintKind kind, std::vector<SketchPart> parts) {
    Result<SketchConstraint> constraint = makeConstraint(document, kind, std::move(parts));
    return constraint ? addConstraint(document, *std::move(constraint)) : constraint.faults();
}

Result<Document> setDimension(const Document &document, std::uint32_t id, double value) {
    const SketchConstraint *const found = findConstraint(document, id);
    if (found == nullptr) {
        return noSuchConstraint();
    }
    if (!isDimension(found->kind)) {
        return error("bad-constraint", found->name + " has no value");
    }
    SketchConstraint constraint = *found;
    constraint.value = value;
    if (const std::string fault = valueFault(constraint); !fault.empty()) {
        return error("bad-constraint", constraint.name + ": " + fault);
    }
    return settle(document, with(document, std::move(constraint)));
}

Result<Document> placeDimension(const Document &document, std::uint32_t id, std::optional<Vec2> place) {
    const SketchConstraint *const found = findConstraint(document, id);
    if (found == nullptr) {
        return noSuchConstraint();
    }
    const std::optional<DimensionFigure> figure = dimensionFigure(document, *found);
    if (!figure) {
        return error("bad-constraint", found->name + " has no text that can be placed");
    }
    if (place && !(std::isfinite(place->x) && std::isfinite(place->y))) {
        return error("bad-number", "expected a place with finite co-ordinates");
    }
    SketchConstraint constraint = *found;
    constraint.label = place ? std::optional(figure->offsetOf(*place)) : std::nullopt;
    return with(document, std::move(constraint));
}

Document removeConstraints(const Document &document, const std::set<std::uint32_t> &ids) {
    Document next = document;
    std::erase_if(next.constraints, [&](const auto &constraint) { return ids.contains(constraint->id); });
    std::erase_if(next.formulas, [&](const auto &formula) {
        const NumberOwner &owner = formula.first.owner;
        return owner.kind == NumberOwner::Kind::Constraint && ids.contains(owner.id);
    });
    return next;
}

Result<Document> setConstruction(const Document &document, const std::set<std::uint32_t> &shapes, bool construction) {
    Document next = document;
    std::size_t found = 0;
    for (std::shared_ptr<const Shape> &place : next.shapes) {
        if (shapes.contains(place->id)) {
            Shape shape = *place;
            shape.construction = construction;
            place = std::make_shared<const Shape>(std::move(shape));
            ++found;
        }
    }
    return found == shapes.size() ? Result<Document>(std::move(next)) : error("no-such-shape", "shape not found");
}

} // namespace forefront
