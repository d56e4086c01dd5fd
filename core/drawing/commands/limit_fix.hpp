#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/mesh/limits.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace forefront {

/// A command that brings the mesh of a document nearer to a limit that it violates.
struct LimitFix {
    std::string change; ///< what it changes, such as "gradation auto → 0.15"
    Document document;  ///< after the command
};

/// Returns a command for a violated limit: a gentler gradation for growth, elements across narrow places, bounds of the
/// size for lengths, a least angle for angles of triangles, the best improvement for the rest. Nothing if the limit is
/// met, the setting that helps is already at its end, or the limit is one of islands, which are drawn. The outline may
/// force a part of the violations: the next mesh shows what is left. `spacing`: the field of that mesh, whose gradation
/// was in force; null: unknown.
std::optional<LimitFix> fixOf(const Document &document, const LimitVerdict &verdict, const SpacingField *spacing);

/// Returns the number of places that violate limits.
std::size_t violations(std::span<const LimitVerdict> verdicts);

/// Returns why a mesh after a fix is no better than the one before, as a part of a sentence: a violated limit is
/// violated farther, by more than a tenth of it, or no fewer places violate limits. Empty: the fix is worth it. Both
/// are verdicts on the same limits, in the same order.
std::string whyNoBetter(std::span<const LimitVerdict> before, std::span<const LimitVerdict> after);

} // namespace forefront
