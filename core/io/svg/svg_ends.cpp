#include "core/io/svg/svg_ends.hpp"

#include <algorithm>
#include <cstddef>

namespace forefront {

namespace {

/// Moves the end of a path to its beginning, and the curve that leads there with it: the curve is turned and scaled
/// about its own beginning.
void moveEnd(SvgPath &path) {
    const Vec2 begin = path.nodes.front(), end = path.nodes.back();
    path.nodes.back() = begin;
    const std::size_t last = path.nodes.size() - 2; // segment
    if (last >= path.stretches.size() || !path.stretches[last].follows()) {
        return;
    }
    std::size_t first = last;
    while (first > 0 && path.stretches[first - 1].curve == path.stretches[last].curve) {
        --first;
    }
    const Vec2 from = path.nodes[first], before = end - from, after = begin - from;
    const double square = lengthSquared(before);
    if (first == 0 || !(square > 0.0)) {
        return; // one curve all around
    }
    const Vec2 turn = (1.0 / square) * Vec2{dot(before, after), cross(before, after)}; // a complex factor
    const auto moved = [&](Vec2 p) {
        const Vec2 q = p - from;
        return from + Vec2{turn.x * q.x - turn.y * q.y, turn.x * q.y + turn.y * q.x};
    };
    Curve &curve = path.curves[path.stretches[last].curve];
    curve = curve.mapped(moved);
    std::transform(path.nodes.begin() + static_cast<std::ptrdiff_t>(first) + 1, path.nodes.end() - 1,
                   path.nodes.begin() + static_cast<std::ptrdiff_t>(first) + 1, moved);
}

} // namespace

void joinEnds(SvgPath &path, double size) {
    constexpr double kMostRounding = 1e-4; // of the size
    const double tolerance = std::max(kSameNode * size, std::min(path.rounding, kMostRounding * size));
    std::vector<Vec2> &nodes = path.nodes;
    while (nodes.size() > 1 && distance(nodes.front(), nodes.back()) <= tolerance) {
        path.joined = path.joined || (!path.closed && nodes.size() > 3);
        path.closed = path.closed || path.joined;
        if (nodes.back() != nodes.front()) {
            moveEnd(path);
        }
        nodes.pop_back();
        // The segment that led to the removed node now leads to the first one.
        path.stretches.resize(std::min(path.stretches.size(), nodes.size()));
    }
}

} // namespace forefront
