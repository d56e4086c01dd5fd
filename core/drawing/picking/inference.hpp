#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/picking/pick_index.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// A relation of a node that is being placed, or of the line to it, to other parts of the drawing. It can become a
/// constraint.
struct Inference {
    ConstraintKind kind = ConstraintKind::Horizontal; ///< Horizontal, Vertical, Parallel, Perpendicular, Tangent, Equal
    bool ofLine = true; ///< of the line from `start`; else of the node alone, which is level with or above another node
    Vec2 start;         ///< where the line to the node begins, or the other node
    /// The other line or node, if it is in the document.
    std::optional<SketchPart> with{};
    /// The segment of the path being drawn that is the other line: its index there.
    std::optional<std::uint32_t> withOwn{};
    bool ofRadius = false; ///< Equal: of the circle about `start` through the node, with the circle or arc `with`

    friend bool operator==(const Inference &, const Inference &) = default;
};

/// What relations of a node are looked for.
struct InferenceQuery {
    std::vector<Vec2> starts; ///< of straight lines to the node: the last node drawn, or the neighbours of one dragged
    std::vector<Vec2> path{}; ///< nodes of the path being drawn, in order, the last one included
    std::vector<bool> straight{};  ///< for each segment of this path, whether it is straight; empty: all are
    std::optional<Vec2> round{};   ///< centre of the circle or arc that the node gives the radius
    std::optional<Vec2> arrival{}; ///< direction in which the curve before arrives at the last node
    double reach = 0.0;            ///< distance up to which other lines and nodes count, domain units
};

/// A place with the relations that it fulfils.
struct InferredPlace {
    Vec2 at;
    std::vector<Inference> relations;
};

/// Returns the place within a tolerance that fulfils relations: those of a line first (perpendicular, horizontal and
/// vertical, parallel, tangent, equal length), equal radii, then co-ordinates of other nodes. Directions count within 3
/// degrees (horizontal and vertical), 4 (tangent) or 2. None if it fulfils none.
std::optional<InferredPlace> inferRelations(const PickIndex &index, const PickIndex::Filter &filter,
                                            const InferenceQuery &query, Vec2 at, double tolerance);

/// Returns the relations that a place fulfils up to rounding without being moved: horizontal and vertical lines.
std::vector<Inference> relationsAt(const InferenceQuery &query, Vec2 at);

/// Returns the word for a relation, such as "horizontal" or "level with a node".
std::string wordsOf(const Inference &inference);

} // namespace forefront
