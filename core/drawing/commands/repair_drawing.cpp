#include "core/drawing/commands/repair_drawing.hpp"

#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/domain/domain_shapes.hpp"
#include "core/drawing/domain/domain_sources.hpp"
#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/same_place.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/validate.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <set>
#include <tuple>
#include <utility>

namespace forefront {
namespace {

/// Two places in either order, as a key.
using Ends = std::tuple<double, double, double, double>;
Ends endsOf(Vec2 a, Vec2 b) {
    const bool swapped = comesBefore(b, a);
    return swapped ? Ends{b.x, b.y, a.x, a.y} : Ends{a.x, a.y, b.x, b.y};
}

/// A set of finite places.
class PlaceSet {
  public:
    void add(Vec2 p) {
        if (isFinite(p)) {
            places_.emplace(p.x, p.y);
        }
    }
    bool has(Vec2 p) const { return isFinite(p) && places_.contains({p.x, p.y}); }

  private:
    std::set<std::pair<double, double>> places_;
};

/// A segment of the result from one of its ends, and the shape it comes from.
struct NamedEdge {
    Vec2 from, to;
    std::uint32_t shape = 0; ///< index into Document::shapes

    static bool before(const NamedEdge &a, const NamedEdge &b) { return comesBefore(a.from, b.from); }
};

/// Finds the shapes that a repair changed, and makes new shapes from their parts of the result.
class DrawingRepair {
  public:
    explicit DrawingRepair(const Document &document) : document_(document), given_(toDomain(document, sources_)) {}

    Result<RepairedDrawing> run(double tolerance) {
        Result<Repaired> repaired = repair(given_, tolerance);
        if (!repaired) {
            return repaired.faults();
        }
        RepairedDrawing result{document_, std::move(repaired->changes), validate(repaired->domain), {}};
        if (!result.changes.empty()) {
            findChanged(*repaired);
            const RepairedDrawing unchanged = result;
            if (Status faults = replaceChanged(*repaired, LooseEnds::MoveCurve, result); !faults.empty()) {
                return faults;
            }
            if (!given_.curves.empty() && validate(toDomain(result.document)).size() > result.left.size()) {
                result = unchanged;
                if (Status faults = replaceChanged(*repaired, LooseEnds::MoveChord, result); !faults.empty()) {
                    return faults;
                }
            }
        }
        return result;
    }

  private:
    /// A shape is unchanged if each of its segments, or its point, is part of the result as it was.
    void findChanged(const Repaired &repaired) {
        const Domain &domain = repaired.domain;
        std::vector<std::uint8_t> kept(given_.segments.size(), 0);
        for (std::size_t s = 0; s < domain.segments.size(); ++s) {
            const DomainSegment &now = domain.segments[s], &then = given_.segments[repaired.segmentSource[s]];
            if (now.role == then.role && sameEnds(now, then, domain)) {
                kept[repaired.segmentSource[s]] = 1;
            }
        }
        changed_.assign(document_.shapes.size(), 0);
        for (std::size_t s = 0; s < given_.segments.size(); ++s) {
            if (kept[s] == 0) {
                changed_[sources_.segments[s].shape] = 1;
            }
        }
        PlaceSet points, nodes;
        for (const ConstraintPoint &point : domain.points) {
            points.add(domain.nodes[point.node]);
        }
        for (const Vec2 node : domain.nodes) {
            nodes.add(node);
        }
        for (std::size_t k = 0; k < document_.shapes.size(); ++k) {
            const Shape &shape = *document_.shapes[k];
            if (shape.is<PointForm>() && !shape.construction) {
                const bool stays = (shape.use == ShapeUse::Constraint ? points : nodes).has(shape.nodes.front());
                changed_[k] = stays ? 0 : 1;
                if (stays && shape.use == ShapeUse::Constraint) {
                    unchangedPoints_.add(shape.nodes.front());
                }
            }
        }
    }

    bool sameEnds(const DomainSegment &now, const DomainSegment &then, const Domain &domain) const {
        const auto valid = [](const DomainSegment &segment, const Domain &of) {
            return std::max(segment.a, segment.b) < of.nodes.size();
        };
        return valid(now, domain) && valid(then, given_) &&
               endsOf(domain.nodes[now.a], domain.nodes[now.b]) == endsOf(given_.nodes[then.a], given_.nodes[then.b]);
    }

    Status replaceChanged(const Repaired &repaired, LooseEnds ends, RepairedDrawing &result) const {
        const Domain &domain = repaired.domain;
        Document &next = result.document;
        std::vector<std::uint32_t> segments, points;
        std::vector<NamedEdge> edges;
        for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
            const DomainSegment &segment = domain.segments[s];
            const std::uint32_t shape = sources_.segments[repaired.segmentSource[s]].shape;
            if (changed_[shape] != 0 && std::max(segment.a, segment.b) < domain.nodes.size()) {
                segments.push_back(s);
                edges.push_back({domain.nodes[segment.a], domain.nodes[segment.b], shape});
                edges.push_back({domain.nodes[segment.b], domain.nodes[segment.a], shape});
            }
        }
        for (std::uint32_t p = 0; p < domain.points.size(); ++p) {
            const Vec2 at = domain.nodes[domain.points[p].node];
            if (!unchangedPoints_.has(at)) {
                points.push_back(p);
            }
        }
        std::stable_sort(edges.begin(), edges.end(), NamedEdge::before);
        next.shapes.clear();
        for (std::size_t k = 0; k < document_.shapes.size(); ++k) {
            if (changed_[k] == 0) {
                next.shapes.push_back(document_.shapes[k]);
            }
        }
        std::vector<Shape> made = shapesOf(partOf(domain, segments, points), ends);
        moveSizes(repaired, made, result);
        for (Shape &shape : made) {
            shape.id = next.nextId++;
            shape.name = nameOf(shape, edges);
            if (Diagnostics faults = checkShape(shape); !faults.empty()) {
                return faults;
            }
            next.shapes.push_back(std::make_shared<const Shape>(std::move(shape)));
        }
        return {};
    }

    /// Gives the sizes at nodes of changed shapes to the nodes that these became: nodes of `made` or, where only shapes
    /// that stay have a node there, of these.
    void moveSizes(const Repaired &repaired, std::vector<Shape> &made, RepairedDrawing &result) const {
        const double reach = samePlaceDistance(document_);
        for (std::size_t k = 0; k < document_.shapes.size(); ++k) {
            if (changed_[k] == 0 || document_.shapes[k]->nodeSizes.empty()) {
                continue;
            }
            Shape shape = *document_.shapes[k];
            if (shape.is<RectangleForm>() && shape.as<RectangleForm>().radius > 0.0) {
                becomePath(shape); // a rounded corner is no node of the domain, the ends of its arc are
            }
            const std::vector<Vec2> handles = handlesOf(shape);
            for (const auto &[node, size] : shape.nodeSizes) {
                const Vec2 at = placeAfter(handles[node], repaired, reach);
                bool given = false;
                for (Shape &taker : made) {
                    given = giveSize(taker, at, size, reach) || given;
                }
                if (!given && !giveToUnchanged(result.document, at, size, reach)) {
                    result.lostSizes.push_back(lostSize(shape, node, size, handles[node]));
                }
            }
        }
    }

    /// Returns the place to which a node at a given place was moved.
    Vec2 placeAfter(Vec2 at, const Repaired &repaired, double reach) const {
        for (std::size_t n = 0; n < given_.nodes.size(); ++n) {
            if (distance(given_.nodes[n], at) <= reach && repaired.nodeResult[n] != kNoIndex) {
                return repaired.domain.nodes[repaired.nodeResult[n]];
            }
        }
        return at;
    }

    /// Gives a size to the nodes at a place. Returns false if there are none.
    static bool giveToUnchanged(Document &next, Vec2 at, const PartSize &size, double reach) {
        bool given = false;
        for (std::shared_ptr<const Shape> &shape : next.shapes) {
            if (!hasHandleNear(*shape, at, reach)) {
                continue;
            }
            Shape taker = *shape;
            if (giveSize(taker, at, size, reach)) {
                shape = std::make_shared<const Shape>(std::move(taker));
                given = true;
            }
        }
        return given;
    }

    static bool hasHandleNear(const Shape &shape, Vec2 at, double reach) {
        const std::vector<Vec2> handles = handlesOf(shape);
        return std::any_of(handles.begin(), handles.end(), [&](Vec2 handle) { return distance(handle, at) <= reach; });
    }

    static Diagnostic lostSize(const Shape &shape, std::uint32_t node, const PartSize &size, Vec2 at) {
        Diagnostic lost;
        lost.severity = Severity::Warning;
        lost.code = "lost-size";
        lost.message = nodeName(shape, node) + " lost its element size " + numberText(size.size, 6) +
                       ", because the repair removed the node";
        lost.advice = "give the size to a node nearby";
        lost.at = at;
        return lost;
    }

    /// Returns the name of the shape that the first chord of a new one comes from. On curves, places may be rounded,
    /// but for the first one.
    std::string nameOf(const Shape &made, const std::vector<NamedEdge> &edges) const {
        const Chords chords = chordsOf(made, outlineOf(made), document_.circleTolerance);
        if (chords.size() == 0) {
            return {};
        }
        const auto [first, last] =
            std::equal_range(edges.begin(), edges.end(), NamedEdge{chords.from(0), {}, 0}, NamedEdge::before);
        const auto nearest = std::min_element(first, last, [&](const NamedEdge &a, const NamedEdge &b) {
            return distanceSquared(a.to, chords.to(0)) < distanceSquared(b.to, chords.to(0));
        });
        return nearest != last ? document_.shapes[nearest->shape]->name : std::string();
    }

    const Document &document_;
    DomainSources sources_;
    Domain given_;
    std::vector<std::uint8_t> changed_; ///< per shape
    PlaceSet unchangedPoints_;
};

} // namespace

Result<RepairedDrawing> repairDrawing(const Document &document, double tolerance) {
    return DrawingRepair(document).run(tolerance);
}

} // namespace forefront
