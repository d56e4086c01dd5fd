#include "core/engine/mesh/sharp_corners.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

namespace forefront {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Returns the angle from u to v, counter-clockwise, in [0, 360) degrees.
double turnFrom(Vec2 u, Vec2 v) {
    const double angle = std::atan2(cross(u, v), dot(u, v)) * kDegrees;
    return angle < 0.0 ? angle + 360.0 : angle;
}

/// The wedge at a node from one tagged edge counter-clockwise to the next.
struct Wedge {
    NodeId node;
    Vec2 from;
    double angle;
    bool meshed = false;
};

bool operator<(const Wedge &w, NodeId n) {
    return w.node < n;
}

/// Returns the wedges sharper than the limit, ordered by node, whether or not elements lie in them.
std::vector<Wedge> sharpWedges(const MeshView &mesh, double limit) {
    struct Ray {
        NodeId node;
        double direction;
        Vec2 to;
    };
    std::vector<Ray> rays;
    rays.reserve(2 * mesh.edges.size());
    for (const TaggedEdge &edge : mesh.edges) {
        const Vec2 along = mesh.nodes[index(edge.b)] - mesh.nodes[index(edge.a)];
        const Vec2 back = mesh.nodes[index(edge.a)] - mesh.nodes[index(edge.b)];
        rays.push_back({edge.a, std::atan2(along.y, along.x), along});
        rays.push_back({edge.b, std::atan2(back.y, back.x), back});
    }
    std::sort(rays.begin(), rays.end(), [](const Ray &r, const Ray &s) {
        return r.node != s.node ? r.node < s.node : r.direction < s.direction;
    });
    std::vector<Wedge> wedges;
    for (std::size_t begin = 0, end = 0; begin < rays.size(); begin = end) {
        while (end < rays.size() && rays[end].node == rays[begin].node) {
            ++end;
        }
        for (std::size_t i = begin; i < end && end - begin > 1; ++i) {
            const Ray &next = rays[i + 1 < end ? i + 1 : begin];
            const double angle = turnFrom(rays[i].to, next.to);
            if (angle > 0.0 && angle < limit) { // a repeated edge makes no corner
                wedges.push_back({rays[i].node, rays[i].to, angle});
            }
        }
    }
    return wedges;
}

/// The corners of an element, counter-clockwise.
using CornerRing = std::span<const NodeId>;

NodeId after(CornerRing e, std::size_t k) {
    return e[k + 1 == e.size() ? 0 : k + 1];
}
NodeId before(CornerRing e, std::size_t k) {
    return e[k == 0 ? e.size() - 1 : k - 1];
}

/// Returns the minimum angle of an element in degrees; 0 if one is not positive.
double minAngle(const MeshView &mesh, CornerRing e) {
    if (e.size() == 3) { // with one call of atan2
        const Vec2 a = mesh.nodes[index(e[0])], b = mesh.nodes[index(e[1])], c = mesh.nodes[index(e[2])];
        const double twiceArea = cross(b - a, c - a);
        const double cosines = std::max({dot(b - a, c - a), dot(a - b, c - b), dot(a - c, b - c)});
        return twiceArea > 0.0 ? std::atan2(twiceArea, cosines) * kDegrees : 0.0;
    }
    double least = 180.0;
    for (std::size_t k = 0; k < e.size(); ++k) {
        const Vec2 at = mesh.nodes[index(e[k])];
        const Vec2 ahead = mesh.nodes[index(after(e, k))] - at, back = mesh.nodes[index(before(e, k))] - at;
        const double turn = cross(ahead, back);
        if (!(turn > 0.0)) {
            return 0.0;
        }
        least = std::min(least, std::atan2(turn, dot(ahead, back)) * kDegrees);
    }
    return least;
}

/// Sharp elements, and which of them lie side by side.
class Bands {
  public:
    explicit Bands(std::vector<CornerRing> elements) : elements_(std::move(elements)), taken_(elements_.size(), 0) {
        for (std::size_t i = 0; i < elements_.size(); ++i) {
            for (std::size_t k = 0; k < elements_[i].size(); ++k) {
                withSide_[{elements_[i][k], after(elements_[i], k)}] = i;
            }
        }
    }

    /// Takes the elements that can be reached from the given ones across common sides and have not been taken yet.
    std::vector<CornerRing> take(std::vector<CornerRing> from) {
        std::vector<CornerRing> found;
        while (!from.empty()) {
            const CornerRing e = from.back();
            from.pop_back();
            for (std::size_t k = 0; k < e.size(); ++k) {
                const auto across = withSide_.find({after(e, k), e[k]});
                if (across != withSide_.end() && taken_[across->second] == 0) {
                    taken_[across->second] = 1;
                    from.push_back(elements_[across->second]);
                    found.push_back(elements_[across->second]);
                }
            }
        }
        return found;
    }

    /// Takes the next element that has not been taken yet and all that can be reached from it. Returns an empty list
    /// when all are taken.
    std::vector<CornerRing> takeNext() {
        while (next_ < elements_.size() && taken_[next_] != 0) {
            ++next_;
        }
        if (next_ == elements_.size()) {
            return {};
        }
        taken_[next_] = 1;
        std::vector<CornerRing> found = take({elements_[next_]});
        found.push_back(elements_[next_]);
        return found;
    }

  private:
    std::vector<CornerRing> elements_;
    std::vector<std::uint8_t> taken_;
    std::size_t next_ = 0;
    std::map<std::pair<NodeId, NodeId>, std::size_t> withSide_; // each direction of a side has one element
};

/// Finds the sharp elements that a gap forces.
class Gaps {
  public:
    explicit Gaps(const MeshView &mesh) : mesh_(mesh), onTagged_(mesh.nodes.size(), 0) {
        for (const TaggedEdge &edge : mesh.edges) {
            onTagged_[index(edge.a)] = onTagged_[index(edge.b)] = 1;
        }
        for (const TaggedNode &point : mesh.points) {
            onTagged_[index(point.node)] = 1;
        }
        sides_.reserve(mesh.edges.size());
        for (const TaggedEdge &edge : mesh.edges) {
            sides_.push_back(std::minmax(edge.a, edge.b));
        }
        std::sort(sides_.begin(), sides_.end());
    }

    /// Returns true if a gap forces this sharp element: all its nodes, or the ends of its shortest side, lie across a
    /// gap, as between two tips.
    bool force(CornerRing e) const {
        return std::all_of(e.begin(), e.end(), [this](NodeId n) { return isTagged(n); }) ? !cutsFlatCorner(e)
                                                                                         : hasShortestSideAcross(e);
    }

  private:
    /// Returns true if the element cuts off a flat corner between two tagged edges.
    bool cutsFlatCorner(CornerRing e) const {
        for (std::size_t k = 0; k < e.size(); ++k) {
            const NodeId at = e[k], b = after(e, k), c = before(e, k);
            const Vec2 p = mesh_.nodes[index(at)];
            const Vec2 u = mesh_.nodes[index(b)] - p, v = mesh_.nodes[index(c)] - p;
            if (dot(u, v) < -0.5 * length(u) * length(v)) { // at most one angle is beyond 120 degrees
                return isTagged(at, b) && isTagged(at, c);
            }
        }
        return false;
    }

    bool hasShortestSideAcross(CornerRing e) const {
        const auto side = [&](std::size_t k) {
            return distance(mesh_.nodes[index(e[k])], mesh_.nodes[index(after(e, k))]);
        };
        std::size_t shortest = 0;
        for (std::size_t k = 1; k < e.size(); ++k) {
            shortest = side(k) < side(shortest) ? k : shortest;
        }
        const NodeId a = e[shortest], b = after(e, shortest);
        return isTagged(a) && isTagged(b) && !isTagged(a, b);
    }

    bool isTagged(NodeId a) const { return onTagged_[index(a)] != 0; }
    bool isTagged(NodeId a, NodeId b) const {
        return std::binary_search(sides_.begin(), sides_.end(), std::pair<NodeId, NodeId>(std::minmax(a, b)));
    }

    const MeshView &mesh_;
    std::vector<std::uint8_t> onTagged_; ///< per node: it must be where it is
    std::vector<std::pair<NodeId, NodeId>> sides_;
};

NarrowPlace placeOf(const MeshView &mesh, const std::vector<CornerRing> &band) {
    NarrowPlace place{{}, std::numeric_limits<double>::infinity(), band.size()};
    for (CornerRing e : band) {
        double longest = 0.0, twiceArea = 0.0;
        Vec2 sum;
        for (std::size_t k = 0; k < e.size(); ++k) {
            const Vec2 first = mesh.nodes[index(e[0])], at = mesh.nodes[index(e[k])],
                       next = mesh.nodes[index(after(e, k))];
            longest = std::max(longest, distance(at, next));
            twiceArea += cross(at - first, next - first);
            sum += at;
        }
        // Of a triangle its height, of a quadrilateral its mean width along the longest side.
        const double over = e.size() == 3 ? longest : 2.0 * longest;
        const double height = longest > 0.0 ? std::max(0.0, twiceArea) / over : 0.0;
        const Vec2 centre = (1.0 / static_cast<double>(e.size())) * sum;
        if (height < place.width ||
            (height == place.width && std::pair(centre.x, centre.y) < std::pair(place.at.x, place.at.y))) {
            place.width = height;
            place.at = centre;
        }
    }
    return place;
}

/// Returns true if an element lies in a wedge at one of its nodes, and marks all such wedges as meshed.
bool liesInWedge(const MeshView &mesh, CornerRing e, const std::vector<std::uint8_t> &sharp,
                 std::vector<Wedge> &wedges) {
    bool inWedge = false;
    for (std::size_t k = 0; k < e.size(); ++k) {
        if (sharp[index(e[k])] == 0) {
            continue;
        }
        const Vec2 at = mesh.nodes[index(e[k])];
        const Vec2 middle = midpoint(mesh.nodes[index(after(e, k))], mesh.nodes[index(before(e, k))]) - at;
        for (auto w = std::lower_bound(wedges.begin(), wedges.end(), e[k]); w != wedges.end() && w->node == e[k]; ++w) {
            if (turnFrom(w->from, middle) < w->angle) {
                w->meshed = inWedge = true;
            }
        }
    }
    return inWedge;
}

/// Returns the largest minimum angle that elements of a mesh can have, in degrees.
double largestMinimum(const MeshView &mesh) {
    const bool hasTriangles = std::any_of(mesh.blocks().begin(), mesh.blocks().end(),
                                          [](const MeshView::Block &block) { return block.traits().corners == 3; });
    return hasTriangles ? 60.0 : 90.0;
}

/// The sharp elements of a mesh by their reason.
struct SharpElements {
    std::vector<CornerRing> tips;   ///< in sharp corners, as are some elements that are not sharp
    std::vector<CornerRing> bands;  ///< forced by a gap
    std::vector<CornerRing> others; ///< beside those, or without a reason
    double minAngleElsewhere;
};

/// Sorts the sharp elements by their reason, and marks the wedges that elements lie in.
SharpElements sortElements(const MeshView &mesh, double limit, std::vector<Wedge> &wedges) {
    std::vector<std::uint8_t> sharp(mesh.nodes.size(), 0);
    for (const Wedge &w : wedges) {
        sharp[index(w.node)] = 1;
    }
    const Gaps gaps(mesh);
    SharpElements sorted{{}, {}, {}, largestMinimum(mesh)};
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size(); ++k) {
            const CornerRing e = block.nodesOf(k).first(block.traits().corners);
            if (liesInWedge(mesh, e, sharp, wedges)) {
                sorted.tips.push_back(e);
                continue;
            }
            const double angle = minAngle(mesh, e);
            if (angle < limit) {
                (gaps.force(e) ? sorted.bands : sorted.others).push_back(e);
            } else {
                sorted.minAngleElsewhere = std::min(sorted.minAngleElsewhere, angle);
            }
        }
    }
    return sorted;
}

/// Returns the minimum angle of the sharp elements that no chain of sharp elements, each sharing a node with the next,
/// connects to tips or bands; largestMinimum() if there are none. (Cleanup lets elements around a gap share its small
/// angles.)
double minAngleApart(const MeshView &mesh, const SharpElements &sorted) {
    std::vector<std::pair<NodeId, std::uint32_t>> others; // those at each node
    for (std::uint32_t i = 0; i < sorted.others.size(); ++i) {
        for (const NodeId n : sorted.others[i]) {
            others.emplace_back(n, i);
        }
    }
    std::sort(others.begin(), others.end());
    std::vector<CornerRing> open = sorted.tips;
    open.insert(open.end(), sorted.bands.begin(), sorted.bands.end());
    std::vector<std::uint8_t> reached(sorted.others.size(), 0);
    while (!open.empty()) {
        const CornerRing e = open.back();
        open.pop_back();
        for (const NodeId n : e) {
            for (auto at = std::lower_bound(others.begin(), others.end(), std::pair(n, 0U));
                 at != others.end() && at->first == n; ++at) {
                if (std::exchange(reached[at->second], 1) == 0) {
                    open.push_back(sorted.others[at->second]);
                }
            }
        }
    }
    double minimum = largestMinimum(mesh);
    for (std::size_t i = 0; i < sorted.others.size(); ++i) {
        minimum = reached[i] == 0 ? std::min(minimum, minAngle(mesh, sorted.others[i])) : minimum;
    }
    return minimum;
}

/// Returns the places of the bands that do not end in a sharp corner, the narrowest first.
std::vector<NarrowPlace> narrowPlaces(const MeshView &mesh, const SharpElements &sorted) {
    Bands rest(sorted.bands);
    rest.take(sorted.tips);
    std::vector<NarrowPlace> places;
    for (std::vector<CornerRing> band = rest.takeNext(); !band.empty(); band = rest.takeNext()) {
        places.push_back(placeOf(mesh, band));
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const NarrowPlace &p, const NarrowPlace &q) { return p.width < q.width; });
    return places;
}

} // namespace

SharpCorners sharpCorners(const MeshView &mesh, double limit) {
    std::vector<Wedge> wedges = sharpWedges(mesh, limit);
    const SharpElements sorted = sortElements(mesh, limit, wedges);
    SharpCorners result;
    result.minAngleElsewhere =
        mesh.elementCount() == 0 ? 0.0 : std::min(sorted.minAngleElsewhere, minAngleApart(mesh, sorted));
    result.narrow = narrowPlaces(mesh, sorted);
    for (const Wedge &w : wedges) {
        if (w.meshed) {
            result.corners.push_back({w.node, mesh.nodes[index(w.node)], w.angle});
        }
    }
    std::stable_sort(result.corners.begin(), result.corners.end(),
                     [](const SharpCorner &c, const SharpCorner &d) { return c.angle < d.angle; });
    return result;
}

} // namespace forefront
