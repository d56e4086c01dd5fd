#include "core/drawing/commands/typed_size.hpp"

#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/constraint_equations.hpp"
#include "core/drawing/constraints/held_numbers.hpp"
#include "core/drawing/constraints/orient.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/place_formulas.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace forefront {
namespace {

/// Returns the dimension that measures a size, with its value; its name says what was typed, for messages.
Result<SketchConstraint> dimensionOf(const Document &document, const TypedSize &size) {
    Result<SketchConstraint> dimension = makeConstraint(document, size.kind, size.parts);
    if (dimension) {
        dimension->value = size.value;
        dimension->name = size.name + " = " + numberText(size.value, 6);
    }
    return dimension;
}

/// Returns true if a size is as typed, up to rounding of the coordinates.
bool isAsTyped(const Document &document, const TypedSize &size) {
    Result<SketchConstraint> dimension = makeConstraint(document, size.kind, size.parts);
    if (!dimension) {
        return false;
    }
    constexpr double kNear = 1e-8; // of the drawing; solutions are that exact
    return std::fabs(dimension->value - size.value) <= kNear * std::max(drawingScale(document), size.value);
}

/// Drives the sizes by dimensions that are removed again.
Result<Document> driven(const Document &before, std::span<const TypedSize> sizes) {
    Document next = before;
    std::set<std::uint32_t> added;
    for (const TypedSize &size : sizes) {
        if (added.empty() && isAsTyped(next, size)) {
            continue; // not typed over, or it follows
        }
        Result<SketchConstraint> dimension = dimensionOf(next, size);
        if (!dimension) {
            return dimension.faults();
        }
        const std::uint32_t id = dimension->id;
        Result<Document> with = addConstraint(next, *std::move(dimension));
        if (!with) {
            return with;
        }
        next = *std::move(with);
        added.insert(id);
    }
    next = removeConstraints(next, added);
    next.nextId = before.nextId;
    for (const TypedSize &size : sizes) {
        if (size.follow) {
            next = size.follow(std::move(next));
        }
    }
    return next;
}

/// Returns true for kinds that measure a circle.
bool isRound(ConstraintKind kind) {
    return kind == ConstraintKind::Radius || kind == ConstraintKind::Diameter;
}

/// Returns the value that a dimension of a kind must have for a size, if it measures the same.
double valueFor(ConstraintKind kind, const TypedSize &size) {
    if (!isRound(kind) || !isRound(size.kind) || kind == size.kind) {
        return size.value;
    }
    return kind == ConstraintKind::Diameter ? 2.0 * size.value : 0.5 * size.value;
}

} // namespace

Result<Document> withTypedSizes(const Document &before, const Document &next, std::span<const TypedSize> sizes) {
    if (before.constraints.empty()) {
        return next;
    }
    const bool measurable = std::all_of(sizes.begin(), sizes.end(), [&](const TypedSize &size) {
        return makeConstraint(before, size.kind, size.parts).ok();
    });
    const Result<Document> settled = completeCommand(before, next);
    if (!measurable) { // such as a radius that is still 0
        const Diagnostics faults = settled ? heldNumbersFault(before, next, *settled) : settled.faults();
        return faults.empty() ? Result<Document>(next) : faults;
    }
    const bool asTyped = settled && std::all_of(sizes.begin(), sizes.end(),
                                                [&](const TypedSize &size) { return isAsTyped(*settled, size); });
    return asTyped ? Result<Document>(next) : driven(before, sizes);
}

std::optional<DimensionChange> dimensionThatSets(const Document &document, const TypedSize &size,
                                                 const std::set<std::uint32_t> &ids) {
    for (const std::uint32_t id : ids) {
        const SketchConstraint *const dimension = findConstraint(document, id);
        const bool angles = dimension != nullptr && dimension->kind == ConstraintKind::Angle;
        if (dimension == nullptr || !isDimension(dimension->kind) || angles != (size.kind == ConstraintKind::Angle)) {
            continue;
        }
        const DimensionChange change{id, valueFor(dimension->kind, size)};
        const Result<Document> changed = changeDimension(document, change);
        if (changed && isAsTyped(*changed, size)) {
            return change;
        }
    }
    return std::nullopt;
}

std::optional<std::size_t> parameterBehind(const Document &document, std::uint32_t constraint) {
    const auto formula = document.formulas.find({NumberOwner::ofConstraint(constraint), Quantity::Value});
    const std::size_t index = formula == document.formulas.end() ? document.parameters.size()
                                                                 : parameterIndex(document.parameters, formula->second);
    return index < document.parameters.size() && plainNumber(document.parameters[index].expression)
               ? std::optional(index)
               : std::nullopt;
}

Result<Document> changeDimension(const Document &document, const DimensionChange &change) {
    if (const std::optional<std::size_t> parameter = parameterBehind(document, change.constraint)) {
        std::vector<Parameter> parameters = document.parameters;
        parameters[*parameter].expression = exactText(change.value);
        return setParameters(document, std::move(parameters));
    }
    return setDimension(setFormula(document, {NumberOwner::ofConstraint(change.constraint), Quantity::Value}, {}),
                        change.constraint, change.value);
}

} // namespace forefront
