#include "core/drawing/picking/pick_index.hpp"

#include "core/engine/geometry/path_curve.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "core/engine/spacing/spec/source_box.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>
#include <utility>

namespace forefront {
namespace {

Vec2 nearestOnSegment(Vec2 a, Vec2 b, Vec2 p, double &t) {
    const Vec2 along = b - a;
    const double square = lengthSquared(along);
    t = square > 0.0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0.0;
    return lerp(a, b, t);
}

Vec2 nearestOnCircle(Vec2 centre, Vec2 on, Vec2 p) {
    const Vec2 arm = p - centre;
    const double reach = length(arm);
    return reach > 0.0 ? centre + (distance(centre, on) / reach) * arm : on;
}

bool canPick(const Shape &shape) {
    return !shape.hidden && !shape.locked;
}

} // namespace

PickIndex::PickIndex(std::shared_ptr<const Document> document) : document_(std::move(document)) {
    std::vector<Box2> handleBoxes, lineBoxes, shapeBoxes;
    for (std::uint32_t k = 0; k < document_->shapes.size(); ++k) {
        const Shape &shape = *document_->shapes[k];
        shapeBoxes.push_back(boundsOf(shape));
        if (shape.hidden) {
            continue;
        }
        const std::vector<Vec2> handles = handlesOf(shape);
        for (std::uint32_t part = 0; part < handles.size(); ++part) {
            handles_.push_back({k, part, handles[part], handles[part]});
            handleBoxes.push_back(boxOf(handles[part], handles[part]));
        }
        if (shape.is<CircleForm>() || shape.is<PointForm>()) {
            lines_.push_back({k, 0, shape.nodes.front(), shape.nodes.back()});
            lineBoxes.push_back(shapeBoxes.back());
            continue;
        }
        const Outline outline = outlineOf(shape);
        addCentres(k, outline);
        for (std::uint32_t s = 0; s < outline.segmentCount(); ++s) {
            lines_.push_back({k, outline.part(s), outline.from(s), outline.to(s)});
            lineBoxes.push_back(boxOf(outline.from(s), outline.to(s)));
            if (outline.isCurved(s)) {
                lines_.back().curve = static_cast<std::uint32_t>(curves_.size());
                curves_.push_back(outline.curves[s]);
                lineBoxes.back().add(curves_.back().bounds());
            }
        }
    }
    handleTree_ = BoxTree(handleBoxes);
    lineTree_ = BoxTree(lineBoxes);
    shapeTree_ = BoxTree(shapeBoxes);
    std::vector<Box2> centreBoxes;
    for (const Entry &entry : centres_) {
        centreBoxes.push_back(boxOf(entry.a, entry.a));
    }
    centreTree_ = BoxTree(centreBoxes);
}

/// Adds the centres of a rectangle and of the arcs of a path; those of circles, ellipses and slots are handles.
void PickIndex::addCentres(std::uint32_t shape, const Outline &outline) {
    const auto add = [&](std::uint32_t part, Vec2 centre) { centres_.push_back({shape, part, centre, centre}); };
    if (document_->shapes[shape]->is<RectangleForm>()) {
        add(0, boundsOf(*document_->shapes[shape]).centre());
    }
    for (std::uint32_t s = 0; s < outline.segmentCount(); ++s) {
        if (outline.isCurved(s) && outline.curves[s].kind() == CurveKind::Arc &&
            !document_->shapes[shape]->is<EllipseForm>() && !document_->shapes[shape]->is<SlotForm>()) {
            const std::array<double, 8> numbers = outline.curves[s].numbers();
            add(outline.part(s), {numbers[0], numbers[1]});
        }
    }
}

Curve PickIndex::curveOf(const Entry &entry) const {
    if (document_->shapes[entry.shape]->is<CircleForm>()) {
        return Curve::circle(entry.a, entry.b);
    }
    return entry.curve != kNoCurve ? curves_[entry.curve] : Curve::line(entry.a, entry.b);
}

std::vector<Curve> PickIndex::curvesNear(Vec2 p, double tolerance, std::size_t most, const Filter &filter) const {
    std::vector<std::pair<double, std::uint32_t>> near;
    lineTree_.query(boxAround(p, tolerance), [&](std::uint32_t item) {
        const Shape &shape = *document_->shapes[lines_[item].shape];
        const double d = lineDistance(lines_[item], p);
        if (d <= tolerance && !shape.is<PointForm>() && filter.admitsSegment(shape, lines_[item].part)) {
            near.emplace_back(d, item);
        }
    });
    std::sort(near.begin(), near.end());
    near.resize(std::min(near.size(), most));
    std::vector<Curve> curves;
    curves.reserve(near.size());
    for (const auto &[d, item] : near) {
        curves.push_back(curveOf(lines_[item]));
    }
    return curves;
}

namespace {

/// Maximum number of items that a search for near ones looks at; more are a cluster at this zoom.
constexpr std::size_t kMaxSearched = 2000;

/// Sorts hits by their distance and keeps the nearest ones.
template <class Hit>
void keepNearest(std::vector<Hit> &hits, std::size_t most) {
    std::stable_sort(hits.begin(), hits.end(), [](const Hit &a, const Hit &b) { return a.distance < b.distance; });
    hits.resize(std::min(hits.size(), most));
}

} // namespace

std::vector<NodeHit> PickIndex::nodesNear(Vec2 p, double reach, std::size_t most, const Filter &filter) const {
    std::vector<NodeHit> hits;
    std::size_t searched = 0;
    handleTree_.search(boxAround(p, reach), [&](std::uint32_t item) {
        const Entry &entry = handles_[item];
        const Shape &shape = *document_->shapes[entry.shape];
        const double away = distance(entry.a, p);
        if (away <= reach && filter.admitsNode(shape, entry.part)) {
            hits.push_back({{shape.id, entry.part}, entry.a, away});
        }
        return ++searched < kMaxSearched;
    });
    keepNearest(hits, most);
    return hits;
}

std::vector<SegmentHit> PickIndex::linesNear(Vec2 p, double reach, std::size_t most, const Filter &filter) const {
    std::vector<SegmentHit> hits;
    std::size_t searched = 0;
    lineTree_.search(boxAround(p, reach), [&](std::uint32_t item) {
        const Entry &entry = lines_[item];
        const Shape &shape = *document_->shapes[entry.shape];
        const bool straight = entry.curve == kNoCurve && !shape.is<CircleForm>() && !shape.is<PointForm>();
        const double away = straight ? lineDistance(entry, p) : 0.0;
        if (straight && away <= reach && filter.admitsSegment(shape, entry.part)) {
            hits.push_back({{shape.id, entry.part}, entry.a, entry.b, p, 0.0, away, std::nullopt});
        }
        return ++searched < kMaxSearched;
    });
    keepNearest(hits, most);
    return hits;
}

std::vector<PickIndex::CircleHit> PickIndex::circlesNear(Vec2 p, double reach, std::size_t most,
                                                         const Filter &filter) const {
    std::vector<CircleHit> hits;
    std::size_t searched = 0;
    lineTree_.search(boxAround(p, reach), [&](std::uint32_t item) {
        const Entry &entry = lines_[item];
        const Shape &shape = *document_->shapes[entry.shape];
        const std::optional<double> radius = shape.is<CircleForm>()    ? std::optional(distance(entry.a, entry.b))
                                             : entry.curve != kNoCurve ? radiusOf(curves_[entry.curve])
                                                                       : std::nullopt;
        const double away = radius ? lineDistance(entry, p) : 0.0;
        if (radius && away <= reach && filter.admitsSegment(shape, entry.part)) {
            hits.push_back({{shape.id, entry.part}, *radius, away});
        }
        return ++searched < kMaxSearched;
    });
    std::sort(hits.begin(), hits.end(),
              [](const CircleHit &a, const CircleHit &b) { return std::tie(a.away, a.ref) < std::tie(b.away, b.ref); });
    hits.resize(std::min(hits.size(), most));
    return hits;
}

std::optional<Vec2> PickIndex::centre(Vec2 p, double tolerance, const Filter &filter) const {
    std::optional<Vec2> best;
    double limit = tolerance;
    centreTree_.query(boxAround(p, tolerance), [&](std::uint32_t item) {
        const double d = distance(centres_[item].a, p);
        if (d <= limit && filter.admitsSegment(*document_->shapes[centres_[item].shape], centres_[item].part)) {
            limit = d;
            best = centres_[item].a;
        }
    });
    return best;
}

double PickIndex::lineDistance(const Entry &entry, Vec2 p) const {
    if (document_->shapes[entry.shape]->is<CircleForm>()) {
        return std::abs(distance(entry.a, p) - distance(entry.a, entry.b));
    }
    if (entry.curve != kNoCurve) {
        const Curve &curve = curves_[entry.curve];
        return distance(curve.point(curve.nearest(p)), p);
    }
    return distanceToSegment(entry.a, entry.b, p);
}

std::optional<NodeHit> PickIndex::node(Vec2 p, double tolerance, const Filter &filter) const {
    std::uint32_t best = kNoIndex;
    double limit = tolerance;
    handleTree_.query(boxAround(p, tolerance), [&](std::uint32_t item) {
        const double d = distance(handles_[item].a, p);
        const bool nearer = d < limit || (d == limit && (best == kNoIndex || item > best));
        if (nearer && filter.admitsNode(*document_->shapes[handles_[item].shape], handles_[item].part)) {
            best = item;
            limit = d;
        }
    });
    if (best == kNoIndex) {
        return std::nullopt;
    }
    const Entry &entry = handles_[best];
    return NodeHit{{document_->shapes[entry.shape]->id, entry.part}, entry.a, limit};
}

std::optional<SegmentHit> PickIndex::segment(Vec2 p, double tolerance, const Filter &filter) const {
    std::uint32_t best = kNoIndex;
    double limit = tolerance;
    lineTree_.query(boxAround(p, tolerance), [&](std::uint32_t item) {
        const Shape &shape = *document_->shapes[lines_[item].shape];
        const double d = lineDistance(lines_[item], p);
        const bool nearer = d < limit || (d == limit && (best == kNoIndex || item > best));
        if (nearer && !shape.is<PointForm>() && filter.admitsSegment(shape, lines_[item].part)) {
            best = item;
            limit = d;
        }
    });
    if (best == kNoIndex) {
        return std::nullopt;
    }
    const Entry &entry = lines_[best];
    const Shape &shape = *document_->shapes[entry.shape];
    SegmentHit hit{{shape.id, entry.part}, entry.a, entry.b, {}, 0.0, limit, {}};
    if (shape.is<CircleForm>()) {
        hit.at = hit.a = hit.b = nearestOnCircle(entry.a, entry.b, p);
    } else if (entry.curve != kNoCurve) {
        hit.curve = curves_[entry.curve];
        hit.t = hit.curve->nearest(p);
        hit.at = hit.curve->point(hit.t);
    } else {
        hit.at = nearestOnSegment(entry.a, entry.b, p, hit.t);
    }
    return hit;
}

std::vector<SegmentRef> PickIndex::segmentsAt(Vec2 p, double tolerance) const {
    std::vector<SegmentRef> found;
    lineTree_.query(boxAround(p, tolerance), [&](std::uint32_t item) {
        const Shape &shape = *document_->shapes[lines_[item].shape];
        if (!shape.is<PointForm>() && lineDistance(lines_[item], p) <= tolerance) {
            found.push_back({shape.id, lines_[item].part});
        }
    });
    return found;
}

std::uint32_t PickIndex::shape(Vec2 p, double tolerance) const {
    std::uint32_t best = kNoIndex;
    double limit = tolerance;
    lineTree_.query(boxAround(p, tolerance), [&](std::uint32_t item) {
        const double d = lineDistance(lines_[item], p);
        const bool nearer = d < limit || (d == limit && (best == kNoIndex || item > best));
        if (nearer && canPick(*document_->shapes[lines_[item].shape])) {
            best = item;
            limit = d;
        }
    });
    if (best != kNoIndex) {
        return document_->shapes[lines_[best].shape]->id;
    }
    std::uint32_t smallest = kNoIndex;
    double area = std::numeric_limits<double>::infinity();
    shapeTree_.query(boxAround(p, 0.0), [&](std::uint32_t k) {
        const Shape &shape = *document_->shapes[k];
        if (canPick(shape) && contains(shape, p) && areaOf(shape) < area) {
            area = areaOf(shape);
            smallest = shape.id;
        }
    });
    return smallest;
}

std::optional<PickIndex::SourceHit> PickIndex::source(Vec2 p, double tolerance) const {
    std::optional<SourceHit> best;
    double limit = tolerance;
    const auto take = [&](double d, SourceHit hit) {
        if (d <= limit) {
            limit = d;
            best = hit;
        }
    };
    const std::vector<SizeSource> &sources = document_->spacing.sources;
    using Part = SourceHit::Part;
    for (std::uint32_t k = 0; k < sources.size(); ++k) {
        if (sources[k].shape == SourceShape::Box) {
            const SourceBox box(sources[k]);
            constexpr std::array kCorners{Part::A, Part::AfterA, Part::B, Part::AfterB};
            take(distance(p, box.centre()), {k, Part::Whole});
            for (std::size_t corner = 0; corner < kCorners.size(); ++corner) {
                take(distance(p, box.corners()[corner]), {k, kCorners[corner]});
            }
            continue;
        }
        take(distance(p, sources[k].a), {k, Part::A});
        if (sources[k].shape == SourceShape::Line) {
            take(distance(p, sources[k].b), {k, Part::B});
        }
    }
    const bool onEnd = best.has_value();
    // Ends and centres win over lines and rims.
    for (std::uint32_t k = 0; k < sources.size() && !onEnd; ++k) {
        if (sources[k].shape == SourceShape::Line) {
            take(distanceToSegment(sources[k].a, sources[k].b, p), {k, Part::Whole});
        } else if (sources[k].shape == SourceShape::Circle) {
            take(std::abs(distance(p, sources[k].a) - sources[k].radius), {k, Part::Rim});
        } else if (sources[k].shape == SourceShape::Box) {
            const std::array<Vec2, 4> corners = SourceBox(sources[k]).corners();
            for (std::size_t corner = 0; corner < corners.size(); ++corner) {
                take(distanceToSegment(corners[corner], corners[(corner + 1) % 4], p), {k, Part::Whole});
            }
        }
    }
    return best;
}

std::optional<std::uint32_t> PickIndex::marker(Vec2 p, double tolerance) const {
    std::optional<std::uint32_t> best;
    double limit = tolerance;
    for (std::uint32_t k = 0; k < document_->regionMarkers.size(); ++k) {
        const double d = distance(p, document_->regionMarkers[k].at);
        if (d <= limit) {
            limit = d;
            best = k;
        }
    }
    return best;
}

namespace {

/// Returns the points of a source that must be inside what selects it.
std::vector<Vec2> pointsOf(const SizeSource &source) {
    switch (source.shape) {
    case SourceShape::Box: {
        const std::array<Vec2, 4> corners = SourceBox(source).corners();
        return {corners.begin(), corners.end()};
    }
    case SourceShape::Line:
        return {source.a, source.b};
    default:
        return {source.a};
    }
}

} // namespace

Selection PickIndex::inLoop(std::span<const Vec2> loop, bool handles) const {
    constexpr double kFineLoopChords = 1e-3; // of the radius
    Box2 box;
    for (const Vec2 p : loop) {
        box.add(p);
    }
    Selection selection = inBox(box, handles);
    const auto holds = [&](const std::vector<Vec2> &points) {
        return std::ranges::all_of(points, [&](Vec2 p) { return locate(loop, p) == PointPlace::Inside; });
    };
    std::erase_if(selection.shapes, [&](std::uint32_t id) {
        const Shape &shape = *findShape(*document_, id);
        return !holds(chordsOf(shape, outlineOf(shape), kFineLoopChords).nodes);
    });
    std::erase_if(selection.nodes, [&](const NodeRef &node) {
        return locate(loop, handlesOf(*findShape(*document_, node.shape))[node.node]) != PointPlace::Inside;
    });
    std::erase_if(selection.sources,
                  [&](std::uint32_t source) { return !holds(pointsOf(document_->spacing.sources[source])); });
    std::erase_if(selection.markers, [&](std::uint32_t marker) {
        return locate(loop, document_->regionMarkers[marker].at) != PointPlace::Inside;
    });
    return selection;
}

Selection PickIndex::inBox(const Box2 &box, bool handles) const {
    Selection selection;
    if (handles) {
        handleTree_.query(box, [&](std::uint32_t item) {
            const Shape &shape = *document_->shapes[handles_[item].shape];
            if (canPick(shape)) {
                selection.nodes.insert({shape.id, handles_[item].part});
            }
        });
        return selection;
    }
    const auto holds = [&](const Box2 &inner) {
        return !inner.empty() && box.contains(inner.min) && box.contains(inner.max);
    };
    shapeTree_.query(box, [&](std::uint32_t k) {
        if (canPick(*document_->shapes[k]) && holds(boundsOf(*document_->shapes[k]))) {
            selection.shapes.insert(document_->shapes[k]->id);
        }
    });
    for (std::uint32_t k = 0; k < document_->spacing.sources.size(); ++k) {
        const std::vector<Vec2> points = pointsOf(document_->spacing.sources[k]);
        if (std::ranges::all_of(points, [&](Vec2 p) { return box.contains(p); })) {
            selection.sources.insert(k);
        }
    }
    for (std::uint32_t k = 0; k < document_->regionMarkers.size(); ++k) {
        if (box.contains(document_->regionMarkers[k].at)) {
            selection.markers.insert(k);
        }
    }
    return selection;
}

} // namespace forefront
