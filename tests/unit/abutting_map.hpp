#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "tests/unit/edit_support.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace forefront::edit_test {

/// A rectangular region divided into shapes that share sides, corners and parts of sides.
class AbuttingMap {
  public:
    explicit AbuttingMap(Random &random) : random_(random) {
        divide({{0, 0}, {12, 9}}, 4);
        document = documentOf(std::move(shapes_));
        for (const auto &shape : document.shapes) {
            const std::vector<Vec2> handles = handlesOf(*shape);
            for (std::uint32_t k = 0; k < handles.size(); ++k) {
                places_.push_back({{shape->id, k}, handles[k]});
            }
        }
        findJoints();
        findOutline();
    }

    Document document;

    /// Returns the longest distance between what was joined at the start.
    double widestGap(const Document &now) const {
        double widest = 0.0;
        for (const auto &[node, other] : joined_) {
            widest = std::max(widest, distance(at(now, node), at(now, other)));
        }
        for (const auto &[node, side] : onSides_) {
            const Vec2 a = at(now, side.first), along = at(now, side.second) - a;
            widest = std::max(widest, std::fabs(cross(along, at(now, node) - a)) / length(along));
        }
        return widest;
    }

    /// Returns the area of the outline minus the sum of the areas of the shapes.
    double missingArea(const Document &now) const {
        double sum = 0.0;
        for (const auto &shape : now.shapes) {
            sum += signedArea(handlesOf(*shape));
        }
        std::vector<Vec2> outline;
        for (const NodeRef node : outline_) {
            outline.push_back(at(now, node));
        }
        return signedArea(outline) - sum;
    }

    /// Returns true if all nodes on sides are still between their ends, and no shape has become flat or turned over.
    bool isInOrder(const Document &now) const {
        constexpr double kFlat = 1e-3;
        const bool between = std::all_of(onSides_.begin(), onSides_.end(), [&](const auto &on) {
            const Vec2 a = at(now, on.second.first), along = at(now, on.second.second) - a;
            const double t = dot(at(now, on.first) - a, along) / lengthSquared(along);
            return t > kFlat && t < 1.0 - kFlat;
        });
        return between && std::all_of(now.shapes.begin(), now.shapes.end(), [](const auto &shape) {
                   const std::vector<Vec2> nodes = handlesOf(*shape);
                   double shortest = distance(nodes[3], nodes[0]);
                   for (std::size_t k = 0; k < 3; ++k) {
                       shortest = std::min(shortest, distance(nodes[k], nodes[k + 1]));
                   }
                   return shortest > kFlat && signedArea(nodes) > 0.0;
               });
    }

  private:
    static Vec2 at(const Document &document, NodeRef node) {
        return handlesOf(*findShape(document, node.shape))[node.node];
    }
    static double signedArea(const std::vector<Vec2> &nodes) {
        double twice = 0.0;
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            twice += cross(nodes[k], nodes[(k + 1) % nodes.size()]);
        }
        return 0.5 * twice;
    }

    void divide(const Box2 &box, int depth) {
        const Vec2 size = box.max - box.min;
        if (depth == 0 || (depth < 3 && random_.below(4) == 0)) {
            shapes_.push_back(random_.below(2) == 0
                                  ? makeShape(ShapeKind::Rectangle, {box.min, box.max})
                                  : makeShape(ShapeKind::Polygon,
                                              {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}));
            return;
        }
        const double share = 0.25 * (1 + random_.below(3));
        Box2 low = box, high = box;
        if (size.x > size.y) {
            low.max.x = high.min.x = box.min.x + share * size.x;
        } else {
            low.max.y = high.min.y = box.min.y + share * size.y;
        }
        divide(low, depth - 1);
        divide(high, depth - 1);
    }

    void findJoints() {
        for (const auto &[node, place] : places_) {
            for (const auto &[other, there] : places_) {
                if (node < other && place == there) {
                    joined_.emplace_back(node, other);
                }
                const NodeRef end{other.shape, (other.node + 1) % 4};
                const Vec2 along = at(document, end) - there;
                const double t = dot(place - there, along) / lengthSquared(along);
                if (other.shape != node.shape && t > 0.0 && t < 1.0 && cross(along, place - there) == 0.0) {
                    onSides_.emplace_back(node, std::pair(other, end));
                }
            }
        }
    }

    void findOutline() {
        const auto side = [](Vec2 p) { return p.y == 0 ? 0 : p.x == 12 ? 1 : p.y == 9 ? 2 : p.x == 0 ? 3 : 4; };
        std::vector<std::pair<double, NodeRef>> around;
        for (const auto &[node, p] : places_) {
            const double way[] = {p.x, 12 + p.y, 21 + (12 - p.x), 33 + (9 - p.y)};
            if (side(p) < 4) {
                around.emplace_back(p == Vec2{0, 0} ? 0.0 : way[side(p)], node);
            }
        }
        std::sort(around.begin(), around.end());
        for (std::size_t k = 0; k < around.size(); ++k) {
            if (k == 0 || around[k].first > around[k - 1].first) {
                outline_.push_back(around[k].second);
            }
        }
    }

    Random &random_;
    std::vector<Shape> shapes_;
    std::vector<std::pair<NodeRef, Vec2>> places_;
    std::vector<std::pair<NodeRef, NodeRef>> joined_;
    std::vector<std::pair<NodeRef, std::pair<NodeRef, NodeRef>>> onSides_;
    std::vector<NodeRef> outline_;
};

} // namespace forefront::edit_test
