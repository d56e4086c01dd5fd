#include "core/drawing/domain/draw_shapes.hpp"

#include "core/drawing/domain/joined_places.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/domain/node_merger.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace forefront {
namespace {

class ShapeDrawer {
  public:
    ShapeDrawer(const Document &document, DrawnDomain &drawn, const GivenSizes &given)
        : document_(document), drawn_(drawn), given_(given), merger_(drawn.domain.nodes),
          places_(document, drawn.samePlace) {
        drawn.farthest = places_.farthest();
    }

    void addPoint(const Shape &shape, std::uint32_t number) {
        for (std::uint32_t k = 0; k < shape.nodes.size(); ++k) {
            const std::uint32_t node = addNode(places_.of(shape.nodes[k]), {number, k});
            if (k == 0 && shape.use == ShapeUse::Constraint) {
                drawn_.domain.points.push_back({node, shape.tag});
                drawn_.joints.push_back({node, number});
                if (drawn_.sources != nullptr) {
                    drawn_.sources->points.push_back({number, 0});
                }
            }
        }
    }

    void addOutline(const Shape &shape, std::uint32_t number) {
        Outline outline = outlineOf(shape);
        places_.apply(outline);
        const Chords chords = chordsOf(shape, outline, document_.circleTolerance);
        const std::vector<SegmentSource> sources =
            drawn_.sources != nullptr ? given_.sourcesOf(shape, number, outline) : std::vector<SegmentSource>();
        std::vector<std::uint32_t> ids;
        ids.reserve(chords.nodes.size());
        for (std::uint32_t k = 0; k < chords.nodes.size(); ++k) {
            const auto end = static_cast<std::uint32_t>(outline.segmentCount());
            ids.push_back(addNode(chords.nodes[k], {number, k < chords.size() ? chords.segments[k] : end}));
        }
        const auto first = static_cast<std::uint32_t>(drawn_.domain.segments.size());
        if (isClosed(shape)) {
            drawn_.loops.push_back({first, first + static_cast<std::uint32_t>(chords.size())});
        }
        for (std::size_t k = 0; k < chords.size(); ++k) {
            addChord(shape, number, outline, chords, k, ids);
            if (drawn_.sources != nullptr) {
                drawn_.sources->segments.push_back(sources[chords.segments[k]]);
            }
        }
        if (!outline.closed && !ids.empty()) {
            drawn_.joints.push_back({ids.back(), number});
        }
    }

  private:
    std::uint32_t addNode(Vec2 at, const ShapeNode &source) {
        const std::uint32_t id = merger_.add(at);
        if (drawn_.sources != nullptr && drawn_.sources->nodes.size() < drawn_.domain.nodes.size()) {
            drawn_.sources->nodes.push_back(source);
        }
        return id;
    }

    /// Adds chord `k` of an outline, and its curve where the chord is the first of it. `ids`: the nodes of the chords.
    void addChord(const Shape &shape, std::uint32_t number, const Outline &outline, const Chords &chords, std::size_t k,
                  const std::vector<std::uint32_t> &ids) {
        Domain &domain = drawn_.domain;
        const SegmentRole role = shape.use == ShapeUse::Boundary ? SegmentRole::Boundary : SegmentRole::Constraint;
        const std::uint32_t segment = chords.segments[k];
        const bool given = segment < shape.cuts.size() && !shape.cuts[segment].empty();
        drawn_.flattened = drawn_.flattened || (chords.stretches[k].follows() && !given);
        CurveStretch stretch = chords.stretches[k];
        if (stretch.follows()) {
            if (stretch.t0 == 0.0) {
                domain.curves.push_back(outline.curves[segment]);
            }
            stretch.curve = static_cast<std::uint32_t>(domain.curves.size() - 1);
        }
        if (!stretch.follows() || stretch.t0 == 0.0) {
            drawn_.joints.push_back({ids[k], number});
        }
        domain.segments.push_back(
            {ids[k], ids[k + 1 == ids.size() ? 0 : k + 1], segmentTag(shape, outline.part(segment)), role, stretch});
        drawn_.shapes.push_back(number);
    }

    const Document &document_;
    DrawnDomain &drawn_;
    const GivenSizes &given_;
    NodeMerger merger_;
    JoinedPlaces places_;
};

} // namespace

void drawShapes(const Document &document, DrawnDomain &drawn, const GivenSizes &given) {
    ShapeDrawer drawer(document, drawn, given);
    for (std::uint32_t number = 0; number < document.shapes.size(); ++number) {
        const Shape &shape = *document.shapes[number];
        if (!shape.construction) {
            shape.is<PointForm>() ? drawer.addPoint(shape, number) : drawer.addOutline(shape, number);
        }
    }
}

} // namespace forefront
