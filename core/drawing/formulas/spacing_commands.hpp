#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace forefront {

// Commands on the spacing of a document. Errors: bad-size (not finite or <= 0, or minimum above maximum), bad-source,
// no-such-source, bad-tolerance (not finite or <= 0).

/// Sets a constant spacing; nullopt removes it.
Result<Document> setSize(const Document &document, std::optional<double> size);
/// Sets the expression in x and y; its syntax is checked when the field is built. An empty or blank one removes it.
Document setExpression(const Document &document, std::string expression);
/// Sets the bounds of the spacing; nullopt removes one.
Result<Document> setLimits(const Document &document, std::optional<double> minimum, std::optional<double> maximum);
/// Sets the maximum |∇ρ|; nullopt restores the default.
Result<Document> setGradation(const Document &document, std::optional<double> gradation);
/// Sets the edges per full turn of curved boundaries, see SpacingSpec::segmentsPerTurn; nullopt restores the default.
Result<Document> setSegmentsPerTurn(const Document &document, std::optional<double> count);
/// Sets the elements across narrow places, see SpacingSpec::elementsAcross; nullopt restores the default.
Result<Document> setElementsAcross(const Document &document, std::optional<double> count);
/// Sets the maximum distance of curves from their edges, see Domain::curveTolerance; nullopt restores the default.
Result<Document> setCurveTolerance(const Document &document, std::optional<double> tolerance);
/// Sets whether the lengths of boundary segments act as sources.
Document setFromBoundary(const Document &document, bool fromBoundary);

/// Adds a source. A first source keeps automatic spacing: see keepAutomaticWith().
Result<Document> addSource(const Document &document, SizeSource source);
/// Returns the value of SpacingSpec::keepAutomatic after sources are added: true for the first ones, unless the user
/// has chosen. Projects of older files stay without a choice, so that their sources replace automatic spacing.
std::optional<bool> keepAutomaticWith(const SpacingSpec &spacing);
/// Sets whether sources only refine automatic spacing.
Document setKeepAutomatic(const Document &document, bool keep);
Result<Document> replaceSource(const Document &document, std::size_t index, SizeSource source);
Result<Document> removeSource(const Document &document, std::size_t index);

/// Sets the size and growth of the boundary part with a tag, in place of a number of elements; nullopt removes them.
Result<Document> setPartSize(const Document &document, std::int32_t tag, std::optional<PartSize> size);

Document setPaint(const Document &document, PaintedSpacing paint);
/// Replaces the whole spacing, and numbers of elements, for example by the spacing of a file. Parameters that its
/// expression uses come along with their values: see bringParameters(). Error: too-many-parameters.
Result<Document> setSpacing(const Document &document, SpacingSpec spacing);
/// Sets the spacing of a file. A mesh, grid or picture replaces only the rule for the whole domain: sources, paint,
/// sizes of parts and limits stay. A project replaces the whole spacing. Error: too-many-parameters.
Result<Document> setImportedSpacing(const Document &document, SpacingSpec spacing);

/// Returns the name of a source, or one made of its shape and index such as "point source 2".
std::string displayName(const SizeSource &source, std::size_t index);

} // namespace forefront
