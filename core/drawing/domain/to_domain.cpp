#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/domain/domain_sources.hpp"
#include "core/drawing/domain/refine_chords.hpp"
#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/domain/node_merger.hpp"

namespace forefront {
namespace {

/// Adds the shapes of a document to a domain; `sources` may be null.
class DocumentDomain {
  public:
    DocumentDomain(const Document &document, DomainSources *sources)
        : document_(document), sources_(sources), counted_(countedParts(document)), merger_(domain_.nodes) {}

    Domain build() {
        for (std::uint32_t number = 0; number < document_.shapes.size(); ++number) {
            const Shape &shape = *document_.shapes[number];
            shape.is<PointForm>() ? addPoint(shape, number) : addOutline(shape, number);
            addNodeSizes(shape);
        }
        domain_.regionMarkers = document_.regionMarkers;
        domain_.boundaryNames = document_.boundaryNames;
        domain_.regionNames = document_.regionNames;
        domain_.curveTolerance = document_.curveTolerance;
        if (flattened_) {
            refineMeetingChords(domain_, sources_);
        }
        return std::move(domain_);
    }

  private:
    std::uint32_t addNode(Vec2 at, const ShapeNode &source) {
        const std::uint32_t id = merger_.add(at);
        if (sources_ != nullptr && sources_->nodes.size() < domain_.nodes.size()) {
            sources_->nodes.push_back(source);
        }
        return id;
    }

    void addPoint(const Shape &shape, std::uint32_t number) {
        for (std::uint32_t k = 0; k < shape.nodes.size(); ++k) {
            const std::uint32_t node = addNode(shape.nodes[k], {number, k});
            if (k == 0 && shape.use == ShapeUse::Constraint) {
                domain_.points.push_back({node, shape.tag});
                if (sources_ != nullptr) {
                    sources_->points.push_back({number, 0});
                }
            }
        }
    }

    void addNodeSizes(const Shape &shape) {
        const std::vector<Vec2> handles = shape.nodeSizes.empty() ? std::vector<Vec2>() : handlesOf(shape);
        for (const auto &[node, part] : shape.nodeSizes) {
            if (node < handles.size()) {
                domain_.nodeSizes.push_back({handles[node], part.size, part.growth, nodeName(shape, node)});
            }
        }
    }

    void addOutline(const Shape &shape, std::uint32_t number) {
        const Outline outline = outlineOf(shape);
        const Chords chords = chordsOf(shape, outline, document_.circleTolerance);
        const std::vector<std::uint32_t> elements = elementsOfParts(document_, shape, counted_);
        std::vector<std::uint32_t> ids;
        ids.reserve(chords.nodes.size());
        for (std::uint32_t k = 0; k < chords.nodes.size(); ++k) {
            const auto end = static_cast<std::uint32_t>(outline.segmentCount());
            ids.push_back(addNode(chords.nodes[k], {number, k < chords.size() ? chords.segments[k] : end}));
        }
        const SegmentRole role = shape.use == ShapeUse::Boundary ? SegmentRole::Boundary : SegmentRole::Constraint;
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
            const std::size_t part = outline.part(segment);
            domain_.segments.push_back({ids[k], ids[k + 1 == ids.size() ? 0 : k + 1], segmentTag(shape, part), role,
                                        stretch, part < elements.size() ? elements[part] : 0});
            if (sources_ != nullptr) {
                sources_->segments.push_back({number, segment});
            }
        }
    }

    const Document &document_;
    DomainSources *sources_;
    std::map<std::int32_t, PartSegments> counted_;
    Domain domain_;
    NodeMerger merger_;
    bool flattened_ = false; ///< some chords were chosen here, regardless of what is near
};

} // namespace

Domain toDomain(const Document &document) {
    return DocumentDomain(document, nullptr).build();
}

Domain toDomain(const Document &document, DomainSources &sources) {
    return DocumentDomain(document, &sources).build();
}

MeshingJob jobOf(const Document &document) {
    return {toDomain(document), spacingOf(document), document.options};
}

} // namespace forefront
