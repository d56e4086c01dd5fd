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

/// Calls visit(const Element &) with the corners of each element.
template <class Visit>
void forTriangles(const MeshView &mesh, Visit &&visit) {
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size(); ++k) {
            const auto nodes = block.nodesOf(k);
            visit(Element{nodes[0], nodes[1], nodes[2]});
        }
    }
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

/// Returns the minimum angle of an element in degrees; 0 if it is not positive.
double minAngle(const MeshView &mesh, const Element &e) {
    const Vec2 a = mesh.nodes[index(e[0])], b = mesh.nodes[index(e[1])], c = mesh.nodes[index(e[2])];
    const double twiceArea = cross(b - a, c - a);
    if (!(twiceArea > 0.0)) {
        return 0.0;
    }
    const double cosines = std::max({dot(b - a, c - a), dot(a - b, c - b), dot(a - c, b - c)});
    return std::atan2(twiceArea, cosines) * kDegrees;
}

/// Sharp elements, and which of them lie side by side.
class Bands {
  public:
    explicit Bands(std::vector<Element> elements) : elements_(std::move(elements)), taken_(elements_.size(), 0) {
        for (std::size_t i = 0; i < elements_.size(); ++i) {
            for (unsigned k = 0; k < 3; ++k) {
                withSide_[{elements_[i][k], elements_[i][(k + 1) % 3]}] = i;
            }
        }
    }

    /// Takes the elements that can be reached from the given ones across common sides and have not been taken yet.
    std::vector<Element> take(std::vector<Element> from) {
        std::vector<Element> found;
        while (!from.empty()) {
            const Element e = from.back();
            from.pop_back();
            for (unsigned k = 0; k < 3; ++k) {
                const auto across = withSide_.find({e[(k + 1) % 3], e[k]});
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
    std::vector<Element> takeNext() {
        while (next_ < elements_.size() && taken_[next_] != 0) {
            ++next_;
        }
        if (next_ == elements_.size()) {
            return {};
        }
        taken_[next_] = 1;
        std::vector<Element> found = take({elements_[next_]});
        found.push_back(elements_[next_]);
        return found;
    }

  private:
    std::vector<Element> elements_;
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
    bool force(const Element &e) const {
        return isTagged(e[0]) && isTagged(e[1]) && isTagged(e[2]) ? !cutsFlatCorner(e) : hasShortestSideAcross(e);
    }

  private:
    /// Returns true if the element cuts off a flat corner between two tagged edges.
    bool cutsFlatCorner(const Element &e) const {
        for (unsigned k = 0; k < 3; ++k) {
            const NodeId at = e[k], b = e[(k + 1) % 3], c = e[(k + 2) % 3];
            const Vec2 p = mesh_.nodes[index(at)];
            const Vec2 u = mesh_.nodes[index(b)] - p, v = mesh_.nodes[index(c)] - p;
            if (dot(u, v) < -0.5 * length(u) * length(v)) { // at most one angle is beyond 120 degrees
                return isTagged(at, b) && isTagged(at, c);
            }
        }
        return false;
    }

    bool hasShortestSideAcross(const Element &e) const {
        const auto side = [&](unsigned k) {
            return distance(mesh_.nodes[index(e[k])], mesh_.nodes[index(e[(k + 1) % 3])]);
        };
        unsigned shortest = 0;
        for (unsigned k = 1; k < 3; ++k) {
            shortest = side(k) < side(shortest) ? k : shortest;
        }
        const NodeId a = e[shortest], b = e[(shortest + 1) % 3];
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

NarrowPlace placeOf(const MeshView &mesh, const std::vector<Element> &band) {
    NarrowPlace place{{}, std::numeric_limits<double>::infinity(), band.size()};
    for (const Element &e : band) {
        const Vec2 a = mesh.nodes[index(e[0])], b = mesh.nodes[index(e[1])], c = mesh.nodes[index(e[2])];
        const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
        const double height = longest > 0.0 ? std::max(0.0, cross(b - a, c - a)) / longest : 0.0;
        const Vec2 centre = (1.0 / 3.0) * (a + b + c);
        if (height < place.width ||
            (height == place.width && std::pair(centre.x, centre.y) < std::pair(place.at.x, place.at.y))) {
            place.width = height;
            place.at = centre;
        }
    }
    return place;
}

/// Returns true if an element lies in a wedge at one of its nodes, and marks all such wedges as meshed.
bool liesInWedge(const MeshView &mesh, const Element &e, const std::vector<std::uint8_t> &sharp,
                 std::vector<Wedge> &wedges) {
    bool inWedge = false;
    for (unsigned k = 0; k < 3; ++k) {
        if (sharp[index(e[k])] == 0) {
            continue;
        }
        const Vec2 at = mesh.nodes[index(e[k])];
        const Vec2 middle = midpoint(mesh.nodes[index(e[(k + 1) % 3])], mesh.nodes[index(e[(k + 2) % 3])]) - at;
        for (auto w = std::lower_bound(wedges.begin(), wedges.end(), e[k]); w != wedges.end() && w->node == e[k]; ++w) {
            if (turnFrom(w->from, middle) < w->angle) {
                w->meshed = inWedge = true;
            }
        }
    }
    return inWedge;
}

/// The sharp elements of a mesh by their reason.
struct SharpElements {
    std::vector<Element> tips;   ///< in sharp corners, as are some elements that are not sharp
    std::vector<Element> bands;  ///< forced by a gap
    std::vector<Element> others; ///< beside those, or without a reason
    double minAngleElsewhere = 60.0;
};

/// Sorts the sharp elements by their reason, and marks the wedges that elements lie in.
SharpElements sortElements(const MeshView &mesh, double limit, std::vector<Wedge> &wedges) {
    std::vector<std::uint8_t> sharp(mesh.nodes.size(), 0);
    for (const Wedge &w : wedges) {
        sharp[index(w.node)] = 1;
    }
    const Gaps gaps(mesh);
    SharpElements sorted;
    forTriangles(mesh, [&](const Element &e) {
        if (liesInWedge(mesh, e, sharp, wedges)) {
            sorted.tips.push_back(e);
            return;
        }
        const double angle = minAngle(mesh, e);
        if (angle < limit) {
            (gaps.force(e) ? sorted.bands : sorted.others).push_back(e);
        } else {
            sorted.minAngleElsewhere = std::min(sorted.minAngleElsewhere, angle);
        }
    });
    return sorted;
}

/// Returns the minimum angle of the sharp elements that no chain of sharp elements, each sharing a node with the next,
/// connects to tips or bands; 60 if there are none. (Cleanup lets elements around a gap share its small angles.)
double minAngleApart(const MeshView &mesh, const SharpElements &sorted) {
    std::vector<std::pair<NodeId, std::uint32_t>> others; // those at each node
    for (std::uint32_t i = 0; i < sorted.others.size(); ++i) {
        for (const NodeId n : sorted.others[i]) {
            others.emplace_back(n, i);
        }
    }
    std::sort(others.begin(), others.end());
    std::vector<Element> open = sorted.tips;
    open.insert(open.end(), sorted.bands.begin(), sorted.bands.end());
    std::vector<std::uint8_t> reached(sorted.others.size(), 0);
    while (!open.empty()) {
        const Element e = open.back();
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
    double minimum = 60.0;
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
    for (std::vector<Element> band = rest.takeNext(); !band.empty(); band = rest.takeNext()) {
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
