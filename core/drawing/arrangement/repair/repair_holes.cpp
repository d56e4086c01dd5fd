#include "core/drawing/arrangement/repair/repairer.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace forefront {

namespace {

/// The connected loops of the given segments; segments meet at the same place, whichever nodes they have there.
class GivenLoops {
  public:
    explicit GivenLoops(const Domain &domain) : root_(domain.nodes.size()), nodeAt_(domain.nodes.size()) {
        std::iota(root_.begin(), root_.end(), 0U);
        std::map<std::pair<double, double>, std::uint32_t> first;
        for (std::uint32_t n = 0; n < domain.nodes.size(); ++n) {
            nodeAt_[n] = first.emplace(std::pair(domain.nodes[n].x, domain.nodes[n].y), n).first->second;
        }
    }
    void add(const DomainSegment &segment, const Domain &domain) {
        const std::uint32_t a = nodeAt_[segment.a], b = nodeAt_[segment.b];
        root_[rootOf(a)] = rootOf(b);
        ++degree_[a];
        ++degree_[b];
        ends_.push_back({a, domain.nodes[a]});
        ends_.push_back({b, domain.nodes[b]});
    }
    /// Finds which are closed, and their boxes. Call after the last segment.
    void finish() {
        for (const auto &[node, degree] : degree_) {
            if (degree % 2 != 0) {
                open_.insert(rootOf(node));
            }
        }
        for (const auto &[node, place] : ends_) {
            boxes_[rootOf(node)].add(place);
        }
    }
    /// Returns the loop of a segment, kNoIndex if it is not closed.
    std::uint32_t of(const DomainSegment &segment) {
        const std::uint32_t root = rootOf(nodeAt_[segment.a]);
        return open_.contains(root) ? kNoIndex : root;
    }
    double size(std::uint32_t loop) const {
        const Vec2 extent = boxes_.at(loop).size();
        return extent.x * extent.y;
    }

  private:
    std::uint32_t rootOf(std::uint32_t node) {
        while (root_[node] != node) {
            node = root_[node] = root_[root_[node]];
        }
        return node;
    }

    std::vector<std::uint32_t> root_;   ///< per node
    std::vector<std::uint32_t> nodeAt_; ///< per node: the first one at its place
    std::map<std::uint32_t, std::uint32_t> degree_;
    std::vector<std::pair<std::uint32_t, Vec2>> ends_;
    std::set<std::uint32_t> open_;
    std::map<std::uint32_t, Box2> boxes_;
};

/// The loops around a face, sorted.
using Around = std::vector<std::uint32_t>;

/// Returns `loops` without those that are also in `crossed`, and with the others of `crossed`.
Around across(const Around &loops, const Around &crossed) {
    Around result;
    std::set_symmetric_difference(loops.begin(), loops.end(), crossed.begin(), crossed.end(),
                                  std::back_inserter(result));
    return result;
}

} // namespace

/// Returns, per joined edge, the closed loops that have it an odd number of times; `size` receives their sizes.
std::vector<std::vector<std::uint32_t>> Repairer::loopsOfEdges(std::map<std::uint32_t, double> &size) const {
    GivenLoops loops(given_);
    for (const DomainSegment &segment : given_.segments) {
        if (valid(segment)) {
            loops.add(segment, given_);
        }
    }
    loops.finish();
    std::vector<Around> ofEdge(edges_.size());
    for (std::uint32_t i = 0; i < segmentOf_.size(); ++i) {
        const std::uint32_t loop = loops.of(given_.segments[segmentOf_[i]]);
        for (std::uint32_t k = joined_.starts[i]; loop != kNoIndex && k < joined_.starts[i + 1]; ++k) {
            Around &edge = ofEdge[joined_.ways[k] / 2];
            edge = across(edge, {loop});
            size.emplace(loop, loops.size(loop));
        }
    }
    return ofEdge;
}

/// Takes the parts of holes that lie beyond an outline which they cross out of the domain: faces that only the loop of
/// a hole surrounds. The loop of a hole is the smallest around its marker, if there are others around it. Returns a
/// place in each of these faces, with the number of the marker.
std::vector<std::pair<Vec2, std::uint32_t>> Repairer::openHoles(const DomainGraph &graph, const Faces &faces,
                                                                FaceLabels &labels) const {
    const bool crossed = std::any_of(joined_.crossing.begin(), joined_.crossing.end(), [](auto c) { return c != 0; });
    if (given_.insideRule != InsideRule::HoleMarkers || given_.holeMarkers.empty() || !crossed) {
        return {};
    }
    std::map<std::uint32_t, double> size;
    const std::vector<Around> ofEdge = loopsOfEdges(size);
    std::vector<std::vector<std::uint32_t>> edgesOf(faces.count);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
        edgesOf[faces.left[e]].push_back(e);
        edgesOf[faces.right[e]].push_back(e);
    }
    std::vector<Around> around(faces.count);
    std::vector<std::uint8_t> seen(faces.count, 0);
    std::vector<std::uint32_t> open{0}; // from the unbounded face, which nothing surrounds
    seen[0] = 1;
    while (!open.empty()) {
        const std::uint32_t face = open.back();
        open.pop_back();
        for (const std::uint32_t e : edgesOf[face]) {
            const std::uint32_t next = faces.left[e] == face ? faces.right[e] : faces.left[e];
            if (seen[next] == 0) {
                seen[next] = 1;
                around[next] = across(around[face], ofEdge[e]);
                open.push_back(next);
            }
        }
    }
    std::map<std::uint32_t, std::uint32_t> markerOf; // by the loop of the hole
    for (std::uint32_t i = 0; i < given_.holeMarkers.size(); ++i) {
        const std::uint32_t point = graph.holeMarker[i];
        const std::uint32_t face = point != kNoIndex ? faces.ofPoint[point] : kNoIndex;
        if (face != kNoIndex && around[face].size() > 1) {
            const auto smallest = std::min_element(around[face].begin(), around[face].end(),
                                                   [&](auto a, auto b) { return size.at(a) < size.at(b); });
            markerOf.emplace(*smallest, i);
        }
    }
    std::vector<std::pair<Vec2, std::uint32_t>> opened;
    for (std::uint32_t face = 1; face < faces.count; ++face) {
        const auto hole = around[face].size() == 1 ? markerOf.find(around[face].front()) : markerOf.end();
        if (hole == markerOf.end() || labels.inside[face] == 0) {
            continue;
        }
        labels.inside[face] = 0;
        Vec2 sum;
        for (const std::uint32_t e : edgesOf[face]) {
            sum += midpoint(joined_.nodes[joined_.edges[e].a], joined_.nodes[joined_.edges[e].b]);
        }
        opened.emplace_back((1.0 / static_cast<double>(edgesOf[face].size())) * sum, hole->second);
    }
    return opened;
}

} // namespace forefront
