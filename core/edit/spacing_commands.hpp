#pragma once

#include "core/base/result.hpp"
#include "core/edit/document.hpp"

#include <optional>
#include <string>

namespace forefront {

/// Commands on the spacing part of a document. Refused with bad-size (not finite or <= 0), bad-source, no-such-source,
/// bad-limits (minimum above maximum), bad-growth.

/// Constant size; nullopt: none.
Result<Document> setSize(const Document &document, std::optional<double> size);
/// Expression in x and y, taken as typed (building the field reports its faults); empty or blank: none.
Document setExpression(const Document &document, std::string expression);
/// Clamp of ρ; nullopt: none.
Result<Document> setLimits(const Document &document, std::optional<double> minimum, std::optional<double> maximum);
/// Greatest |∇ρ|; nullopt: the default.
Result<Document> setGradation(const Document &document, std::optional<double> gradation);
Document setFromBoundary(const Document &document, bool fromBoundary);

Result<Document> addSource(const Document &document, SizeSource source);
Result<Document> replaceSource(const Document &document, std::size_t index, SizeSource source);
Result<Document> removeSource(const Document &document, std::size_t index);

Document setPaint(const Document &document, PaintedSpacing paint);
/// Takes over the spacing of another document or file; null background and empty paint included.
Document setSpacing(const Document &document, SpacingSpec spacing);

/// What is wrong with a source taken alone; empty if it can be in a document.
Diagnostics checkSource(const SizeSource &source);
/// Its name, or one made of shape and place such as "point source 2".
std::string displayName(const SizeSource &source, std::size_t index);

} // namespace forefront
