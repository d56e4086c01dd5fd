#include "core/drawing_files/svg/areas/svg_ends.hpp"

#include <algorithm>
#include <cstddef>

namespace forefront {

namespace {

void popLast(SvgPath &path) {
    path.joined = path.joined || (!path.closed && path.nodes.size() > 3);
    path.closed = path.closed || path.joined;
    path.nodes.pop_back();
    // The segment that led to the removed node now leads to the first one.
    path.stretches.resize(std::min(path.stretches.size(), path.nodes.size()));
}

/// Returns the first segment of the curve, or the straight segment, that leads to the end of a path.
std::size_t lastPart(const SvgPath &path) {
    std::size_t first = path.nodes.size() - 2;
    if (first < path.stretches.size() && path.stretches[first].follows()) {
        const std::uint32_t curve = path.stretches[first].curve;
        while (first > 0 && path.stretches[first - 1].curve == curve) {
            --first;
        }
    }
    return first;
}

/// Moves the end of a path to its beginning. A curve that leads there is turned and scaled about its own beginning.
void moveEnd(SvgPath &path, std::size_t part) {
    const Vec2 begin = path.nodes.front(), from = path.nodes[part];
    const Vec2 before = path.nodes.back() - from, after = begin - from;
    path.nodes.back() = begin;
    if (part >= path.stretches.size() || !path.stretches[part].follows()) {
        return;
    }
    const Vec2 turn =
        (1.0 / lengthSquared(before)) * Vec2{dot(before, after), cross(before, after)}; // a complex factor
    const auto moved = [&](Vec2 p) {
        const Vec2 q = p - from;
        return from + Vec2{turn.x * q.x - turn.y * q.y, turn.x * q.y + turn.y * q.x};
    };
    Curve &curve = path.curves[path.stretches[part].curve];
    curve = curve.mapped(moved);
    const auto inner = path.nodes.begin() + static_cast<std::ptrdiff_t>(part) + 1;
    std::transform(inner, path.nodes.end() - 1, inner, moved);
}

} // namespace

void joinEnds(SvgPath &path, double size) {
    constexpr double kMaxRounding = 1e-4; // fraction of the size
    constexpr double kMaxShare = 0.05;    // fraction of the distance that the last part spans
    const auto gap = [&] { return distance(path.nodes.front(), path.nodes.back()); };
    while (path.nodes.size() > 1 && gap() <= kSameNode * size) {
        popLast(path);
    }
    if (path.nodes.size() < 3 || gap() > std::min(path.rounding, kMaxRounding * size)) {
        return;
    }
    const std::size_t part = lastPart(path);
    if (gap() <= kMaxShare * distance(path.nodes[part], path.nodes.back())) {
        moveEnd(path, part);
        popLast(path);
    }
}

} // namespace forefront
