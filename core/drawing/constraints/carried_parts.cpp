#include "core/drawing/constraints/carried_parts.hpp"

#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {
namespace {

/// Returns true if the lists have the same places in another order, as after reversing a path.
bool reordered(std::vector<Vec2> before, std::vector<Vec2> after) {
    if (before == after) {
        return false;
    }
    std::sort(before.begin(), before.end(), comesBefore);
    std::sort(after.begin(), after.end(), comesBefore);
    return before == after;
}

/// Returns true if the parts of a shape may have other indices after a command.
bool hasOtherParts(const Shape &old, const Shape &now) {
    return old.form.index() != now.form.index() || handleCount(old) != handleCount(now) ||
           isClosed(old) != isClosed(now) || reordered(old.nodes, now.nodes);
}

/// Returns the neighbours of a place in a list, those that exist.
std::vector<Vec2> neighbours(const std::vector<Vec2> &places, bool loop, std::size_t k) {
    const std::size_t n = places.size();
    std::vector<Vec2> list;
    if (k > 0 || loop) {
        list.push_back(places[(k + n - 1) % n]);
    }
    if (k + 1 < n || loop) {
        list.push_back(places[(k + 1) % n]);
    }
    return list;
}

std::size_t sharedPlaces(const std::vector<Vec2> &a, const std::vector<Vec2> &b) {
    return static_cast<std::size_t>(
        std::count_if(a.begin(), a.end(), [&](Vec2 p) { return std::find(b.begin(), b.end(), p) != b.end(); }));
}

} // namespace

CarriedParts::CarriedParts(const Document &before, const Document &next) : before_(before), next_(next) {
    for (const auto &constraint : next.constraints) {
        follow(constraint->parts);
    }
    findAdded();
}

CarriedParts::CarriedParts(const Document &before, const Document &next, std::span<const SketchPart> parts)
    : before_(before), next_(next) {
    follow(parts);
    findAdded();
}

void CarriedParts::follow(std::span<const SketchPart> parts) {
    for (const SketchPart &part : parts) {
        const Shape *const old = findShape(before_, part.shape), *const now = findShape(next_, part.shape);
        if (part.shape != 0 && old != now && (now == nullptr || (old != nullptr && hasOtherParts(*old, *now)))) {
            changed_.insert(part.shape);
        }
    }
}

void CarriedParts::findAdded() {
    for (const auto &shape : next_.shapes) {
        if (!changed_.empty() && findShape(before_, shape->id) == nullptr) {
            added_.push_back(shape->id);
        }
    }
}

SketchPart CarriedParts::endOf(const SketchPart &segment) const {
    const Shape &shape = *findShape(before_, segment.shape);
    return {segment.shape, SketchPartKind::Node,
            static_cast<std::uint32_t>((segment.index + std::size_t{1}) % handleCount(shape))};
}

std::optional<SketchPart> CarriedParts::nodeIn(const Shape &shape, const std::vector<Vec2> &old, bool loop,
                                               std::uint32_t index) const {
    if (!isPath(shape) && !shape.is<RectangleForm>()) {
        return std::nullopt;
    }
    const std::vector<Vec2> now = handlesOf(shape), around = neighbours(old, loop, index);
    std::optional<std::uint32_t> best;
    std::size_t shared = 0;
    for (std::uint32_t k = 0; k < now.size(); ++k) {
        if (now[k] == old[index]) {
            const std::size_t same = sharedPlaces(around, neighbours(now, isClosed(shape), k));
            if (!best || same > shared) {
                best = k;
                shared = same;
            }
        }
    }
    return best ? std::optional(SketchPart{shape.id, SketchPartKind::Node, *best}) : std::nullopt;
}

std::optional<SketchPart> CarriedParts::node(const SketchPart &part) const {
    const Shape *const old = findShape(before_, part.shape), *const now = findShape(next_, part.shape);
    if (old == nullptr || part.index >= handleCount(*old)) {
        return std::nullopt;
    }
    if (old->is<CircleForm>() && now != nullptr && isPath(*now)) { // four arcs about its centre
        return SketchPart{part.shape, SketchPartKind::Centre, 0};
    }
    if (old->is<SlotForm>() && now != nullptr && isPath(*now)) {
        return SketchPart{part.shape, SketchPartKind::Centre, part.index == 0 ? 3U : 1U};
    }
    if (old->is<RectangleForm>() && now != nullptr && isPath(*now) && now->nodes.size() == 4) {
        return part; // its corners, which may have been turned as well
    }
    const std::vector<Vec2> places = handlesOf(*old);
    std::optional<SketchPart> found = now != nullptr ? nodeIn(*now, places, isClosed(*old), part.index) : std::nullopt;
    for (std::size_t k = 0; k < added_.size() && !found; ++k) {
        found = nodeIn(*findShape(next_, added_[k]), places, isClosed(*old), part.index);
    }
    return found;
}

std::optional<SketchPart> CarriedParts::shortened(const SketchPart &part) const {
    const Shape *const old = findShape(before_, part.shape), *const now = findShape(next_, part.shape);
    if (old == nullptr || now == nullptr || !changed(part.shape) || part.kind != SketchPartKind::Segment ||
        !isPath(*old) || !isPath(*now)) {
        return std::nullopt;
    }
    const Outline before = outlineOf(*old), after = outlineOf(*now);
    if (part.index >= before.segmentCount() || before.isCurved(part.index)) {
        return std::nullopt;
    }
    const Vec2 a = before.from(part.index), way = before.to(part.index) - a;
    const double size = length(way), slack = 1e-9 * size;
    const auto isOn = [&](Vec2 p) {
        const double along = dot(p - a, way) / size;
        return std::fabs(cross(p - a, way)) <= slack * size && along >= -slack && along <= size + slack;
    };
    std::optional<SketchPart> longest;
    double best = 0.0;
    for (std::uint32_t k = 0; k < after.segmentCount(); ++k) {
        const Vec2 from = after.from(k), to = after.to(k);
        const double reach = dot(to - from, way) / size;
        if (!after.isCurved(k) && isOn(from) && isOn(to) && reach > best && reach < size - slack) {
            best = reach;
            longest = SketchPart{now->id, SketchPartKind::Segment, k};
        }
    }
    return longest;
}

bool CarriedParts::isShortened(const SketchPart &part) const {
    const std::optional<SketchPart> rest = shortened(part);
    return rest && images(part) == std::vector<SketchPart>{*rest};
}

std::vector<SketchPart> CarriedParts::segment(const SketchPart &part) const {
    const Shape *const old = findShape(before_, part.shape), *const now = findShape(next_, part.shape);
    const bool round = old != nullptr && (old->is<CircleForm>() || old->is<SlotForm>());
    if (round && now != nullptr && isPath(*now)) {
        const bool whole = now->nodes.size() == 4; // else a node was inserted as well
        return whole ? std::vector<SketchPart>{part} : std::vector<SketchPart>();
    }
    if (old != nullptr && old->is<RectangleForm>() && now != nullptr && isPath(*now) && now->nodes.size() == 4) {
        return part.index < 4 ? std::vector<SketchPart>{part} : std::vector<SketchPart>();
    }
    if (old == nullptr || !(isPath(*old) || old->is<RectangleForm>()) || part.index >= handleCount(*old)) {
        return {};
    }
    const std::optional<SketchPart> from = node({part.shape, SketchPartKind::Node, part.index});
    const std::optional<SketchPart> to = node(endOf(part));
    if (!from || !to) {
        const std::optional<SketchPart> rest = shortened(part);
        return rest ? std::vector<SketchPart>{*rest} : std::vector<SketchPart>();
    }
    if (from->shape != to->shape || from->index == to->index) {
        return {};
    }
    const Shape &shape = *findShape(next_, from->shape);
    const auto n = static_cast<std::uint32_t>(handleCount(shape));
    const std::vector<Vec2> places = handlesOf(shape), were = handlesOf(*old);
    // Goes from one end to the other, past nodes that were inserted; backwards where the path was reversed.
    for (const bool forward : {true, false}) {
        std::vector<SketchPart> pieces;
        std::uint32_t k = from->index;
        while (k != to->index) {
            if (!isClosed(shape) && (forward ? k + 1 == n : k == 0)) {
                break;
            }
            const std::uint32_t next = forward ? (k + 1) % n : (k + n - 1) % n;
            const bool known = std::find(were.begin(), were.end(), places[next]) != were.end();
            pieces.push_back({shape.id, SketchPartKind::Segment, forward ? k : next});
            k = next;
            if (known) {
                break;
            }
        }
        if (k == to->index) {
            return pieces;
        }
    }
    return {};
}

std::vector<SketchPart> CarriedParts::images(const SketchPart &part) const {
    if (!changed(part.shape)) {
        return {part};
    }
    if (part.kind == SketchPartKind::Node) {
        const std::optional<SketchPart> image = node(part);
        return image ? std::vector<SketchPart>{*image} : std::vector<SketchPart>();
    }
    std::vector<SketchPart> pieces = segment(part);
    if (part.kind == SketchPartKind::Segment || pieces.empty()) {
        return pieces;
    }
    SketchPart inner = pieces.front();
    inner.kind = part.kind;
    if (part.kind == SketchPartKind::Centre) {
        return {inner};
    }
    // The control points of a divided Bézier curve are others; those of a reversed one change places.
    if (pieces.size() > 1) {
        return {};
    }
    const std::optional<SketchPart> from = node({part.shape, SketchPartKind::Node, part.index});
    if (from && from->index != inner.index) {
        inner.kind =
            part.kind == SketchPartKind::StartControl ? SketchPartKind::EndControl : SketchPartKind::StartControl;
    }
    return {inner};
}

SketchPart CarriedParts::image(const SketchPart &part) const {
    const std::vector<SketchPart> all = images(part);
    return all.empty() ? part : all.front();
}

} // namespace forefront
