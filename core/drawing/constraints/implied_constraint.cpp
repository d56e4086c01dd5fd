#include "core/drawing/constraints/implied_constraint.hpp"

#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/constraint_equations.hpp"
#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/sketch/judge_constraint.hpp"
#include "core/engine/base/result.hpp"

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Describes a number of a shape that has a formula, such as "radius of circle 1".
std::string nameOfNumber(const Document &document, const NumberAddress &address) {
    const std::uint32_t id = address.owner.id;
    switch (address.quantity) {
    case Quantity::X:
    case Quantity::Y:
        return std::string(wordOf(address.quantity)) + " of " +
               partName(document, {id, SketchPartKind::Node, address.handle});
    case Quantity::ArcRadius:
        return "radius of " + partName(document, {id, SketchPartKind::Segment, address.handle});
    default:
        return std::string(wordOf(address.quantity)) + " of " + displayName(*findShape(document, id));
    }
}

/// Finds what a constraint follows from by taking away one thing after the other.
class ImpliedConstraint {
  public:
    ImpliedConstraint(const Document &document, const SketchConstraint &constraint)
        : document_(document), constraint_(constraint) {
        for (const SketchPart &part : constraint.parts) {
            shapes_.insert(part.shape);
        }
        for (const auto &[address, text] : document.formulas) {
            if (address.owner.kind == NumberOwner::Kind::Shape && shapes_.contains(address.owner.id)) {
                formulas_.push_back(address);
            }
        }
    }

    /// Returns the formulas without which the constraint says something: one alone, or all of its shapes.
    std::vector<NumberAddress> formulas() const {
        for (const NumberAddress &address : formulas_) {
            Document without = document_;
            without.formulas.erase(address);
            if (isFree(without)) {
                return {address};
            }
        }
        Document without = document_;
        for (const NumberAddress &address : formulas_) {
            without.formulas.erase(address);
        }
        return formulas_.size() > 1 && isFree(without) ? formulas_ : std::vector<NumberAddress>();
    }

    /// Returns the locked shape without whose lock the constraint says something, or null.
    const Shape *lockedShape() const {
        for (const std::uint32_t id : shapes_) {
            const Shape *const shape = findShape(document_, id);
            if (shape == nullptr || !shape->locked) {
                continue;
            }
            Shape unlocked = *shape;
            unlocked.locked = false;
            Document without = document_;
            without.shapes[positionOf(without, id)] = std::make_shared<const Shape>(std::move(unlocked));
            if (isFree(without)) {
                return shape;
            }
        }
        return nullptr;
    }

  private:
    bool isFree(const Document &document) const {
        const DocumentSketch sketch = sketchOf(document, document, {.places = &document});
        return judgeConstraint(sketch.system, constraint_.id).verdict == ConstraintVerdict::Fine;
    }

    const Document &document_;
    const SketchConstraint &constraint_;
    std::set<std::uint32_t> shapes_;
    std::vector<NumberAddress> formulas_; ///< of the shapes that the constraint names
};

} // namespace

Diagnostics impliedFault(const Document &document, std::uint32_t constraint) {
    const SketchConstraint &implied = *findConstraint(document, constraint);
    const ImpliedConstraint search(document, implied);
    const std::vector<NumberAddress> formulas = search.formulas();
    if (!formulas.empty()) {
        std::string names;
        for (const NumberAddress &address : formulas) {
            names +=
                (names.empty() ? "" : ", ") + nameOfNumber(document, address) + " = " + document.formulas.at(address);
        }
        return error("constraint-redundant",
                     implied.name + (formulas.size() == 1 ? " is set by the formula " : " is set by the formulas ") +
                         names,
                     formulas.size() == 1 ? "leave it out, or enter a number in place of the formula first"
                                          : "leave it out, or enter a number in place of one of them first");
    }
    if (const Shape *const shape = search.lockedShape()) {
        return error("constraint-redundant", implied.name + " always holds: " + displayName(*shape) + " is locked",
                     "leave it out, or unlock the shape first");
    }
    return error("constraint-redundant", implied.name + " always holds here: the form of the shapes implies it",
                 "leave it out");
}

} // namespace forefront
