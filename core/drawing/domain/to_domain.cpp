#include "core/drawing/domain/divide_at_joints.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/domain/domain_sources.hpp"
#include "core/drawing/domain/joined_places.hpp"
#include "core/drawing/domain/joint_notes.hpp"
#include "core/drawing/domain/neighbour_sides.hpp"
#include "core/drawing/domain/part_settings.hpp"
#include "core/drawing/domain/refine_chords.hpp"
#include "core/drawing/domain/side_choice.hpp"
#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/same_place.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/node_merger.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Adds the shapes of a document to a domain; `sources` may be null.
class DocumentDomain {
  public:
    DocumentDomain(const Document &document, DomainSources *sources)
        : document_(document), counted_(countedParts(document)),
          sources_(sources != nullptr || !needsSources(document) ? sources : &own_), merger_(domain_.nodes),
          joined_(document), samePlace_(samePlaceDistance(document)) {}

    Domain build() {
        for (std::uint32_t number = 0; number < document_.shapes.size(); ++number) {
            const Shape &shape = *document_.shapes[number];
            if (!shape.construction) {
                shape.is<PointForm>() ? addPoint(shape, number) : addOutline(shape, number);
            }
        }
        for (const MarkedRegion &region : document_.regionMarkers) {
            domain_.regionMarkers.push_back({region.at, region.tag});
        }
        domain_.boundaryNames = document_.boundaryNames;
        domain_.regionNames = document_.regionNames;
        domain_.curveTolerance = document_.curveTolerance;
        divideJoined();
        joinNeighbours();
        if (flattened_) {
            refineMeetingChords(domain_, sources_);
        }
        return std::move(domain_);
    }

    /// Returns the numbers of elements along the segments that were built, see PlacedSizes::elements.
    std::vector<std::uint32_t> elements() const { return listOf<std::uint32_t>(&SegmentSource::elements, 0); }
    /// Returns the biases of the elements along the segments that were built, see PlacedSizes::biases.
    std::vector<ElementBias> biases() const { return listOf<ElementBias>(&SegmentSource::bias, {}); }
    /// Returns the sizes along the segments that were built, see PlacedSizes::segments.
    std::vector<PartSize> sizes() const { return listOf<PartSize>(&SegmentSource::size, SegmentSource{}.size); }

    /// Returns what the user should know of how shapes meet: sides that two want different, errors, and joints.
    const Diagnostics &findings() const { return findings_; }

  private:
    /// Returns true if lines differ in more than their places and tags.
    bool needsSources(const Document &document) const {
        return !counted_.empty() || hasSegmentSizes(document) || !document.layers.empty() ||
               !document.periodic.empty() || !document.cracks.empty() || !document.strips.empty();
    }

    /// Returns one property of each segment; an empty list if no segment has it.
    template <class Value>
    std::vector<Value> listOf(Value SegmentSource::*property, const Value &none) const {
        std::vector<Value> list;
        for (std::size_t s = 0; sources_ != nullptr && s < sources_->segments.size(); ++s) {
            if (const Value &value = sources_->segments[s].*property; !(value == none)) {
                list.resize(sources_->segments.size(), none);
                list[s] = value;
            }
        }
        return list;
    }

    std::uint32_t addNode(Vec2 at, const ShapeNode &source) {
        const std::uint32_t id = merger_.add(at);
        if (sources_ != nullptr && sources_->nodes.size() < domain_.nodes.size()) {
            sources_->nodes.push_back(source);
        }
        return id;
    }

    void addPoint(const Shape &shape, std::uint32_t number) {
        for (std::uint32_t k = 0; k < shape.nodes.size(); ++k) {
            const std::uint32_t node = addNode(joined_.of(shape.nodes[k]), {number, k});
            if (k == 0 && shape.use == ShapeUse::Constraint) {
                domain_.points.push_back({node, shape.tag});
                joints_.push_back({node, number});
                if (sources_ != nullptr) {
                    sources_->points.push_back({number, 0});
                }
            }
        }
    }

    /// Returns where each segment of an outline comes from, and the size and the number of elements along it.
    std::vector<SegmentSource> sourcesOf(const Shape &shape, std::uint32_t number, const Outline &outline) const {
        const std::vector<PartSize> sizes = sizesOfParts(shape);
        const std::vector<std::uint32_t> elements = elementsOfParts(document_, shape, counted_);
        std::vector<SegmentSource> sources;
        for (std::uint32_t segment = 0; segment < outline.segmentCount(); ++segment) {
            SegmentSource source{.shape = number, .node = segment};
            const auto part = static_cast<std::uint32_t>(outline.part(segment));
            if (part < sizes.size() && sizes[part].size > 0.0) {
                source.size = sizes[part];
            }
            source.elements = part < elements.size() ? elements[part] : 0;
            const auto own = shape.segmentSizes.find(part);
            if (source.elements > 0 && own != shape.segmentSizes.end()) {
                source.bias = own->second.bias;
            }
            sources.push_back(source);
        }
        return sources;
    }

    void addOutline(const Shape &shape, std::uint32_t number) {
        Outline outline = outlineOf(shape);
        joined_.apply(outline);
        const Chords chords = chordsOf(shape, outline, document_.circleTolerance);
        const std::vector<SegmentSource> sources =
            sources_ != nullptr ? sourcesOf(shape, number, outline) : std::vector<SegmentSource>();
        std::vector<std::uint32_t> ids;
        ids.reserve(chords.nodes.size());
        for (std::uint32_t k = 0; k < chords.nodes.size(); ++k) {
            const auto end = static_cast<std::uint32_t>(outline.segmentCount());
            ids.push_back(addNode(chords.nodes[k], {number, k < chords.size() ? chords.segments[k] : end}));
        }
        const SegmentRole role = shape.use == ShapeUse::Boundary ? SegmentRole::Boundary : SegmentRole::Constraint;
        const auto first = static_cast<std::uint32_t>(domain_.segments.size());
        if (isClosed(shape)) {
            loops_.push_back({first, first + static_cast<std::uint32_t>(chords.size())});
        }
        for (std::size_t k = 0; k < chords.size(); ++k) {
            const std::uint32_t segment = chords.segments[k];
            const bool given = segment < shape.cuts.size() && !shape.cuts[segment].empty();
            flattened_ = flattened_ || (chords.stretches[k].follows() && !given);
            CurveStretch stretch = chords.stretches[k];
            if (stretch.follows()) {
                if (stretch.t0 == 0.0) {
                    domain_.curves.push_back(outline.curves[segment]);
                }
                stretch.curve = static_cast<std::uint32_t>(domain_.curves.size() - 1);
            }
            if (!stretch.follows() || stretch.t0 == 0.0) {
                joints_.push_back({ids[k], number});
            }
            domain_.segments.push_back({ids[k], ids[k + 1 == ids.size() ? 0 : k + 1],
                                        segmentTag(shape, outline.part(segment)), role, stretch});
            shapes_.push_back(number);
            if (sources_ != nullptr) {
                sources_->segments.push_back(sources[segment]);
            }
        }
        if (!outline.closed && !ids.empty()) {
            joints_.push_back({ids.back(), number});
        }
    }

    /// Divides what the nodes of other shapes lie on, unless a part would then be there twice: as where a line runs so
    /// close to a side that it is on the side up to rounding, and yet is another.
    void divideJoined() {
        if (shapes_.empty() || (shapes_.front() == shapes_.back() && domain_.points.empty())) {
            return; // one shape, which no other one divides
        }
        const std::vector<std::uint32_t> counts = elements();
        const std::vector<ElementBias> ratios = biases();
        std::vector<bool> whole(domain_.segments.size(), false);
        for (int round = 0; round < kMaxDivisions; ++round) {
            DividedSegments parts = divideAtJoints(domain_, joints_, shapes_, {counts, ratios}, whole, samePlace_);
            if (parts.given.empty()) {
                noteJoints(parts, whole);
                return;
            }
            const std::vector<SegmentRun> loops = loopsIn(parts);
            domain_.segments.swap(parts.segments);
            const std::vector<std::uint32_t> twice = drawnTwice(domain_, loops, parts.given, samePlace_);
            if (twice.empty()) {
                noteJoints(parts, whole);
                takeDivision(parts, loops);
                return;
            }
            domain_.segments.swap(parts.segments); // back to what was drawn
            for (const std::uint32_t s : twice) {
                whole[s] = true;
            }
        }
    }

    /// Notes what was joined although it was drawn apart, and what was not. Call before the division is taken.
    void noteJoints(const DividedSegments &parts, const std::vector<bool> &whole) {
        const JointNotes notes(document_, domain_);
        notes.joined(std::max(joined_.farthest(), parts.farthest), findings_);
        for (const NodeBesideCurve &beside : parts.beside) {
            notes.beside(beside, shapes_[beside.segment], findings_);
        }
        for (std::size_t s = 0; s < whole.size(); ++s) {
            if (whole[s]) {
                notes.along(shapes_[s], findings_);
            }
        }
    }

    /// Returns the loops after a division.
    std::vector<SegmentRun> loopsIn(const DividedSegments &parts) const {
        const auto placeOf = [&](std::uint32_t segment) {
            const auto found = std::lower_bound(parts.given.begin(), parts.given.end(), segment);
            return static_cast<std::uint32_t>(found - parts.given.begin());
        };
        std::vector<SegmentRun> loops = loops_;
        for (SegmentRun &loop : loops) {
            loop = {placeOf(loop.first), placeOf(loop.end)};
        }
        return loops;
    }

    void takeDivision(const DividedSegments &parts, const std::vector<SegmentRun> &loops) {
        loops_ = loops;
        if (sources_ != nullptr) {
            const std::vector<SegmentSource> old = std::exchange(sources_->segments, {});
            for (std::size_t s = 0; s < parts.given.size(); ++s) {
                SegmentSource source = old[parts.given[s]];
                if (parts.elements[s] > 0) {
                    source.elements = parts.elements[s];
                    source.bias = parts.biases[s];
                }
                sources_->segments.push_back(source);
            }
        }
    }

    /// Makes what two closed shapes have drawn, each for itself, one line.
    void joinNeighbours() {
        std::vector<bool> dropped;
        std::vector<std::uint32_t> inner;            // nodes of curves that are dropped
        std::map<std::uint32_t, SegmentRun> holders; // what took the place of a kept line, by its first segment
        for (NeighbourSide &side : neighbourSides(domain_, loops_, samePlace_)) {
            const auto holder = holders.find(side.kept.first);
            side.kept = holder != holders.end() ? holder->second : side.kept;
            const SideChoice choice = sources_ != nullptr ? chooseSide(document_, domain_, *sources_, side)
                                                          : SideChoice{.tag = domain_.segments[side.kept.first].tag};
            if (choice.conflict) {
                findings_.push_back(*choice.conflict);
                continue;
            }
            const SegmentRole role = side.within ? SegmentRole::Constraint : domain_.segments[side.kept.first].role;
            if (choice.dropped) {
                holders[holder != holders.end() ? holder->first : side.kept.first] = side.dropped;
                std::swap(side.kept, side.dropped);
            }
            dropped.resize(domain_.segments.size(), false);
            std::fill(dropped.begin() + side.dropped.first, dropped.begin() + side.dropped.end, true);
            for (std::uint32_t s = side.dropped.first + 1; s < side.dropped.end; ++s) {
                inner.push_back(domain_.segments[s].a);
            }
            for (std::uint32_t s = side.kept.first; s < side.kept.end; ++s) {
                domain_.segments[s].role = role;
                domain_.segments[s].tag = choice.tag;
            }
        }
        if (!dropped.empty()) {
            eraseMarked(dropped, domain_.segments);
            if (sources_ != nullptr) {
                eraseMarked(dropped, sources_->segments);
            }
        }
        if (!inner.empty()) {
            removeUnused(inner);
        }
    }

    /// Removes the items of a list that are marked; an empty list has none.
    template <class Item>
    static void eraseMarked(const std::vector<bool> &marked, std::vector<Item> &list) {
        std::erase_if(list, [&](const Item &item) { return marked[static_cast<std::size_t>(&item - list.data())]; });
    }

    /// Removes those of some nodes that nothing refers to.
    void removeUnused(const std::vector<std::uint32_t> &nodes) {
        std::vector<bool> unused(domain_.nodes.size(), false);
        for (const std::uint32_t node : nodes) {
            unused[node] = true;
        }
        for (const DomainSegment &segment : domain_.segments) {
            unused[segment.a] = unused[segment.b] = false;
        }
        for (const ConstraintPoint &point : domain_.points) {
            unused[point.node] = false;
        }
        std::vector<std::uint32_t> number(domain_.nodes.size());
        std::uint32_t next = 0;
        for (std::size_t n = 0; n < number.size(); ++n) {
            number[n] = next;
            next += unused[n] ? 0 : 1;
        }
        for (DomainSegment &segment : domain_.segments) {
            segment.a = number[segment.a];
            segment.b = number[segment.b];
        }
        for (ConstraintPoint &point : domain_.points) {
            point.node = number[point.node];
        }
        eraseMarked(unused, domain_.nodes);
        if (sources_ != nullptr) {
            eraseMarked(unused, sources_->nodes);
        }
    }

    static constexpr int kMaxDivisions = 8; ///< attempts

    const Document &document_;
    std::map<std::int32_t, PartSegments> counted_;
    DomainSources own_;
    DomainSources *sources_; ///< null: nobody needs them
    Domain domain_;
    NodeMerger merger_;
    JoinedPlaces joined_;
    double samePlace_; ///< see samePlaceDistance()
    Diagnostics findings_;
    std::vector<SegmentRun> loops_;
    std::vector<JointNode> joints_;
    std::vector<std::uint32_t> shapes_; ///< per segment, as drawn
    bool flattened_ = false;            ///< some chords were chosen here, regardless of what is near
};

/// Returns the sizes of the nodes and regions of a document.
PlacedSizes placedSizes(const Document &document) {
    PlacedSizes placed;
    for (const auto &shape : document.shapes) {
        const bool sized = !shape->nodeSizes.empty() && !shape->construction;
        const std::vector<Vec2> handles = sized ? handlesOf(*shape) : std::vector<Vec2>();
        for (const auto &[node, part] : shape->nodeSizes) {
            if (node < handles.size()) {
                placed.nodes.push_back({handles[node], part.size, part.growth, nodeName(*shape, node)});
            }
        }
    }
    for (const MarkedRegion &region : document.regionMarkers) {
        if (region.maxArea != 0.0 || region.size != 0.0) {
            placed.regions.push_back(region.sizes());
        }
    }
    return placed;
}

} // namespace

Domain toDomain(const Document &document) {
    return DocumentDomain(document, nullptr).build();
}

Domain toDomain(const Document &document, DomainSources &sources) {
    return DocumentDomain(document, &sources).build();
}

SpacingSpec spacingOf(const Document &document) {
    if (!document.elementCounts.empty() || hasSegmentSizes(document)) {
        return jobOf(document).spacing;
    }
    SpacingSpec spacing = rulesOf(document);
    spacing.placed = placedSizes(document);
    return spacing;
}

MeshingJob jobOf(const Document &document) {
    DocumentDomain made(document, nullptr);
    MeshingJob job{made.build(), rulesOf(document), document.options};
    job.spacing.placed = placedSizes(document);
    job.spacing.placed.elements = made.elements();
    job.spacing.placed.biases = made.biases();
    job.spacing.placed.segments = made.sizes();
    job.findings = made.findings();
    addPartSettings(document, job);
    std::stable_partition(job.findings.begin(), job.findings.end(),
                          [](const Diagnostic &finding) { return finding.severity == Severity::Error; });
    return job;
}

} // namespace forefront
