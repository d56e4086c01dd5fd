#pragma once

#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace forefront::edit_test {

inline Shape makeShape(ShapeKind kind, std::vector<Vec2> nodes, ShapeUse use = ShapeUse::Boundary,
                       std::int32_t tag = 1) {
    Shape shape;
    shape.form = formOf(kind);
    shape.use = use;
    shape.nodes = std::move(nodes);
    shape.tag = tag;
    return shape;
}

inline Shape square(Vec2 low, double side, ShapeUse use = ShapeUse::Boundary) {
    return makeShape(ShapeKind::Polygon, {low, low + Vec2{side, 0}, low + Vec2{side, side}, low + Vec2{0, side}}, use);
}

/// Returns the code of the first fault; empty if there is none.
inline std::string codeOf(const Result<Document> &result) {
    return result ? std::string() : result.faults().front().code;
}

/// Returns a drawing of valid shapes, numbered from 1.
inline Document documentOf(std::vector<Shape> shapes) {
    Result<Document> document = addShapes({}, std::move(shapes));
    REQUIRE_MESSAGE(document.ok(), codeOf(document));
    return *std::move(document);
}

inline Selection selected(std::set<std::uint32_t> shapes) {
    Selection selection;
    selection.shapes = std::move(shapes);
    return selection;
}

/// A segment by its coordinates, smaller end first: compares domains independently of the order of nodes and segments.
using SortedSegment = std::tuple<double, double, double, double, std::int32_t, int>;

inline std::vector<SortedSegment> sortedSegments(const Domain &domain) {
    std::vector<SortedSegment> sorted;
    for (const DomainSegment &s : domain.segments) {
        Vec2 a = domain.nodes[s.a], b = domain.nodes[s.b];
        if (std::tuple(b.x, b.y) < std::tuple(a.x, a.y)) {
            std::swap(a, b);
        }
        sorted.emplace_back(a.x, a.y, b.x, b.y, s.tag, static_cast<int>(s.role));
    }
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

inline std::vector<std::pair<double, double>> sortedNodes(const Domain &domain) {
    std::vector<std::pair<double, double>> sorted;
    for (const Vec2 node : domain.nodes) {
        sorted.emplace_back(node.x, node.y);
    }
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

/// Returns true if p is inside by the even-odd rule over Boundary segments.
inline bool insideEvenOdd(const Domain &domain, Vec2 p) {
    bool inside = false;
    for (const DomainSegment &s : domain.segments) {
        const Vec2 a = domain.nodes[s.a], b = domain.nodes[s.b];
        if (s.role == SegmentRole::Boundary && (a.y > p.y) != (b.y > p.y) &&
            p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) {
            inside = !inside;
        }
    }
    return inside;
}

/// A small deterministic generator for property tests.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15ULL + 1) {}
    std::uint64_t next() {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        return state_;
    }
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>((next() >> 32) % n); }
    double real(double low, double high) { return low + (high - low) * static_cast<double>(next() >> 11) * 0x1.0p-53; }
    Vec2 place(double extent) { return {real(-extent, extent), real(-extent, extent)}; }

  private:
    std::uint64_t state_;
};

/// Returns true if two domains have the same nodes, curves and segments.
inline bool sameDomain(const Domain &a, const Domain &b) {
    const auto same = [](const DomainSegment &s, const DomainSegment &t) {
        return s.a == t.a && s.b == t.b && s.tag == t.tag && s.role == t.role && s.stretch == t.stretch;
    };
    return a.nodes == b.nodes && a.curves == b.curves &&
           std::equal(a.segments.begin(), a.segments.end(), b.segments.begin(), b.segments.end(), same);
}

/// Returns the number of curved segments of all shapes.
inline std::size_t curvedSegments(const Document &document) {
    std::size_t count = 0;
    for (const auto &shape : document.shapes) {
        const Outline outline = outlineOf(*shape);
        for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
            count += outline.isCurved(k) ? 1U : 0U;
        }
    }
    return count;
}

} // namespace forefront::edit_test
