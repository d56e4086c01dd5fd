#include "core/arrangement/cover.hpp"

#include "core/base/ids.hpp"

#include <algorithm>
#include <numeric>
#include <span>

namespace forefront {

namespace {

/// Winding numbers while walking from face to face, and which shapes and features cover the place.
class Covering {
  public:
    explicit Covering(const ArrangementInput &input)
        : input_(input), winding_(input.contours.size(), 0), outer_(input.shapes.size(), 0),
          hole_(input.shapes.size(), 0), ofFeature_(input.features.size(), 0), place_(input.features.size(), 0) {}

    /// Crosses an outline to the side where the winding number is greater by `change`.
    void add(std::uint32_t contour, std::int32_t change) {
        const bool before = inside(contour);
        winding_[contour] += change;
        const bool after = inside(contour);
        if (before == after) {
            return;
        }
        const ArrangementContour &about = input_.contours[contour];
        const bool covered = covers(about.shape);
        std::uint32_t &count = about.hole ? hole_[about.shape] : outer_[about.shape];
        after ? ++count : --count;
        if (covered != covers(about.shape)) {
            setShape(about.shape, !covered);
        }
    }

    std::uint32_t shapes() const { return shapes_; }
    bool covers(std::uint32_t shape) const { return outer_[shape] > 0 && hole_[shape] == 0; }
    const std::vector<std::uint32_t> &features() const { return features_; }

  private:
    bool inside(std::uint32_t contour) const {
        const std::int32_t winding = winding_[contour];
        return input_.contours[contour].rule == FillRule::NonZero ? winding != 0 : winding % 2 != 0;
    }

    void setShape(std::uint32_t shape, bool covered) {
        const std::uint32_t feature = input_.shapes[shape].feature;
        if (covered) {
            ++shapes_;
            if (ofFeature_[feature]++ == 0) {
                place_[feature] = static_cast<std::uint32_t>(features_.size());
                features_.push_back(feature);
            }
        } else {
            --shapes_;
            if (--ofFeature_[feature] == 0) {
                const std::uint32_t last = features_.back();
                features_[place_[feature]] = last;
                place_[last] = place_[feature];
                features_.pop_back();
            }
        }
    }

    const ArrangementInput &input_;
    std::vector<std::int32_t> winding_;       // per contour
    std::vector<std::uint32_t> outer_, hole_; // per shape: contours that the place is inside of
    std::uint32_t shapes_ = 0;
    std::vector<std::uint32_t> ofFeature_; // per feature: shapes that cover the place
    std::vector<std::uint32_t> features_;  // that do so
    std::vector<std::uint32_t> place_;     // in features_
};

/// Walks over all faces from the unbounded one, back and forth over a tree of edges.
class CoverFinder {
  public:
    CoverFinder(const ArrangementInput &input, const std::vector<Vec2> &nodes, const std::vector<PlaneEdge> &edges,
                const EdgeRuns &runs, const Faces &faces)
        : input_(input), nodes_(nodes), edges_(edges), runs_(runs), faces_(faces), covering_(input) {}

    FaceCover run() {
        measureFaces();
        linkFaces();
        walk();
        flattenRivals();
        findNested();
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
        starts_.assign(faces_.count + 1, 0);
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            ++starts_[faces_.left[e] + 1];
            ++starts_[faces_.right[e] + 1];
        }
        std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
        around_.resize(2 * edges_.size());
        std::vector<std::uint32_t> fill(starts_.begin(), starts_.end() - 1);
        for (std::uint32_t e = 0; e < edges_.size(); ++e) {
            around_[fill[faces_.left[e]]++] = e;
            around_[fill[faces_.right[e]]++] = e;
        }
    }

    void walk() {
        result_.shapes.assign(faces_.count, 0);
        result_.owner.assign(faces_.count, kNoIndex);
        result_.ends.assign(edges_.size(), 0);
        std::vector<std::uint8_t> known(faces_.count, 0);
        struct Step {
            std::uint32_t face, by, next;
        };
        std::vector<Step> path{{0, kNoIndex, starts_[0]}};
        known[0] = 1;
        visit(0);
        while (!path.empty()) {
            Step &step = path.back();
            if (step.next == starts_[step.face + 1]) {
                const Step left = step;
                path.pop_back();
                if (left.by != kNoIndex) {
                    cross(left.by, path.back().face);
                }
                continue;
            }
            const std::uint32_t e = around_[step.next++];
            const bool fromLeft = faces_.left[e] == step.face;
            const std::uint32_t other = fromLeft ? faces_.right[e] : faces_.left[e];
            if (fromLeft && other != step.face) {
                countEnds(e);
            }
            if (known[other] == 0) {
                known[other] = 1;
                cross(e, other);
                visit(other);
                path.push_back({other, e, starts_[other]});
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

    void visit(std::uint32_t face) {
        result_.shapes[face] = covering_.shapes();
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

    /// A feature lies inside another one if that covers all its faces, and more.
    void findNested() {
        std::vector<std::uint32_t> faceCount(input_.features.size(), 0);
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> common;
        featureArea_.assign(input_.features.size(), 0.0);
        for (std::uint32_t face = 1; face < faces_.count; ++face) {
            if (result_.owner[face] != kNoIndex) {
                ++faceCount[result_.owner[face]];
                featureArea_[result_.owner[face]] += result_.area[face];
            }
            const auto rivals = rivalsOf(face);
            for (std::size_t i = 0; i < rivals.size(); ++i) {
                ++faceCount[rivals[i]];
                featureArea_[rivals[i]] += result_.area[face];
                for (std::size_t j = i + 1; j < rivals.size(); ++j) {
                    ++common[{rivals[i], rivals[j]}];
                }
            }
        }
        for (const auto &[pair, count] : common) {
            const auto [f, g] = pair;
            if (count == faceCount[f] && count < faceCount[g]) {
                result_.nested[{f, g}] = true;
            } else if (count == faceCount[g] && count < faceCount[f]) {
                result_.nested[{g, f}] = true;
            }
        }
    }

    void chooseOwners() {
        for (const Crowd &crowd : crowded_) {
            std::uint32_t best = kNoIndex;
            const auto rivals = rivalsOf(crowd.face);
            for (const std::uint32_t feature : rivals) {
                const bool holdsAnother = std::any_of(rivals.begin(), rivals.end(), [&](std::uint32_t other) {
                    return result_.nested.count({other, feature}) != 0;
                });
                if (!holdsAnother && (best == kNoIndex || wins(feature, best))) {
                    best = feature;
                }
            }
            result_.owner[crowd.face] = best;
        }
    }

    /// Over one with a lesser index.
    bool wins(std::uint32_t feature, std::uint32_t over) const {
        return input_.overlap == OverlapRule::Later || featureArea_[feature] <= featureArea_[over];
    }

    const ArrangementInput &input_;
    const std::vector<Vec2> &nodes_;
    const std::vector<PlaneEdge> &edges_;
    const EdgeRuns &runs_;
    const Faces &faces_;
    Covering covering_;
    std::vector<std::uint32_t> starts_, around_; // edges of each face
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

FaceCover coverFaces(const ArrangementInput &input, const std::vector<Vec2> &nodes, const std::vector<PlaneEdge> &edges,
                     const EdgeRuns &runs, const Faces &faces) {
    return CoverFinder(input, nodes, edges, runs, faces).run();
}

} // namespace forefront
