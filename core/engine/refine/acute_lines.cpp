#include "core/engine/refine/acute_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace forefront {

namespace {

constexpr double kStraight =
    -0.866;                    ///< edges whose directions from their node have a lower cosine continue one another
constexpr double kAcute = 0.5; ///< cosine of 60 degrees

NodeId otherEnd(const TaggedEdge &edge, NodeId n) {
    return edge.a == n ? edge.b : edge.a;
}

Vec2 chordFrom(const TriMesh &mesh, std::uint32_t edge, NodeId node) {
    return mesh.nodes[index(otherEnd(mesh.edges[edge], node))] - mesh.nodes[index(node)];
}

/// Returns the direction in which a tagged edge, or the curve that it is a chord of, leaves a node.
Vec2 tangentFrom(const TriMesh &mesh, std::uint32_t edge, NodeId node) {
    if (mesh.edgeStretches.empty() || !mesh.edgeStretches[edge].follows()) {
        return chordFrom(mesh, edge, node);
    }
    CurveStretch stretch = mesh.edgeStretches[edge];
    if (mesh.edges[edge].a != node) {
        stretch = stretch.reversed();
    }
    return mesh.curves[stretch.curve].part(stretch.t0, stretch.t1).tangent(0.0);
}

double cosineBetween(Vec2 u, Vec2 v) {
    return dot(u, v) / std::sqrt(lengthSquared(u) * lengthSquared(v));
}

} // namespace

AcuteLines::AcuteLines(const TriMesh &mesh)
    : lineOfEdge_(mesh.edges.size(), kNoIndex), lineAt_(mesh.nodes.size(), kNoIndex) {
    offsets_.assign(mesh.nodes.size() + 1, 0);
    for (const TaggedEdge &edge : mesh.edges) {
        ++offsets_[index(edge.a) + 1];
        ++offsets_[index(edge.b) + 1];
    }
    std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
    at_.resize(offsets_.back());
    std::vector<std::uint32_t> next(offsets_.begin(), offsets_.end() - 1);
    for (std::uint32_t i = 0; i < mesh.edges.size(); ++i) {
        at_[next[index(mesh.edges[i].a)]++] = i;
        at_[next[index(mesh.edges[i].b)]++] = i;
    }
    trace(mesh);
    findCorners(mesh);
    offsets_ = {};
    at_ = {};
}

void AcuteLines::trace(const TriMesh &mesh) {
    // Returns the edge that continues another through a node, or kNoIndex.
    const auto continuation = [&](std::uint32_t edge, NodeId through) {
        const std::uint32_t begin = offsets_[index(through)];
        if (offsets_[index(through) + 1] - begin != 2) {
            return kNoIndex;
        }
        const std::uint32_t other = at_[begin] == edge ? at_[begin + 1] : at_[begin];
        return cosineBetween(chordFrom(mesh, edge, through), chordFrom(mesh, other, through)) < kStraight ? other
                                                                                                          : kNoIndex;
    };
    std::uint32_t lines = 0;
    for (std::uint32_t first = 0; first < mesh.edges.size(); ++first) {
        if (lineOfEdge_[first] != kNoIndex) {
            continue;
        }
        const std::uint32_t line = lines++;
        lineOfEdge_[first] = line;
        for (const bool forward : {true, false}) {
            std::uint32_t edge = first;
            NodeId end = forward ? mesh.edges[first].b : mesh.edges[first].a;
            for (std::uint32_t on; (on = continuation(edge, end)) != kNoIndex; end = otherEnd(mesh.edges[edge], end)) {
                lineAt_[index(end)] = line;
                edge = on;
                if (lineOfEdge_[on] != kNoIndex) { // closed
                    break;
                }
                lineOfEdge_[on] = line;
            }
        }
    }
}

void AcuteLines::findCorners(const TriMesh &mesh) {
    for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n) {
        const NodeId node{n};
        for (std::uint32_t i = offsets_[n]; i < offsets_[n + 1] && lineAt_[n] == kNoIndex; ++i) {
            for (std::uint32_t j = offsets_[n]; j < offsets_[n + 1]; ++j) {
                // Curves may leave at another angle than their first chords, and both must be counted with.
                const std::uint32_t p = at_[i], q = at_[j];
                const double cosine = std::max(cosineBetween(chordFrom(mesh, p, node), chordFrom(mesh, q, node)),
                                               cosineBetween(tangentFrom(mesh, p, node), tangentFrom(mesh, q, node)));
                if (i != j && cosine > kAcute) {
                    corners_.push_back({node, lineOfEdge_[p], lineOfEdge_[q], cosine});
                    acute_.push_back(node);
                }
            }
        }
    }
    acute_.erase(std::unique(acute_.begin(), acute_.end()), acute_.end()); // ascending already
    std::stable_sort(corners_.begin(), corners_.end(), [](const Corner &p, const Corner &q) {
        return p.line != q.line ? p.line < q.line : p.other < q.other;
    });
}

std::optional<AcuteLines::Division> AcuteLines::division(const TriMesh &mesh, std::uint32_t edge) const {
    const auto isAcute = [&](NodeId n) { return std::binary_search(acute_.begin(), acute_.end(), n); };
    const TaggedEdge &ends = mesh.edges[edge];
    const bool atA = isAcute(ends.a), atB = isAcute(ends.b);
    if (atA == atB) {
        return std::nullopt;
    }
    // Between 1/3 and 2/3 of the length.
    const double length = distance(mesh.nodes[index(ends.a)], mesh.nodes[index(ends.b)]);
    return Division{atA, std::exp2(std::floor(std::log2(length * (2.0 / 3.0))))};
}

void AcuteLines::divided(std::uint32_t edge, NodeId node) {
    const std::uint32_t line = lineOfEdge_[edge];
    lineOfEdge_.push_back(line);
    lineAt_.resize(index(node) + 1, kNoIndex);
    lineAt_[index(node)] = line;
}

std::optional<AcuteLines::Corner> AcuteLines::between(const TriMesh &mesh, NodeId p, NodeId q) const {
    const std::uint32_t line = lineOf(p), other = lineOf(q);
    if (line == kNoIndex || other == kNoIndex) {
        return std::nullopt;
    }
    const auto first = std::lower_bound(
        corners_.begin(), corners_.end(), std::pair(line, other),
        [](const Corner &c, std::pair<std::uint32_t, std::uint32_t> key) { return std::pair(c.line, c.other) < key; });
    std::optional<Corner> nearest; // two lines may meet at both ends
    const auto away = [&](const Corner &c) { return distanceSquared(mesh.nodes[index(c.node)], mesh.nodes[index(p)]); };
    for (auto c = first; c != corners_.end() && c->line == line && c->other == other; ++c) {
        nearest = !nearest || away(*c) < away(*nearest) ? *c : *nearest;
    }
    return nearest;
}

NodeId AcuteLines::enclosingCorner(const TriMesh &mesh, const Element &element, double cosine) const {
    for (unsigned k = 0; k < 3; ++k) {
        const std::optional<Corner> corner = between(mesh, element[k], element[(k + 1) % 3]);
        const NodeId third = element[(k + 2) % 3];
        if (corner && corner->cosine >= cosine &&
            (third == corner->node || lineOf(third) == corner->line || lineOf(third) == corner->other)) {
            return corner->node;
        }
    }
    return kNoNode;
}

NodeId AcuteLines::spannedCorner(const TriMesh &mesh, const Element &element, double cosine) const {
    unsigned shortest = 0;
    const auto side = [&](unsigned k) {
        return distanceSquared(mesh.nodes[index(element[k])], mesh.nodes[index(element[(k + 1) % 3])]);
    };
    for (unsigned k = 1; k < 3; ++k) {
        shortest = side(k) < side(shortest) ? k : shortest;
    }
    const NodeId p = element[shortest], q = element[(shortest + 1) % 3], r = element[(shortest + 2) % 3];
    const std::optional<Corner> corner = between(mesh, p, q);
    if (!corner || corner->cosine < cosine) {
        return kNoNode;
    }
    const Vec2 tip = mesh.nodes[index(corner->node)];
    const double dp = distance(tip, mesh.nodes[index(p)]), dq = distance(tip, mesh.nodes[index(q)]);
    constexpr double kEqual = 1e-3;
    const std::uint32_t third = lineOf(r);
    const bool spans = std::abs(dp - dq) <= kEqual * std::max(dp, dq) &&
                       (r == corner->node || third == corner->line || third == corner->other);
    return spans ? corner->node : kNoNode;
}

} // namespace forefront
