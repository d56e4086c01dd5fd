#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace forefront {

// Commands on the constraints of a document. Errors: bad-constraint (parts that do not fit the kind, or a value that is
// not possible), no-such-constraint, constraint-redundant, constraint-conflict.

/// Returns the constraint with an id, or null.
const SketchConstraint *findConstraint(const Document &document, std::uint32_t id);

/// Returns the word for a kind, such as "Horizontal distance".
std::string kindName(ConstraintKind kind);

/// Returns the first name that no constraint has of the word for a kind with 1, 2, and so on.
std::string freeConstraintName(const Document &document, ConstraintKind kind);

/// Makes a constraint of parts, in any order, with the orientation and, for a dimension, the value that they have now.
/// Its id is the next one of the document, its name the first free one, such as "Length 2". A length of a segment gets
/// its ends as parts. Curves that meet at their ends become tangent there.
Result<SketchConstraint> makeConstraint(const Document &document, ConstraintKind kind, std::vector<SketchPart> parts);

/// Adds a constraint and moves what it moves. Errors: constraint-redundant names the constraints that already imply it;
/// constraint-conflict those that it cannot hold with. Their ids are in Diagnostic::ids.
Result<Document> addConstraint(const Document &document, SketchConstraint constraint);
/// Makes and adds a constraint.
Result<Document> addConstraint(const Document &document, ConstraintKind kind, std::vector<SketchPart> parts);

/// Sets the value of a dimension, a length or an angle in degrees, and moves what it moves.
Result<Document> setDimension(const Document &document, std::uint32_t id, double value);

/// Places the text of a dimension, see SketchConstraint::label; none: beside what it measures. Nothing moves.
Result<Document> placeDimension(const Document &document, std::uint32_t id, std::optional<Vec2> place);

/// Removes constraints and the formulas of their values; nothing moves.
Document removeConstraints(const Document &document, const std::set<std::uint32_t> &ids);

/// Marks shapes as construction geometry, which is never meshed, or as part of the domain.
Result<Document> setConstruction(const Document &document, const std::set<std::uint32_t> &shapes, bool construction);

/// Returns why a constraint is invalid in a document; empty if it is valid, whether it holds or not.
std::string constraintFault(const Document &document, const SketchConstraint &constraint);

} // namespace forefront
