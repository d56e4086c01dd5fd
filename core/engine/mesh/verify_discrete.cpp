#include "core/engine/mesh/verify_discrete.hpp"

#include "core/engine/base/out_of_memory.hpp"
#include "core/engine/mesh/edge_table.hpp"
#include "core/engine/mesh/orientation.hpp"
#include "core/engine/mesh/verify.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>

namespace forefront {

namespace {

/// An edge of the mesh that the domain requires, lower node first.
struct RequiredEdge {
    NodeId lower = kNoNode, upper = kNoNode;
    std::int32_t tag = 1;
    bool inner = false; ///< the domain is on both sides
    friend bool operator<(const RequiredEdge &a, const RequiredEdge &b) {
        return a.lower != b.lower ? a.lower < b.lower : a.upper < b.upper;
    }
};
using RequiredEdges = std::vector<RequiredEdge>;

const RequiredEdge *find(const RequiredEdges &sorted, NodeId a, NodeId b) {
    const RequiredEdge key{std::min(a, b), std::max(a, b)};
    const auto it = std::lower_bound(sorted.begin(), sorted.end(), key);
    return it != sorted.end() && it->lower == key.lower && it->upper == key.upper ? &*it : nullptr;
}

std::string segmentName(const DiscreteSegment &s, const MeshNumbers &numbers) {
    return std::to_string(numbers.nodes.of(s.a)) + '-' + std::to_string(numbers.nodes.of(s.b)) + " (tag " +
           std::to_string(s.tag) + ')';
}

/// Checks that each side of a segment has an element of the right region, or none outside the domain.
void checkSides(const MeshView &mesh, bool tagged, const DiscreteDomain &domain, const DiscreteSegment &s, NodeId a,
                const HalfEdges &halfEdges, std::span<const HalfEdge> sides, const MeshNumbers &numbers,
                FaultList &faults) {
    const Vec2 place = midpoint(domain.nodes[s.a], domain.nodes[s.b]);
    for (const bool left : {true, false}) {
        const std::uint32_t region = left ? s.leftRegion : s.rightRegion;
        const char *sideName = left ? "left" : "right";
        const auto side =
            std::find_if(sides.begin(), sides.end(), [&](HalfEdge h) { return (halfEdges.startOf(h) == a) == left; });
        if (region == kOutside) {
            if (side != sides.end()) {
                faults.add("element-outside",
                           std::string("an element lies ") + sideName + " of boundary segment " +
                               segmentName(s, numbers) + ", outside the domain",
                           place, {static_cast<std::uint32_t>(halfEdges.elementOf(*side))});
            }
        } else if (side == sides.end()) {
            faults.add("missing-element",
                       std::string("no element lies ") + sideName + " of segment " + segmentName(s, numbers), place);
        } else if (tagged && mesh.region(halfEdges.elementOf(*side)) != domain.regions[region].tag) {
            faults.add("wrong-region",
                       "element " + std::to_string(numbers.elements.of(halfEdges.elementOf(*side))) + " has region " +
                           std::to_string(mesh.region(halfEdges.elementOf(*side))) + " instead of " +
                           std::to_string(domain.regions[region].tag),
                       place, {static_cast<std::uint32_t>(halfEdges.elementOf(*side))});
        }
    }
}

RequiredEdges checkSegments(const MeshView &mesh, bool tagged, const DiscreteDomain &domain, const EdgeTable &table,
                            const NodeFinder &nodes, const MeshNumbers &numbers, FaultList &faults) {
    RequiredEdges required;
    required.reserve(domain.segments.size());
    for (const DiscreteSegment &s : domain.segments) {
        const NodeId a = nodes.find(domain.nodes[s.a]), b = nodes.find(domain.nodes[s.b]);
        const std::span<const HalfEdge> sides =
            a != kNoNode && b != kNoNode ? table.find(a, b) : std::span<const HalfEdge>{};
        if (sides.empty()) {
            faults.add("missing-segment", "segment " + segmentName(s, numbers) + " is not an edge of the mesh",
                       midpoint(domain.nodes[s.a], domain.nodes[s.b]), {s.a, s.b});
            continue;
        }
        required.push_back({std::min(a, b), std::max(a, b), s.tag, isInner(s)});
        checkSides(mesh, tagged, domain, s, a, table.halfEdges(), sides, numbers, faults);
    }
    std::sort(required.begin(), required.end());
    return required;
}

/// Checks that the edge of each segment is tagged once, with the segment's tag, and that no other edge is tagged. Inner
/// ones need no tag without `innerTags`.
void checkTags(const MeshView &mesh, const RequiredEdges &required, bool innerTags, FaultList &faults) {
    std::vector<bool> tagged(required.size(), false);
    for (const TaggedEdge &edge : mesh.edges) {
        const Vec2 place = midpoint(mesh.nodes[index(edge.a)], mesh.nodes[index(edge.b)]);
        const RequiredEdge *segment = find(required, edge.a, edge.b);
        if (segment == nullptr) {
            faults.add("unexpected-tagged-edge",
                       "a tagged edge (tag " + std::to_string(edge.tag) + ") does not lie on any segment of the domain",
                       place);
            continue;
        }
        if (edge.tag != segment->tag) {
            faults.add("wrong-tag",
                       "an edge has tag " + std::to_string(edge.tag) + " instead of " + std::to_string(segment->tag),
                       place);
        }
        const auto rank = static_cast<std::size_t>(segment - required.data());
        if (tagged[rank]) {
            faults.add("duplicate-tagged-edge", "an edge is tagged twice", place);
        }
        tagged[rank] = true;
    }
    for (std::size_t i = 0; i < required.size(); ++i) {
        if (!tagged[i] && (innerTags || !required[i].inner)) {
            faults.add("missing-tagged-edge", "the edge of a segment has no tag",
                       midpoint(mesh.nodes[index(required[i].lower)], mesh.nodes[index(required[i].upper)]));
        }
    }
}

/// Checks that away from the segments the mesh has neither boundary edges nor changes of region.
void checkInside(const MeshView &mesh, const RequiredEdges &required, const EdgeTable &table, FaultList &faults) {
    const HalfEdges &halfEdges = table.halfEdges();
    table.forEach([&](NodeId a, NodeId b, std::span<const HalfEdge> sides) {
        const bool open = sides.size() == 1;
        const bool divided =
            !open && mesh.region(halfEdges.elementOf(sides[0])) != mesh.region(halfEdges.elementOf(sides[1]));
        if ((open || divided) && find(required, a, b) == nullptr) {
            faults.add(open ? "unexpected-boundary" : "wrong-region",
                       open ? "a boundary edge of the mesh does not lie on any segment of the domain"
                            : "the region changes across an edge that does not lie on any segment of the domain",
                       midpoint(mesh.nodes[index(a)], mesh.nodes[index(b)]),
                       {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
        }
    });
}

void checkPoints(const MeshView &mesh, bool tagged, const DiscreteDomain &domain, const NodeFinder &nodes,
                 const MeshNumbers &numbers, FaultList &faults) {
    std::vector<TaggedNode> points(mesh.points.begin(), mesh.points.end());
    std::sort(points.begin(), points.end(), [](const TaggedNode &a, const TaggedNode &b) { return a.node < b.node; });
    for (const ConstraintPoint &point : domain.taggedPoints()) {
        const Vec2 place = domain.nodes[point.node];
        const NodeId node = nodes.find(place);
        const auto it = std::lower_bound(points.begin(), points.end(), node,
                                         [](const TaggedNode &a, NodeId key) { return a.node < key; });
        if (node == kNoNode || (tagged && (it == points.end() || it->node != node))) {
            faults.add("missing-point",
                       "inner point " + std::to_string(numbers.nodes.of(point.node)) + " is not a node of the mesh",
                       place, {point.node});
        } else if (tagged && it->tag != point.tag) {
            faults.add("wrong-tag",
                       "a point has tag " + std::to_string(it->tag) + " instead of " + std::to_string(point.tag),
                       place);
        }
    }
}

/// Sums cross products of vectors between nodes with extended precision, and bounds the error of the sum.
///
/// With u the unit roundoff of the terms, both differences of a product l are rounded, then l itself: l errs by 3u·|l|,
/// and a term l - r by 4u·(|l| + |r|). Adding n terms errs by n·u times the sum of their magnitudes at most. Products
/// of errors are far below the margin of one more u.
class AreaSum {
  public:
    void add(Vec2 a, Vec2 b, Vec2 c, Vec2 d) { // (b - a) × (d - c)
        using Real = long double;
        const Real left = (Real(b.x) - a.x) * (Real(d.y) - c.y), right = (Real(b.y) - a.y) * (Real(d.x) - c.x);
        sum_ += left - right;
        products_ += std::abs(left) + std::abs(right);
        terms_ += std::abs(left - right);
        count_ += 1.0L;
    }
    /// Returns half the sum.
    BoundedArea area() const {
        constexpr long double kUnit = 0.5L * std::numeric_limits<long double>::epsilon();
        const long double error = kUnit * (5.0L * products_ + count_ * terms_);
        const auto rounded = static_cast<double>(0.5L * sum_);
        return {rounded,
                static_cast<double>(0.5L * error) + std::numeric_limits<double>::epsilon() * std::abs(rounded)};
    }

  private:
    long double sum_ = 0.0L, products_ = 0.0L, terms_ = 0.0L, count_ = 0.0L;
};

/// Bounds the error of the areas of regions that discretise() sums in doubles: a term (a - o) × (b - a) errs by 5u
/// times its products, as in AreaSum, for an origin o in the domain; each segment belongs to two regions at most. The
/// sums are compensated; their results and the sum over the regions are rounded.
double regionsError(const DiscreteDomain &domain) {
    constexpr double kUnit = 0.5 * std::numeric_limits<double>::epsilon();
    const Vec2 size = domain.bounds().size();
    double products = 0.0, areas = 0.0;
    for (const DiscreteSegment &s : domain.segments) {
        const Vec2 d = domain.nodes[s.b] - domain.nodes[s.a];
        products += size.x * std::abs(d.y) + size.y * std::abs(d.x);
    }
    for (const DiscreteRegion &region : domain.regions) {
        areas += std::abs(region.area);
    }
    return kUnit * (5.0 * products + (static_cast<double>(domain.regions.size()) + 2.0) * areas);
}

/// Compares the areas within their rounding errors.
void checkArea(const MeshView &mesh, const DiscreteDomain &domain, FaultList &faults) {
    const BoundedArea is = meshArea(mesh), enclosed = enclosedArea(domain);
    for (const BoundedArea &must : {enclosed, BoundedArea{domain.area(), regionsError(domain)}}) {
        if (!(std::abs(is.area - must.area) <= is.error + must.error)) {
            char text[120];
            std::snprintf(text, sizeof text, "the area of the mesh is %.17g instead of %.17g", is.area, must.area);
            faults.add("area", text, mesh.bounds().centre());
            return;
        }
    }
}

} // namespace

bool carriesNoTags(const MeshView &mesh) {
    return mesh.edges.empty() && mesh.points.empty() &&
           std::all_of(mesh.blocks().begin(), mesh.blocks().end(), [](const MeshView::Block &block) {
               return std::all_of(block.regions.begin(), block.regions.end(),
                                  [](std::int32_t region) { return region == 1; });
           });
}

NodeFinder::NodeFinder(const MeshView &mesh, bool innerTags) : nodes_(mesh.nodes) {
    if (mesh.edges.empty() || !innerTags) {
        sorted_.reserve(mesh.nodes.size());
        for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n) {
            sorted_.push_back(NodeId{n});
        }
    } else {
        sorted_.reserve(2 * mesh.edges.size() + mesh.points.size());
        for (const TaggedEdge &edge : mesh.edges) {
            sorted_.push_back(edge.a);
            sorted_.push_back(edge.b);
        }
        for (const TaggedNode &point : mesh.points) {
            sorted_.push_back(point.node);
        }
    }
    std::sort(sorted_.begin(), sorted_.end(), [&mesh](NodeId a, NodeId b) {
        const Vec2 pa = mesh.nodes[index(a)], pb = mesh.nodes[index(b)];
        return pa == pb ? a < b : comesBefore(pa, pb);
    });
}

NodeId NodeFinder::find(Vec2 p) const {
    const auto it = std::lower_bound(sorted_.begin(), sorted_.end(), p,
                                     [this](NodeId n, Vec2 q) { return comesBefore(nodes_[index(n)], q); });
    return it != sorted_.end() && nodes_[index(*it)] == p ? *it : kNoNode;
}

BoundedArea meshArea(const MeshView &mesh) {
    AreaSum sum;
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size(); ++k) {
            const std::span<const NodeId> n = block.nodesOf(k);
            const Vec2 a = mesh.nodes[index(n[0])], b = mesh.nodes[index(n[1])], c = mesh.nodes[index(n[2])];
            sum.add(a, b, a, c);
            if (block.traits().corners == 4) {
                sum.add(a, c, a, mesh.nodes[index(n[3])]);
            }
        }
    }
    return sum.area();
}

BoundedArea enclosedArea(const DiscreteDomain &domain) {
    const Vec2 centre = domain.bounds().centre();
    AreaSum sum;
    for (const DiscreteSegment &s : domain.segments) {
        const bool leftOut = s.leftRegion == kOutside, rightOut = s.rightRegion == kOutside;
        if (leftOut != rightOut) {
            const Vec2 a = domain.nodes[rightOut ? s.a : s.b], b = domain.nodes[rightOut ? s.b : s.a];
            sum.add(centre, a, a, b); // not (a - c) × (b - c): the products would be larger by far
        }
    }
    return sum.area();
}

MeshView turnedRight(const MeshView &mesh, std::optional<Mesh> &copy) {
    return isClockwise(mesh) ? MeshView(copy.emplace(turned(copyOf(mesh)))) : mesh;
}

void checkAgainst(const MeshView &mesh, const DiscreteDomain &domain, FaultList &faults, const MeshNumbers &numbers,
                  bool innerTags) {
    const EdgeTable table(mesh);
    const NodeFinder nodes(mesh, innerTags);
    const bool tagged = !carriesNoTags(mesh);
    const RequiredEdges required = checkSegments(mesh, tagged, domain, table, nodes, numbers, faults);
    if (tagged) {
        checkTags(mesh, required, innerTags, faults);
    }
    checkInside(mesh, required, table, faults);
    checkPoints(mesh, tagged, domain, nodes, numbers, faults);
    checkArea(mesh, domain, faults);
}

Diagnostics verifyAgainst(const MeshView &mesh, const DiscreteDomain &domain, std::size_t limit) {
    return orOutOfMemory("to check the mesh", [&] {
        Diagnostics own = verify(mesh, limit);
        if (hasErrors(own)) {
            return own;
        }
        FaultList faults(limit);
        std::optional<Mesh> copy;
        checkAgainst(turnedRight(mesh, copy), domain, faults);
        Diagnostics found = faults.take();
        found.insert(found.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
        return found;
    });
}

} // namespace forefront
