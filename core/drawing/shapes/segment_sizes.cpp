#include "core/drawing/shapes/segment_sizes.hpp"

#include "core/drawing/shapes/part_lengths.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/domain/element_places.hpp"
#include "core/engine/domain/element_shares.hpp"
#include "core/engine/spacing/spec/spec_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace forefront {
namespace {

using SizeMap = std::map<std::uint32_t, SegmentSize>;

const SegmentRef &refOf(const SegmentRef &segment) {
    return segment;
}

const SegmentRef &refOf(const std::pair<const SegmentRef, SegmentSize> &sized) {
    return sized.first;
}

/// Calls change(sizes, segment) for each element of a set or map of segments, with the sizes of its shape.
template <class Segments, class Change>
Result<Document> changeEachSegment(const Document &document, const Segments &segments, const Change &change) {
    std::vector<Shape> shapes;
    for (const auto &each : segments) {
        const SegmentRef &segment = refOf(each);
        if (shapes.empty() || shapes.back().id != segment.shape) {
            const Shape *const shape = findShape(document, segment.shape);
            if (shape == nullptr) {
                return error("no-such-shape", "shape not found");
            }
            shapes.push_back(*shape);
        }
        if (segment.segment >= taggedSegments(shapes.back())) {
            return error("no-such-segment", "segment not found");
        }
        change(shapes.back().segmentSizes, each);
    }
    return replaceShapes(document, std::move(shapes));
}

/// Returns the number of elements of a part of a segment.
std::uint32_t share(std::uint32_t elements, double part, double whole) {
    const double count = part < whole ? std::max(1.0, std::round(elements * (part / whole))) : elements;
    return static_cast<std::uint32_t>(count);
}

/// Leaves a size with a number of elements those of a part of its segment, between two fractions of the length.
void takeShare(SegmentSize &size, double from, double to) {
    constexpr double kRounding = 1e-9;
    if (size.elements > 0 && to - from < 1.0 - kRounding) {
        const ElementShare share = shareOfPart(size.elements, size.bias, std::max(from, 0.0), std::min(to, 1.0));
        size.elements = share.elements;
        size.bias = share.bias;
    }
}

} // namespace

const SegmentSize *segmentSize(const Document &document, SegmentRef segment) {
    const Shape *const shape = findShape(document, segment.shape);
    if (shape == nullptr) {
        return nullptr;
    }
    const auto found = shape->segmentSizes.find(segment.segment);
    return found != shape->segmentSizes.end() ? &found->second : nullptr;
}

bool hasSegmentSizes(const Document &document) {
    return std::any_of(document.shapes.begin(), document.shapes.end(),
                       [](const auto &shape) { return !shape->segmentSizes.empty(); });
}

Result<Document> setSegmentSize(const Document &document, const std::set<SegmentRef> &segments,
                                const std::optional<SegmentSize> &size) {
    return changeEachSegment(document, segments, [&](SizeMap &sizes, const SegmentRef &segment) {
        if (size) {
            sizes[segment.segment] = *size;
        } else {
            sizes.erase(segment.segment);
        }
    });
}

Result<Document> setSegmentSizes(const Document &document, const std::map<SegmentRef, SegmentSize> &sizes) {
    return changeEachSegment(document, sizes, [](SizeMap &sizesOfShape, const auto &sized) {
        sizesOfShape[sized.first.segment] = sized.second;
    });
}

namespace {

/// Changes the bias of segments with a number of elements by a function of the present one.
template <class Change>
Result<Document> changeBiases(const Document &document, const std::set<SegmentRef> &segments, const Change &change) {
    for (const SegmentRef &segment : segments) {
        const SegmentSize *const own = segmentSize(document, segment);
        if (own == nullptr || own->elements == 0) {
            return error("not-possible", "only elements that are counted can have a bias",
                         "set the number of elements of the segment first");
        }
    }
    return changeEachSegment(document, segments, [&](SizeMap &sizes, const SegmentRef &segment) {
        ElementBias &bias = sizes[segment.segment].bias;
        bias = change(bias);
    });
}

} // namespace

Result<Document> setElementBias(const Document &document, const std::set<SegmentRef> &segments,
                                const ElementBias &bias) {
    if (!bias.isValid()) {
        return Diagnostics{biasFault(bias, "a segment", "bad-number")};
    }
    return changeBiases(document, segments, [&](const ElementBias &) { return bias; });
}

Result<Document> flipElementBias(const Document &document, const std::set<SegmentRef> &segments) {
    return changeBiases(document, segments, [](const ElementBias &old) {
        return ElementBias{1.0 / old.ratio, old.bothEnds};
    });
}

Result<Document> changeSegmentSizes(const Document &document, const std::set<SegmentRef> &segments,
                                    const SegmentSizeChange &change) {
    return changeEachSegment(document, segments, [&](SizeMap &sizes, const SegmentRef &segment) {
        if (change.size) {
            SegmentSize &changed = sizes[segment.segment];
            changed.size = *change.size;
            changed.elements = 0;
            changed.bias = {};
        }
        if (const auto found = sizes.find(segment.segment); change.growth && found != sizes.end()) {
            found->second.growth = *change.growth;
        }
    });
}

SizeMap sizesOfOutline(const Shape &shape) {
    SizeMap sizes;
    if (shape.segmentSizes.empty()) {
        return sizes;
    }
    const Outline outline = outlineOf(shape);
    const std::vector<PartLength> parts = partLengths(shape);
    std::map<std::size_t, double> ends; // by part: length of its segments so far
    for (std::uint32_t k = 0; k < outline.segmentCount(); ++k) {
        const auto found = shape.segmentSizes.find(outline.part(k));
        if (found != shape.segmentSizes.end() && outline.part(k) < parts.size()) {
            SegmentSize &size = sizes.emplace(k, found->second).first->second;
            if (size.elements > 0) {
                const double whole = parts[outline.part(k)].length;
                double &end = ends[outline.part(k)];
                const double start = std::exchange(end, end + outline.curve(k).length());
                takeShare(size, start / whole, end / whole);
            }
        }
    }
    return sizes;
}

namespace {

/// A segment that had a size.
struct SizedPlace {
    std::vector<Curve> curves;
    double length = 0.0;
    SegmentSize size;

    double distanceTo(Vec2 p) const {
        double least = INFINITY;
        for (const Curve &curve : curves) {
            least = std::min(least, distance(curve.point(curve.nearest(p)), p));
        }
        return least;
    }
};

/// Finds the sizes of segments by their places.
class SizedPlaces {
  public:
    void add(const Shape &shape) {
        if (shape.segmentSizes.empty()) {
            return;
        }
        const Outline outline = outlineOf(shape);
        const std::vector<PartLength> lengths = partLengths(shape);
        for (const auto &[part, size] : shape.segmentSizes) {
            SizedPlace place;
            place.size = size;
            place.length = part < lengths.size() ? lengths[part].length : 0.0;
            for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
                if (outline.part(k) == part) {
                    place.curves.push_back(outline.curve(k));
                }
            }
            places_.push_back(std::move(place));
        }
    }
    bool empty() const { return places_.empty(); }

    /// Returns the segments that a curve runs along; none if a part of it runs along none.
    std::vector<std::size_t> along(const Curve &curve) const {
        std::vector<std::size_t> owners;
        for (const double t : {0.1, 0.3, 0.5, 0.7, 0.9}) {
            const std::size_t owner = at(curve.point(t));
            if (owner == places_.size()) {
                return {};
            }
            if (std::find(owners.begin(), owners.end(), owner) == owners.end()) {
                owners.push_back(owner);
            }
        }
        return owners;
    }
    const SizedPlace &operator[](std::size_t owner) const { return places_[owner]; }
    std::size_t size() const { return places_.size(); }

  private:
    /// Returns the segment that a place is on, or size().
    std::size_t at(Vec2 p) const {
        constexpr double kSamePlace = 1e-3; // of its length: a repair moves nodes a little
        std::size_t found = places_.size();
        double nearest = INFINITY;
        for (std::size_t k = 0; k < places_.size(); ++k) {
            const double gap = places_[k].distanceTo(p);
            if (gap <= kSamePlace * places_[k].length && gap < nearest) {
                nearest = gap;
                found = k;
            }
        }
        return found;
    }

    std::vector<SizedPlace> places_;
};

/// A segment of a changed shape, and the segments that had its place.
struct Heir {
    std::size_t shape = 0; ///< index into Document::shapes
    std::uint32_t part = 0;
    double length = 0.0;
    std::vector<std::size_t> from;
    Curve curve;
};

/// Adds the segments of a shape that take sizes.
void addHeirs(const Shape &shape, std::size_t index, const SizedPlaces &places, std::vector<Heir> &heirs) {
    const Outline outline = outlineOf(shape);
    std::set<std::uint32_t> seen; // of a part of several segments, the first one counts
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        std::vector<std::size_t> from = places.along(outline.curve(k));
        if (!from.empty() && seen.insert(outline.part(k)).second) {
            heirs.push_back({index, outline.part(k), outline.curve(k).length(), std::move(from), outline.curve(k)});
        }
    }
}

/// Gives a segment that takes the place of a single one, or of a part of it, the elements there.
void inheritElements(const Heir &heir, const Curve &old, bool divided, SegmentSize &size) {
    if (divided) {
        const double whole = old.length(), half = 0.5 * heir.length / whole;
        const double middle = old.nearest(heir.curve.point(parameterAtLength(heir.curve, 0.5)));
        const double at = old.length(0.0, middle) / whole;
        takeShare(size, at - half, at + half);
    }
    if (old.nearest(heir.curve.point(0.25)) > old.nearest(heir.curve.point(0.75))) {
        size.bias = size.bias.reversed();
    }
}

/// Returns the size of a segment that takes the place of others; none if these have nothing in common. `divided`: other
/// segments take parts of the same one, and share its number of elements.
std::optional<SegmentSize> inherited(const Heir &heir, const SizedPlaces &places, bool divided) {
    SegmentSize size = places[heir.from.front()].size;
    const bool counted = size.elements > 0;
    double length = 0.0;
    std::uint32_t elements = 0;
    for (const std::size_t owner : heir.from) {
        const SizedPlace &place = places[owner];
        if ((place.size.elements > 0) != counted) {
            return std::nullopt;
        }
        length += place.length;
        elements += place.size.elements;
        size.size = std::min(size.size, place.size.size);
    }
    const SizedPlace &first = places[heir.from.front()];
    if (counted && heir.from.size() == 1 && first.curves.size() == 1) {
        inheritElements(heir, first.curves.front(), divided, size);
        return size;
    }
    size.elements = !counted ? 0 : divided ? share(elements, heir.length, length) : elements;
    size.bias = {};
    return size;
}

bool sameOutline(const Shape &a, const Shape &b) {
    return a.nodes == b.nodes && a.form == b.form;
}

/// Returns true if the sizes of a changed shape are at the right segments.
bool keepsNumbers(const Shape &before, const Shape &now) {
    if (before.is<RectangleForm>() && now.is<RectangleForm>()) {
        return true; // its sides keep their numbers when the corners are rounded
    }
    return now.segmentSizes == before.segmentSizes ? taggedSegments(now) == taggedSegments(before)
                                                   : !now.segmentSizes.empty() || sameOutline(now, before);
}

/// Returns true if the segments of a shape take the sizes at their places.
bool inherits(const Document &before, const std::shared_ptr<const Shape> &shape) {
    const Shape *const old = findShape(before, shape->id);
    return old != shape.get() && !shape->is<PointForm>() &&
           (old != nullptr ? !keepsNumbers(*old, *shape) : shape->segmentSizes.empty());
}

} // namespace

void carrySegmentSizes(const Document &before, Document &next) {
    if (before.shapes == next.shapes || !hasSegmentSizes(before)) {
        return;
    }
    SizedPlaces places;
    for (const auto &shape : before.shapes) {
        if (findShape(next, shape->id) != shape.get()) {
            places.add(*shape);
        }
    }
    std::vector<Heir> heirs;
    for (std::size_t k = 0; k < next.shapes.size() && !places.empty(); ++k) {
        if (inherits(before, next.shapes[k])) {
            Shape shape = *next.shapes[k];
            shape.segmentSizes.clear();
            addHeirs(shape, k, places, heirs);
            next.shapes[k] = std::make_shared<const Shape>(std::move(shape));
        }
    }
    std::vector<std::uint32_t> takers(places.size(), 0);
    for (const Heir &heir : heirs) {
        for (const std::size_t owner : heir.from) {
            ++takers[owner];
        }
    }
    for (const Heir &heir : heirs) {
        const bool divided = std::any_of(heir.from.begin(), heir.from.end(), [&](auto k) { return takers[k] > 1; });
        if (const auto size = inherited(heir, places, divided)) {
            Shape shape = *next.shapes[heir.shape];
            shape.segmentSizes.emplace(heir.part, *size);
            next.shapes[heir.shape] = std::make_shared<const Shape>(std::move(shape));
        }
    }
}

Diagnostics checkSegmentSizes(const Shape &shape) {
    for (const auto &[segment, size] : shape.segmentSizes) {
        const double length = size.elements > 0 ? 1.0 : size.size;
        if (auto fault = partSizeFault({length, size.growth}, segmentName(shape, segment), "bad-size")) {
            return {*std::move(fault)};
        }
        if (!size.bias.isValid()) {
            return Diagnostics{biasFault(size.bias, segmentName(shape, segment), "bad-number")};
        }
        if (size.elements > kMaxElementCount) {
            return error("bad-number", "expected 1 to " + std::to_string(kMaxElementCount) + " elements, got " +
                                           std::to_string(size.elements));
        }
    }
    return {};
}

std::string segmentName(const Shape &shape, std::uint32_t segment) {
    return taggedSegments(shape) == 1 ? displayName(shape)
                                      : "segment " + std::to_string(segment + 1) + " of " + displayName(shape);
}

} // namespace forefront
