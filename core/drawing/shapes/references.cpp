#include "core/drawing/shapes/references.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/spacing/spec/source_box.hpp"

#include <algorithm>
#include <unordered_map>

namespace forefront {

namespace {

/// Adds the selected nodes and segments of a shape to a box.
void addParts(Box2 &box, const Shape &shape, const Selection &selection) {
    const auto node = selection.nodes.lower_bound({shape.id, 0});
    if (node != selection.nodes.end() && node->shape == shape.id) {
        const std::vector<Vec2> handles = handlesOf(shape);
        for (auto k = node; k != selection.nodes.end() && k->shape == shape.id && k->node < handles.size(); ++k) {
            box.add(handles[k->node]);
        }
    }
    const auto segment = selection.segments.lower_bound({shape.id, 0});
    if (segment != selection.segments.end() && segment->shape == shape.id) {
        const Outline outline = outlineOf(shape);
        for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
            if (selection.segments.contains({shape.id, outline.part(k)})) {
                box.add(outline.curve(k).bounds());
            }
        }
    }
}

} // namespace

std::size_t positionOf(const Document &document, std::uint32_t id) {
    const auto &shapes = document.shapes;
    std::size_t low = 0, high = shapes.size();
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (shapes[middle]->id == id) {
            return middle;
        }
        (shapes[middle]->id < id ? low : high) = shapes[middle]->id < id ? middle + 1 : middle;
    }
    // Commands may have changed the order.
    const auto found = std::find_if(shapes.begin(), shapes.end(), [id](const auto &shape) { return shape->id == id; });
    return static_cast<std::size_t>(found - shapes.begin());
}

const Shape *findShape(const Document &document, std::uint32_t id) {
    const std::size_t position = positionOf(document, id);
    return position < document.shapes.size() ? document.shapes[position].get() : nullptr;
}

void Selection::prune(const Document &document) {
    std::unordered_map<std::uint32_t, const Shape *> byId;
    constexpr std::size_t kFew = 64; // found one by one: faster during a drag in a large drawing
    const bool few = shapes.size() + nodes.size() + segments.size() <= kFew;
    byId.reserve(few ? 0 : document.shapes.size());
    for (std::size_t k = 0; k < document.shapes.size() && !few; ++k) {
        byId.emplace(document.shapes[k]->id, document.shapes[k].get());
    }
    const auto find = [&](std::uint32_t id) {
        const auto found = byId.find(id);
        const Shape *const shape = few ? findShape(document, id) : found == byId.end() ? nullptr : found->second;
        return shape != nullptr && !shape->hidden && !shape->locked ? shape : nullptr;
    };
    std::erase_if(shapes, [&](std::uint32_t id) { return find(id) == nullptr; });
    std::erase_if(nodes, [&](NodeRef ref) {
        const Shape *shape = find(ref.shape);
        return shape == nullptr || ref.node >= handleCount(*shape);
    });
    std::erase_if(segments, [&](SegmentRef ref) {
        const Shape *shape = find(ref.shape);
        return shape == nullptr || ref.segment >= taggedSegments(*shape);
    });
    std::erase_if(sides, [&](const auto &side) {
        const Shape *const shape = shapes.contains(side.first) ? find(side.first) : nullptr;
        return shape == nullptr || side.second >= taggedSegments(*shape);
    });
    std::erase_if(sources, [&](std::uint32_t k) { return k >= document.spacing.sources.size(); });
    std::erase_if(markers, [&](std::uint32_t k) { return k >= document.regionMarkers.size(); });
    std::erase_if(constraints, [&](std::uint32_t id) {
        return std::none_of(document.constraints.begin(), document.constraints.end(),
                            [id](const auto &constraint) { return constraint->id == id; });
    });
}

bool Selection::touches(std::uint32_t shape) const {
    const auto node = nodes.lower_bound({shape, 0});
    const auto segment = segments.lower_bound({shape, 0});
    return shapes.contains(shape) || (node != nodes.end() && node->shape == shape) ||
           (segment != segments.end() && segment->shape == shape);
}

void Selection::drop(const std::set<std::uint32_t> &gone) {
    std::erase_if(shapes, [&](std::uint32_t id) { return gone.contains(id); });
    std::erase_if(nodes, [&](NodeRef node) { return gone.contains(node.shape); });
    std::erase_if(segments, [&](SegmentRef segment) { return gone.contains(segment.shape); });
    std::erase_if(sides, [&](const auto &side) { return gone.contains(side.first); });
}

Selection everythingIn(const Document &document) {
    Selection all;
    for (const auto &shape : document.shapes) {
        all.shapes.insert(shape->id);
    }
    for (std::uint32_t k = 0; k < document.spacing.sources.size(); ++k) {
        all.sources.insert(k);
    }
    for (std::uint32_t k = 0; k < document.regionMarkers.size(); ++k) {
        all.markers.insert(k);
    }
    return all;
}

Selection selectAll(const Document &document) {
    Selection all = everythingIn(document);
    for (const auto &shape : document.shapes) {
        if (shape->hidden || shape->locked) {
            all.shapes.erase(shape->id);
        }
    }
    return all;
}

Selection selectTag(const Document &document, std::int32_t tag) {
    Selection selection;
    for (const auto &shape : document.shapes) {
        if (shape->hidden || shape->locked) {
            continue;
        }
        const std::size_t segments = shape->segmentTags.empty() || isRound(*shape) ? 0 : taggedSegments(*shape);
        if (segments == 0 && shape->tag == tag) {
            selection.shapes.insert(shape->id);
        }
        for (std::uint32_t k = 0; k < segments; ++k) {
            if (segmentTag(*shape, k) == tag) {
                selection.segments.insert({shape->id, k});
            }
        }
    }
    return selection;
}

Box2 boundsOf(const Document &document, const Selection &selection) {
    Box2 box;
    for (const auto &shape : document.shapes) {
        if (selection.shapes.contains(shape->id)) {
            box.add(boundsOf(*shape));
        } else {
            addParts(box, *shape, selection);
        }
    }
    for (const std::uint32_t k : selection.sources) {
        if (k < document.spacing.sources.size()) {
            const SizeSource &source = document.spacing.sources[k];
            box.add(boxAround(source.a, source.radius));
            if (source.shape == SourceShape::Box) {
                for (const Vec2 corner : SourceBox(source).corners()) {
                    box.add(boxAround(corner, source.radius));
                }
            } else if (source.shape == SourceShape::Line) {
                box.add(boxAround(source.b, source.radius));
            }
        }
    }
    for (const std::uint32_t k : selection.markers) {
        if (k < document.regionMarkers.size()) {
            box.add(document.regionMarkers[k].at);
        }
    }
    for (const Vec2 place : selection.faces) {
        box.add(place);
    }
    return box;
}

} // namespace forefront
