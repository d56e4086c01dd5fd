#pragma once

#include "core/base/result.hpp"
#include "core/edit/document.hpp"
#include "core/edit/references.hpp"

namespace forefront {

/// Returns `document` with the shapes, region markers and names of another one, scaled about the origin. Where both
/// name a tag, the name in `document` wins. Formulas come along with the parameters that they use: see
/// bringFormulas(). `added`, if not null, becomes the selection of everything added.
Document insertDrawing(const Document &document, const Document &other, double scale, Selection *added);

/// Like insertDrawing() without scaling, and with the size sources. If an added shape, source or marker would coincide
/// with an existing one, everything added is moved by the smallest multiple of `step` that avoids this. Errors: those
/// of moveSelection().
Result<Document> insertCopied(const Document &document, const Document &other, Vec2 step, Selection *added);

} // namespace forefront
