#include "core/drawing/domain/joint_notes.hpp"

#include "core/drawing/shapes/same_place.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace forefront {

void JointNotes::joined(double farthest, Diagnostics &notes) const {
    constexpr double kUnnoticed = 1e-9; // of the diagonal
    if (!(farthest > kUnnoticed / kSamePlace * samePlaceDistance(document_))) {
        return;
    }
    Diagnostic note;
    note.severity = Severity::Note;
    note.code = "joined-places";
    note.message = "joined nodes with nodes or sides of other shapes up to " + numberText(farthest, 3) +
                   " away: places closer than " + numberText(samePlaceDistance(document_), 3) + ", " +
                   numberText(kSamePlace, 3) + " of the drawing's diagonal, are the same";
    notes.push_back(std::move(note));
}

void JointNotes::beside(const NodeBesideCurve &node, std::uint32_t shape, Diagnostics &notes) const {
    if (notes.size() >= kMaxListedFaults) {
        return;
    }
    Diagnostic warning;
    warning.severity = Severity::Warning;
    warning.code = "beside-curve";
    warning.message = "a node lies " + numberText(node.away, 3) + " beside a curve of '" +
                      displayName(*document_.shapes[shape]) + "', and is not joined with it";
    warning.advice = "move it onto the curve, or farther away";
    warning.at = domain_.nodes[node.node];
    notes.push_back(std::move(warning));
}

void JointNotes::along(std::uint32_t shape, Diagnostics &notes) const {
    Diagnostic warning;
    warning.severity = Severity::Warning;
    warning.code = "line-along-side";
    warning.message = "a line runs along a side of '" + displayName(*document_.shapes[shape]) +
                      "' so near that both are at the same place, and is not joined with it";
    warning.advice = "remove the line, or move it farther away";
    const auto same = [&](const Diagnostic &other) { return other.message == warning.message; };
    if (std::none_of(notes.begin(), notes.end(), same) && notes.size() < kMaxListedFaults) {
        notes.push_back(std::move(warning));
    }
}

} // namespace forefront
