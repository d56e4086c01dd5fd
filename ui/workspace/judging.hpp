#pragma once

#include "core/engine/mesh/measures.hpp"
#include "ui/style/colour_map.hpp"
#include "ui/workspace/mesh/mesh_judge.hpp"
#include "ui/workspace/mesh/probe.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

struct Workspace;
class CanvasPainter;

/// Returns the request for the mesh shown now.
JudgeRequest judgeRequest(const Workspace &context);

/// Returns the colour range of the chosen measure: set by the user, or fitted to the mesh.
ColourRange measureRange(const Workspace &context);
/// Returns the colour map of the values that the canvas shows.
ColourMap measureMap(const Workspace &context);
/// Shows the differences within the mesh: the range of the colours fits it from now on.
void fitMeasureRange(Workspace &context);

/// The values at which a measure is bad: below the minimum, above the maximum.
struct MeasureBounds {
    std::optional<double> minimum, maximum;
};
/// Returns the bounds of the measure on the canvas: those that the user set as limits, with the one being dragged; α
/// below 0.5 is bad without any.
MeasureBounds measureBounds(const Workspace &context);
/// Returns the limit that a user can set for a measure by dragging; none for measures without.
std::optional<MeshLimit> limitOf(Measure measure);
/// Returns the place of the limit of a measure on a colour bar, in [0, 1]; at its bad end without a limit.
double limitPosition(Measure measure, const ColourRange &range, const MeasureBounds &bounds);
/// Sets or removes a limit of the document, or explains why the value cannot be one.
void setLimit(Workspace &context, MeshLimit limit, std::optional<double> value);

/// Chooses the measure to show; resets the colour range and the isolated bar of the previous one.
void chooseMeasure(Workspace &context, Measure measure);

/// Shows the values of an expression that a page of a lesson has; of none, the measure again.
void chooseFormula(Workspace &context, const LessonColours &formula);

/// Chooses values of nodes or elements of the opened mesh, which are shown instead of a measure.
void chooseField(Workspace &context, MeshPart part, const std::string &name);

/// Formats a value of the measure or field that a judgement shows, with its unit.
std::string valueText(const Judgement &judgement, double value, int digits = 4);

/// Shows a part of the mesh: chooses it in the probe and zooms so that its surroundings are visible.
void goToPart(Workspace &context, const MeshPick &pick);

/// Shows the part with a rank, 0 being the worst, by the chosen measure.
void goToRank(Workspace &context, std::size_t rank);

/// Goes to the next of the worst parts, or with `forward` false to the previous one; to the worst if none is shown.
void walkRanks(Workspace &context, bool forward);

/// Goes to another of the worst parts by a key of their list: an arrow up or down, Home or End. Returns false for other
/// keys.
bool walkByKey(Workspace &context, int key);

/// Returns the part of the mesh at a place: the nearest node or edge of the element there if it is within `reach`,
/// otherwise the element; std::nullopt outside the mesh or until the search tree is ready.
std::optional<MeshPick> partAt(const Judgement &judgement, Vec2 place, double reach);

/// Returns the properties of a part as labels and values.
std::vector<std::pair<std::string, std::string>> describePart(const Workspace &context, const MeshPick &pick);

/// Draws marks around the chosen part and the part under the pointer.
void drawProbe(CanvasPainter &painter, const Workspace &context);

/// Returns a value of a measure with its unit, and "none" for NaN.
std::string measureText(Measure measure, double value, int digits = 4);

} // namespace forefront
