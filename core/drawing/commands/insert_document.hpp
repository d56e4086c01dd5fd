#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/result.hpp"

namespace forefront {

/// The items that an insertion added.
struct Insertion {
    Selection added{};
    /// A warning (dropped-formulas) if formulas became plain numbers because there would be too many parameters.
    Diagnostics notes{};
};

/// Returns `document` with the shapes, region markers and names of another document, scaled about the origin. Names
/// keep their meaning: see withDistinctTags(). Formulas come along with the parameters that they use: see
/// bringFormulas(). An empty document without a unit takes the unit of an unscaled one. `insertion`, if not null, is
/// set to what was added.
Document insertDrawing(const Document &document, const Document &other, double scale, Insertion *insertion);

/// Like insertDrawing() with a scale that turns the unit of `copied` into that of `document` if both have one, and with
/// the size sources, which leave automatic spacing on, and the sizes of boundary parts whose tags `document` does not
/// use. If an added shape, source or marker would coincide with an existing one, all added items are moved by the
/// smallest multiple of `step` that avoids this. Errors: as for moveSelection().
Result<Document> insertCopied(const Document &document, const Document &copied, Vec2 step, Insertion *insertion);

} // namespace forefront
