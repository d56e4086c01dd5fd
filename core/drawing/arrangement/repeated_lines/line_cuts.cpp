#include "core/drawing/arrangement/repeated_lines/line_cuts.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace forefront {

namespace {

/// Collects the remaining parts of loose lines.
class LineRemains {
  public:
    LineRemains(std::vector<LineCut> cuts, std::span<const PlaneEdge> edges, std::span<const BesideEdge> about)
        : cuts_(std::move(cuts)), edges_(edges), about_(about), starts_(edges.size() + 1, 0) {
        std::sort(cuts_.begin(), cuts_.end(), [](const LineCut &s, const LineCut &t) {
            return std::pair(s.edge, s.from) < std::pair(t.edge, t.from);
        });
        for (std::size_t e = 0, k = 0; e < edges.size(); ++e) {
            while (k < cuts_.size() && cuts_[k].edge == e) {
                ++k;
            }
            starts_[e + 1] = k;
        }
    }

    /// Moves the ends of lines at nodes where other lines are dropped.
    void moveEnds(std::span<const Vec2> nodes, std::span<const std::uint8_t> movable, const OutlineSearch &outlines) {
        moved_.resize(nodes.size());
        std::vector<double> reach(nodes.size(), 0.0); // the largest of the lines that are dropped there
        for (std::uint32_t e = 0; e < edges_.size(); ++e) {
            for (const auto &[node, dropped] : endsOf(e)) {
                reach[node] = dropped ? std::max(reach[node], about_[e].reach) : reach[node];
            }
        }
        for (std::uint32_t node = 0; node < nodes.size(); ++node) {
            if (reach[node] > 0.0 && movable[node] != 0) {
                moved_[node] = outlines.anchorNear(nodes[node], reach[node]);
            }
        }
    }

    RepeatedOutlines collect() const {
        RepeatedOutlines result;
        for (std::uint32_t e = 0; e < edges_.size(); ++e) {
            if (about_[e].role == BesideRole::LooseLine) {
                const std::span<const LineCut> cuts(cuts_.data() + starts_[e], starts_[e + 1] - starts_[e]);
                if (!cuts.empty()) {
                    result.edges.push_back({e, farthest(cuts)});
                }
                if (!cuts.empty() || moved_[edges_[e].a] || moved_[edges_[e].b]) {
                    addParts(e, cuts, result.parts);
                }
            }
        }
        return result;
    }

  private:
    /// Returns the ends of a loose line, each with true if it is dropped there.
    std::array<std::pair<std::uint32_t, bool>, 2> endsOf(std::uint32_t edge) const {
        const bool any = starts_[edge] < starts_[edge + 1];
        return {std::pair{edges_[edge].a, any && cuts_[starts_[edge]].from == 0.0},
                std::pair{edges_[edge].b, any && cuts_[starts_[edge + 1] - 1].to == 1.0}};
    }

    static double farthest(std::span<const LineCut> cuts) {
        double distance = 0.0;
        for (const LineCut &cut : cuts) {
            distance = std::max(distance, cut.distance);
        }
        return distance;
    }

    /// Adds the parts of an edge between its cuts.
    void addParts(std::uint32_t edge, std::span<const LineCut> cuts, std::vector<RemainingPart> &parts) const {
        RemainingPart part{edge, 0.0, 1.0, moved_[edges_[edge].a], {}};
        for (const LineCut &cut : cuts) {
            part.to = cut.from;
            part.end = cut.before;
            if (part.from < part.to) {
                parts.push_back(part);
            }
            part.from = cut.to;
            part.begin = cut.beyond;
        }
        part.to = 1.0;
        part.end = moved_[edges_[edge].b];
        if (part.from < part.to) {
            parts.push_back(part);
        }
    }

    std::vector<LineCut> cuts_;
    std::span<const PlaneEdge> edges_;
    std::span<const BesideEdge> about_;
    std::vector<std::size_t> starts_;        ///< per edge: its first cut
    std::vector<std::optional<Vec2>> moved_; ///< per node: the place that the ends of lines there move to
};

} // namespace

RepeatedOutlines withoutCuts(std::vector<LineCut> cuts, std::span<const Vec2> nodes, std::span<const PlaneEdge> edges,
                             std::span<const BesideEdge> about, std::span<const std::uint8_t> movable,
                             const OutlineSearch &outlines) {
    LineRemains remains(std::move(cuts), edges, about);
    remains.moveEnds(nodes, movable, outlines);
    return remains.collect();
}

} // namespace forefront
