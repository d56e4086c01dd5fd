#include "core/drawing/arrangement/repeated_lines/without_repeats.hpp"

#include "core/drawing/arrangement/repeated_lines/outline_search.hpp"
#include "core/drawing/arrangement/snapping/stretch_part.hpp"
#include "core/engine/base/ids.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace forefront {

namespace {

/// Copies the pieces of a drawing, with the remaining parts of lines that repeat outlines.
class DrawingReducer {
  public:
    DrawingReducer(const ArrangementInput &input, const JoinedLines &joined, const RepeatedOutlines &repeated,
                   std::span<const BesideEdge> about)
        : input_(input), joined_(joined), parts_(repeated.parts), about_(about),
          shapes_(joined.snapped.nodes, joined.snapped.edges, about, input.curves), first_(about.size(), kNoIndex) {
        for (const RepeatingEdge &edge : repeated.edges) {
            first_[edge.edge] = static_cast<std::uint32_t>(parts_.size()); // nothing is left
        }
        for (std::size_t k = parts_.size(); k-- > 0;) {
            first_[parts_[k].edge] = static_cast<std::uint32_t>(k);
        }
    }

    ReducedDrawing run() {
        result_.input = input_;
        result_.input.pieces.clear();
        std::uint32_t line = 0;
        for (std::uint32_t piece = 0; piece < input_.pieces.size(); ++piece) {
            const std::uint32_t begin = line;
            bool whole = true;
            for (; line < joined_.lines.size() && joined_.source[line] == piece; ++line) {
                whole = whole && unchanged(line);
            }
            if (whole) {
                add(piece, input_.pieces[piece].a, input_.pieces[piece].b, input_.pieces[piece].stretch);
            }
            for (std::uint32_t i = begin; i < line && !whole; ++i) {
                addLine(i);
            }
        }
        return std::move(result_);
    }

  private:
    bool changed(std::uint32_t edge) const { return first_[edge] != kNoIndex; }
    bool unchanged(std::uint32_t line) const {
        const auto &ways = joined_.snapped.ways;
        const auto &starts = joined_.snapped.starts;
        return input_.pieces[joined_.source[line]].role != PieceRole::Constraint ||
               std::none_of(ways.begin() + starts[line], ways.begin() + starts[line + 1],
                            [&](std::uint32_t way) { return changed(way / 2); });
    }

    void add(std::uint32_t source, Vec2 a, Vec2 b, const CurveStretch &stretch) {
        if (a == b && input_.pieces[source].role != PieceRole::Point) {
            return;
        }
        ArrangementPiece piece = input_.pieces[source];
        piece.a = a;
        piece.b = b;
        piece.stretch = stretch;
        piece.reach = 0.0;
        result_.input.pieces.push_back(piece);
        result_.source.push_back(source);
    }

    /// Adds the remaining parts of a line: the parts of edges that have changed, and the edges between them.
    void addLine(std::uint32_t line) {
        const SnappedLines &snapped = joined_.snapped;
        const SnapLine &whole = joined_.lines[line];
        if (unchanged(line)) {
            add(joined_.source[line], whole.a, whole.b, joined_.stretches[line]);
            return;
        }
        const std::uint32_t last = snapped.starts[line + 1];
        Vec2 from = whole.a;
        for (std::uint32_t k = snapped.starts[line]; k < last; ++k) {
            const PlaneEdge &edge = snapped.edges[snapped.ways[k] / 2];
            const bool back = snapped.ways[k] % 2 != 0;
            if (!changed(snapped.ways[k] / 2)) {
                continue;
            }
            const Vec2 a = snapped.nodes[back ? edge.b : edge.a], b = snapped.nodes[back ? edge.a : edge.b];
            if (k > snapped.starts[line]) {
                addSpan(line, from, a);
            }
            addParts(joined_.source[line], snapped.ways[k] / 2, back);
            from = b;
        }
        if (!changed(snapped.ways[last - 1] / 2)) {
            addSpan(line, from, whole.b);
        }
    }

    void addSpan(std::uint32_t line, Vec2 from, Vec2 to) {
        add(joined_.source[line], from, to,
            stretchAlong(joined_.stretches[line], input_.curves, joined_.lines[line], from, to));
    }

    void addParts(std::uint32_t source, std::uint32_t edge, bool back) {
        std::vector<std::pair<Vec2, Vec2>> ends;
        std::vector<CurveStretch> stretches;
        for (std::size_t k = first_[edge]; k < parts_.size() && parts_[k].edge == edge; ++k) {
            addPart(parts_[k], ends, stretches);
        }
        for (std::size_t k = 0; k < ends.size(); ++k) {
            const std::size_t own = back ? ends.size() - 1 - k : k;
            const auto &[a, b] = ends[own];
            back ? add(source, b, a, stretches[own].reversed()) : add(source, a, b, stretches[own]);
        }
    }

    /// Divides a part of an edge into pieces: straight ones to ends that move, and one along its curve.
    void addPart(const RemainingPart &part, std::vector<std::pair<Vec2, Vec2>> &ends,
                 std::vector<CurveStretch> &stretches) const {
        const auto push = [&](Vec2 a, Vec2 b, const CurveStretch &stretch) {
            ends.emplace_back(a, b);
            stretches.push_back(stretch);
        };
        const Vec2 begin = part.begin.value_or(at(part.edge, part.from));
        const Vec2 end = part.end.value_or(at(part.edge, part.to));
        const double from = part.begin ? away(part, part.from, part.to) : part.from;
        const double to = part.end ? away(part, part.to, part.from) : part.to;
        if (from >= to || !about_[part.edge].stretch.follows()) {
            push(begin, end, {});
            return;
        }
        if (part.begin) {
            push(begin, at(part.edge, from), {});
        }
        const CurveStretch &stretch = about_[part.edge].stretch;
        push(part.begin ? at(part.edge, from) : begin, part.end ? at(part.edge, to) : end,
             {stretch.curve, std::lerp(stretch.t0, stretch.t1, from), std::lerp(stretch.t0, stretch.t1, to)});
        if (part.end) {
            push(at(part.edge, to), end, {});
        }
    }

    /// Returns how far a straight piece leads from one end of a part, at most to the other.
    double away(const RemainingPart &part, double from, double to) const {
        constexpr double kLength = 2.0; // in reaches
        constexpr int kSteps = 30;
        const Vec2 start = at(part.edge, from);
        const double length = kLength * about_[part.edge].reach;
        double within = from, beyond = to;
        for (int step = 0; step < kSteps && distance(start, at(part.edge, to)) > length; ++step) {
            const double middle = 0.5 * (within + beyond);
            (distance(start, at(part.edge, middle)) > length ? beyond : within) = middle;
        }
        return beyond;
    }

    Vec2 at(std::uint32_t edge, double fraction) const { return shapes_.at(edge, fraction); }

    const ArrangementInput &input_;
    const JoinedLines &joined_;
    const std::vector<RemainingPart> &parts_;
    std::span<const BesideEdge> about_;
    EdgeShapes shapes_;
    std::vector<std::uint32_t> first_; ///< per edge: its first part; kNoIndex if it does not change
    ReducedDrawing result_;
};

} // namespace

ReducedDrawing withoutRepeats(const ArrangementInput &input, const JoinedLines &joined,
                              const RepeatedOutlines &repeated, std::span<const BesideEdge> about) {
    return DrawingReducer(input, joined, repeated, about).run();
}

} // namespace forefront
