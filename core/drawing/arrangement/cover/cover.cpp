#include "core/drawing/arrangement/cover/cover.hpp"

#include "core/drawing/arrangement/cover/winding_walk.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/base/rows.hpp"

#include <algorithm>
#include <numeric>
#include <span>

namespace forefront {

namespace {

/// Finds which features cover all faces of a feature, by going from face to face. Looks only at the features that
/// differ from one face to the next, so that deep nesting costs no more than a list of the features that cover each
/// face.
class HolderFinder {
  public:
    explicit HolderFinder(std::size_t features) : holders_(features), state_(features, State::New) {}

    /// Processes a face, given the features that may have changed since the last one.
    void visit(const WindingWalk &covering, const std::vector<std::uint32_t> &switched) {
        std::vector<std::uint32_t> gone, fresh;
        for (const std::uint32_t feature : switched) {
            const bool covers = covering.coversFeature(feature);
            if (covers != (state_[feature] == State::Here)) {
                (covers ? fresh : gone).push_back(feature);
            }
        }
        for (const std::uint32_t feature : gone) {
            state_[feature] = State::Away;
        }
        for (const std::uint32_t feature : covering.features()) {
            if (state_[feature] == State::Here) { // all its holders were here
                drop(holders_[feature], gone);
            }
        }
        for (const std::uint32_t feature : fresh) {
            std::vector<std::uint32_t> &holders = holders_[feature];
            if (state_[feature] == State::New) {
                holders = covering.features();
                std::erase(holders, feature);
                std::sort(holders.begin(), holders.end());
            } else {
                std::erase_if(holders, [&](std::uint32_t holder) { return !covering.coversFeature(holder); });
            }
        }
        for (const std::uint32_t feature : fresh) {
            state_[feature] = State::Here;
        }
    }

    std::vector<std::vector<std::uint32_t>> take() { return std::move(holders_); }

  private:
    enum class State : std::uint8_t { New, Here, Away };

    static void drop(std::vector<std::uint32_t> &sorted, const std::vector<std::uint32_t> &gone) {
        for (std::size_t i = 0; i < gone.size() && !sorted.empty(); ++i) {
            const auto at = std::lower_bound(sorted.begin(), sorted.end(), gone[i]);
            if (at != sorted.end() && *at == gone[i]) {
                sorted.erase(at);
            }
        }
    }

    std::vector<std::vector<std::uint32_t>> holders_;
    std::vector<State> state_; // per feature: at the last face
};

/// Walks over all faces from the unbounded one, back and forth over a tree of edges.
class CoverFinder {
  public:
    CoverFinder(const ArrangementInput &input, const std::vector<Vec2> &nodes, const std::vector<PlaneEdge> &edges,
                const EdgeRuns &runs, const Faces &faces, std::vector<ClippedLine> &lines)
        : input_(input), nodes_(nodes), edges_(edges), runs_(runs), faces_(faces), lines_(lines), covering_(input),
          holders_(input.features.size()) {}

    FaceCover run() {
        measureFaces();
        linkFaces();
        walk();
        flattenRivals();
        result_.holders = holders_.take();
        measureFeatures();
        chooseOwners();
        return std::move(result_);
    }

  private:
    void measureFaces() {
        result_.area.assign(faces_.count, 0.0);
        Box2 box;
        for (const Vec2 node : nodes_) {
            box.add(node);
        }
        const Vec2 origin = box.empty() ? Vec2{} : box.centre();
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            const double twice = forefront::cross(nodes_[edges_[e].a] - origin, nodes_[edges_[e].b] - origin);
            result_.area[faces_.left[e]] += 0.5 * twice;
            result_.area[faces_.right[e]] -= 0.5 * twice;
        }
    }

    void linkFaces() {
        around_ = Rows<std::uint32_t>(faces_.count, [this](const auto &add) {
            for (std::uint32_t e = 0; e < edges_.size(); ++e) {
                add(faces_.left[e], e);
                add(faces_.right[e], e);
            }
        });
    }

    void walk() {
        result_.shapes.assign(faces_.count, 0);
        result_.owner.assign(faces_.count, kNoIndex);
        result_.ends.assign(edges_.size(), 0);
        result_.clipBounds.assign(input_.clips.empty() ? 0 : input_.shapes.size(), 0);
        std::vector<std::uint8_t> known(faces_.count, 0);
        struct Step {
            std::uint32_t face, by, next;
        };
        std::vector<Step> path{{0, kNoIndex, 0}};
        known[0] = 1;
        visit(0);
        while (!path.empty()) {
            Step &step = path.back();
            if (step.next == around_[step.face].size()) {
                const Step left = step;
                path.pop_back();
                if (left.by != kNoIndex) {
                    cross(left.by, path.back().face);
                }
                continue;
            }
            const std::uint32_t e = around_[step.face][step.next++];
            const bool fromLeft = faces_.left[e] == step.face;
            const std::uint32_t other = fromLeft ? faces_.right[e] : faces_.left[e];
            if (fromLeft && other != step.face) {
                countEnds(e);
            }
            if (fromLeft && !lines_.empty()) {
                showLines(e);
            }
            if (known[other] == 0) {
                known[other] = 1;
                cross(e, other);
                visit(other);
                path.push_back({other, e, 0});
            }
        }
    }

    void cross(std::uint32_t edge, std::uint32_t into) {
        const std::int32_t sign = faces_.left[edge] == into ? 1 : -1;
        for (std::uint32_t k = runs_.starts[edge]; k < runs_.starts[edge + 1]; ++k) {
            covering_.add(runs_.runs[k].contour, sign * runs_.runs[k].times);
        }
    }

    /// Starts in the left face of the edge.
    void countEnds(std::uint32_t edge) {
        touched_.clear();
        for (std::uint32_t k = runs_.starts[edge]; k < runs_.starts[edge + 1]; ++k) {
            const std::uint32_t shape = input_.contours[runs_.runs[k].contour].shape;
            if (input_.shapes[shape].partOf != kNoClip) {
                countClippedEnds(edge);
                return;
            }
            if (covering_.covers(shape) && std::find(touched_.begin(), touched_.end(), shape) == touched_.end()) {
                touched_.push_back(shape);
            }
        }
        if (touched_.empty()) {
            return;
        }
        cross(edge, faces_.right[edge]);
        for (const std::uint32_t shape : touched_) {
            result_.ends[edge] += covering_.covers(shape) ? 0U : 1U;
        }
        cross(edge, faces_.left[edge]);
    }

    /// Does the same for an edge along the outline of a clip, where shapes end that have no outline there.
    void countClippedEnds(std::uint32_t edge) {
        const bool inside = covering_.shapes() > 0;
        covering_.watchShapes();
        cross(edge, faces_.right[edge]);
        const bool bounds = inside != (covering_.shapes() > 0);
        for (const std::uint32_t shape : covering_.takeWatched()) {
            result_.ends[edge] += covering_.covers(shape) ? 0U : 1U;
            result_.clipBounds[shape] = bounds ? 1 : result_.clipBounds[shape];
        }
        cross(edge, faces_.left[edge]);
    }

    /// Finds out whether clips show the lines along an edge. Starts in the left face of the edge.
    void showLines(std::uint32_t edge) {
        const auto before = [](const ClippedLine &s, const ClippedLine &t) { return s.edge < t.edge; };
        const auto [first, last] = std::equal_range(lines_.begin(), lines_.end(), ClippedLine{edge, 0}, before);
        const auto look = [&, first = first, last = last] {
            std::for_each(first, last,
                          [&](ClippedLine &line) { line.shown = line.shown || covering_.shows(line.clip); });
        };
        look();
        if (first != last && faces_.left[edge] != faces_.right[edge]) {
            cross(edge, faces_.right[edge]);
            look();
            cross(edge, faces_.left[edge]);
        }
    }

    void visit(std::uint32_t face) {
        result_.shapes[face] = covering_.shapes();
        holders_.visit(covering_, covering_.takeSwitched());
        const std::vector<std::uint32_t> &features = covering_.features();
        if (features.size() == 1) {
            result_.owner[face] = features.front();
        }
        if (features.size() > 1) {
            crowded_.push_back(
                {face, static_cast<std::uint32_t>(rivals_.size()), static_cast<std::uint32_t>(features.size())});
            rivals_.insert(rivals_.end(), features.begin(), features.end());
        }
    }

    void flattenRivals() {
        std::vector<std::uint32_t> count(faces_.count + 1, 0);
        for (const Crowd &crowd : crowded_) {
            count[crowd.face + 1] = crowd.count;
        }
        std::partial_sum(count.begin(), count.end(), count.begin());
        result_.rivals.resize(rivals_.size());
        for (const Crowd &crowd : crowded_) {
            const auto first = rivals_.begin() + crowd.first;
            const auto out = result_.rivals.begin() + count[crowd.face];
            std::copy(first, first + crowd.count, out);
            std::sort(out, out + crowd.count);
        }
        result_.rivalStarts = std::move(count);
    }

    std::span<const std::uint32_t> rivalsOf(std::uint32_t face) const {
        return std::span(result_.rivals)
            .subspan(result_.rivalStarts[face], result_.rivalStarts[face + 1] - result_.rivalStarts[face]);
    }

    void measureFeatures() {
        featureArea_.assign(input_.features.size(), 0.0);
        for (std::uint32_t face = 1; face < faces_.count; ++face) {
            if (result_.owner[face] != kNoIndex) {
                featureArea_[result_.owner[face]] += result_.area[face];
            }
            for (const std::uint32_t feature : rivalsOf(face)) {
                featureArea_[feature] += result_.area[face];
            }
        }
    }

    /// Where one feature contains another, the face belongs to the inner one; among layers, to the last.
    void chooseOwners() {
        if (input_.layered) {
            for (const Crowd &crowd : crowded_) {
                result_.owner[crowd.face] = rivalsOf(crowd.face).back();
            }
            return;
        }
        std::vector<std::uint32_t> leavesFace(input_.features.size(), 0), order;
        std::uint32_t turn = 0;
        for (const Crowd &crowd : crowded_) {
            ++turn;
            const auto rivals = rivalsOf(crowd.face);
            order.assign(rivals.begin(), rivals.end());
            std::sort(order.begin(), order.end(), [&](std::uint32_t f, std::uint32_t g) {
                const std::size_t held = result_.holders[f].size(), heldToo = result_.holders[g].size();
                return held != heldToo ? held > heldToo : f < g;
            });
            for (const std::uint32_t inner : order) {
                if (leavesFace[inner] == turn) {
                    continue; // so do all that contain it
                }
                for (const std::uint32_t holder : result_.holders[inner]) {
                    leavesFace[holder] = result_.nested(inner, holder) ? turn : leavesFace[holder];
                }
            }
            std::uint32_t best = kNoIndex;
            for (const std::uint32_t feature : rivals) {
                if (leavesFace[feature] != turn && (best == kNoIndex || wins(feature, best))) {
                    best = feature;
                }
            }
            result_.owner[crowd.face] = best;
        }
    }

    /// Returns true if a feature wins over one with a lower index.
    bool wins(std::uint32_t feature, std::uint32_t over) const {
        constexpr double kEqual = 1.0 + 1e-9; // the rounding of sums depends on the order of pieces
        return input_.overlap == OverlapRule::Later || featureArea_[feature] <= kEqual * featureArea_[over];
    }

    const ArrangementInput &input_;
    const std::vector<Vec2> &nodes_;
    const std::vector<PlaneEdge> &edges_;
    const EdgeRuns &runs_;
    const Faces &faces_;
    std::vector<ClippedLine> &lines_;
    WindingWalk covering_;
    HolderFinder holders_;
    Rows<std::uint32_t> around_; // edges of each face
    std::vector<std::uint32_t> touched_;
    struct Crowd {
        std::uint32_t face, first, count; // a range of rivals_
    };
    std::vector<Crowd> crowded_;
    std::vector<std::uint32_t> rivals_;
    std::vector<double> featureArea_;
    FaceCover result_;
};

} // namespace

bool FaceCover::nested(std::uint32_t inner, std::uint32_t outer) const {
    const auto holds = [&](std::uint32_t f, std::uint32_t g) {
        return std::binary_search(holders[f].begin(), holders[f].end(), g);
    };
    return holds(inner, outer) && !holds(outer, inner);
}

FaceCover coverFaces(const ArrangementInput &input, const std::vector<Vec2> &nodes, const std::vector<PlaneEdge> &edges,
                     const EdgeRuns &runs, const Faces &faces, std::vector<ClippedLine> &lines) {
    return CoverFinder(input, nodes, edges, runs, faces, lines).run();
}

} // namespace forefront
