#include "core/drawing_files/common/reorder_origin.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/geometry/box_tree.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Finds the node of a domain that is nearest to a place, up to rounding.
class PlaceFinder {
  public:
    explicit PlaceFinder(const Domain &domain) : nodes_(domain.nodes), reach_(1e-7 * domain.bounds().diagonal()) {
        std::vector<Box2> boxes;
        boxes.reserve(nodes_.size());
        for (const Vec2 node : nodes_) {
            boxes.push_back(boxOf(node, node));
        }
        tree_ = BoxTree(boxes);
    }

    std::uint32_t find(Vec2 p) const {
        double limit = reach_;
        return tree_.nearest(p, limit, [&](std::uint32_t n) { return distance(nodes_[n], p); });
    }

  private:
    const std::vector<Vec2> &nodes_;
    BoxTree tree_;
    double reach_;
};

} // namespace

void reorderOrigin(const Domain &before, const Domain &after, DomainOrigin &origin) {
    const PlaceFinder finder(before);
    std::vector<std::uint32_t> node;
    node.reserve(after.nodes.size());
    for (const Vec2 place : after.nodes) {
        node.push_back(finder.find(place));
    }
    const auto reorder = [&](DomainPartKind kind, std::size_t count, const auto &numberOf) {
        const std::vector<PartOrigin> known = std::move(origin.of(kind));
        origin.of(kind).clear();
        for (std::size_t k = 0; k < count; ++k) {
            const std::uint32_t number = numberOf(k);
            origin.of(kind).push_back(number < known.size() ? known[number] : PartOrigin{});
        }
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> segmentAt;
    for (std::uint32_t s = 0; s < before.segments.size(); ++s) {
        segmentAt.emplace(std::minmax(before.segments[s].a, before.segments[s].b), s);
    }
    std::map<std::uint32_t, std::uint32_t> pointAt;
    for (std::uint32_t p = 0; p < before.points.size(); ++p) {
        pointAt.emplace(before.points[p].node, p);
    }
    reorder(DomainPartKind::Node, after.nodes.size(), [&](std::size_t k) { return node[k]; });
    reorder(DomainPartKind::Segment, after.segments.size(), [&](std::size_t k) {
        const std::uint32_t a = node[after.segments[k].a], b = node[after.segments[k].b];
        const auto found = segmentAt.find(std::minmax(a, b));
        return found == segmentAt.end() ? kNoIndex : found->second;
    });
    reorder(DomainPartKind::ConstraintPoint, after.points.size(), [&](std::size_t k) {
        const auto found = pointAt.find(node[after.points[k].node]);
        return found == pointAt.end() ? kNoIndex : found->second;
    });
}

} // namespace forefront
