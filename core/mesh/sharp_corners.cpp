#include "core/mesh/sharp_corners.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

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
std::vector<Wedge> sharpWedges(const Mesh &mesh, double limit) {
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
double minAngle(const Mesh &mesh, const Element &e) {
    const Vec2 a = mesh.nodes[index(e[0])], b = mesh.nodes[index(e[1])], c = mesh.nodes[index(e[2])];
    const double twiceArea = cross(b - a, c - a);
    if (!(twiceArea > 0.0)) {
        return 0.0;
    }
    const double cosines = std::max({dot(b - a, c - a), dot(a - b, c - b), dot(a - c, b - c)});
    return std::atan2(twiceArea, cosines) * kDegrees;
}

/// The elements that cannot be reached from the tips across common sides.
std::vector<Element> notReached(std::vector<Element> reached, const std::vector<Element> &elements) {
    using Side = std::pair<NodeId, NodeId>;
    std::map<Side, std::size_t> withSide; // each direction of a side has one element
    for (std::size_t i = 0; i < elements.size(); ++i) {
        for (unsigned k = 0; k < 3; ++k) {
            withSide[{elements[i][k], elements[i][(k + 1) % 3]}] = i;
        }
    }
    std::vector<std::uint8_t> done(elements.size(), 0);
    while (!reached.empty()) {
        const Element e = reached.back();
        reached.pop_back();
        for (unsigned k = 0; k < 3; ++k) {
            const auto across = withSide.find({e[(k + 1) % 3], e[k]});
            if (across != withSide.end() && done[across->second] == 0) {
                done[across->second] = 1;
                reached.push_back(elements[across->second]);
            }
        }
    }
    std::vector<Element> others;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (done[i] == 0) {
            others.push_back(elements[i]);
        }
    }
    return others;
}

} // namespace

SharpCorners sharpCorners(const Mesh &mesh, double limit) {
    std::vector<Wedge> wedges = sharpWedges(mesh, limit);
    std::vector<std::uint8_t> sharp(mesh.nodes.size(), 0);
    for (const Wedge &w : wedges) {
        sharp[index(w.node)] = 1;
    }
    std::vector<std::uint8_t> tagged(mesh.nodes.size(), 0);
    for (const TaggedEdge &edge : mesh.edges) {
        tagged[index(edge.a)] = tagged[index(edge.b)] = 1;
    }
    SharpCorners result;
    result.minAngleElsewhere = mesh.elements.empty() ? 0.0 : 60.0;
    std::vector<Element> tips, strips;
    for (const Element &e : mesh.elements) {
        bool inCorner = false;
        for (unsigned k = 0; k < 3; ++k) {
            if (sharp[index(e[k])] == 0) {
                continue;
            }
            const Vec2 at = mesh.nodes[index(e[k])];
            const Vec2 middle = midpoint(mesh.nodes[index(e[(k + 1) % 3])], mesh.nodes[index(e[(k + 2) % 3])]) - at;
            for (auto w = std::lower_bound(wedges.begin(), wedges.end(), e[k]); w != wedges.end() && w->node == e[k];
                 ++w) {
                if (turnFrom(w->from, middle) < w->angle) {
                    w->meshed = inCorner = true;
                }
            }
        }
        if (inCorner) {
            tips.push_back(e);
            continue;
        }
        const double angle = minAngle(mesh, e);
        if (angle < limit && !wedges.empty() &&
            (tagged[index(e[0])] & tagged[index(e[1])] & tagged[index(e[2])]) != 0) {
            strips.push_back(e);
        } else {
            result.minAngleElsewhere = std::min(result.minAngleElsewhere, angle);
        }
    }
    for (const Element &e : notReached(tips, strips)) {
        result.minAngleElsewhere = std::min(result.minAngleElsewhere, minAngle(mesh, e));
    }
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
