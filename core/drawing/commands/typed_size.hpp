#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace forefront {

/// A size that a user types for a shape, described by the dimension that would measure it.
struct TypedSize {
    ConstraintKind kind = ConstraintKind::Length; ///< a dimension
    std::vector<SketchPart> parts;                ///< see makeConstraint()
    double value = 0.0;                           ///< a length, or an angle in degrees
    std::string name;                             ///< what the user calls it in messages, such as "length"
    /// Lets a document in which the size is as typed follow the expression that was typed; empty: a number was typed.
    std::function<Document(Document)> follow{};
};

/// Lets the constraints of a document take what follows from typed sizes, and checks that these are as typed. `next`:
/// the document after the command that gives the shapes their sizes. If the constraints would change a size, they are
/// solved with it as a dimension, which is removed again. Returns the document to apply.
///
/// Error: constraint-conflict, if a size cannot be as typed; it names the constraints and joints that hold it, the
/// former also in Diagnostic::ids.
Result<Document> withTypedSizes(const Document &before, const Document &next, std::span<const TypedSize> sizes);

/// A value that would be given to a dimension.
struct DimensionChange {
    std::uint32_t constraint = 0;
    double value = 0.0;
};

/// Returns the change of one of some dimensions that alone gives a size its value, as where the dimension measures the
/// same length or the diameter of the same circle; none if there is none. `ids`: those that hold the size.
std::optional<DimensionChange> dimensionThatSets(const Document &document, const TypedSize &size,
                                                 const std::set<std::uint32_t> &ids);

/// Returns the index of the parameter that alone sets a dimension and is a number itself, if there is one.
std::optional<std::size_t> parameterBehind(const Document &document, std::uint32_t constraint);

/// Gives a dimension a number. If a parameter alone sets it and is a number itself, the parameter is changed, so that
/// the dimension still follows it; any other expression of the dimension is removed. Errors: those of setDimension()
/// and setParameters().
Result<Document> changeDimension(const Document &document, const DimensionChange &change);

} // namespace forefront
