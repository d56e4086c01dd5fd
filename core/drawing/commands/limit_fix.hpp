#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/mesh/limits.hpp"

#include <optional>
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
/// force a part of the violations: the next mesh shows what is left.
std::optional<LimitFix> fixOf(const Document &document, const LimitVerdict &verdict);

/// Returns true if the worst place of a limit is farther beyond it after a fix than before, by more than a tenth of the
/// limit: such a fix is not worth fewer violations.
bool makesWorse(const LimitVerdict &before, const LimitVerdict &after);

} // namespace forefront
