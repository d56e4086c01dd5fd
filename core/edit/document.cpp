#include "core/edit/document.hpp"

#include "core/base/ids.hpp"
#include "core/edit/domain_sources.hpp"
#include "core/edit/shape_geometry.hpp"

#include <bit>
#include <unordered_map>

namespace forefront {
namespace {

/// Exact coordinates as a key; 0.0 and -0.0 are equal.
struct PlaceHash {
    std::size_t operator()(Vec2 p) const {
        const auto x = std::bit_cast<std::uint64_t>(p.x + 0.0), y = std::bit_cast<std::uint64_t>(p.y + 0.0);
        std::uint64_t h = x * 0x9e3779b97f4a7c15ULL ^ std::rotl(y * 0xc2b2ae3d27d4eb4fULL, 31);
        h ^= h >> 29;
        return static_cast<std::size_t>(h * 0x165667b19e3779f9ULL);
    }
};

/// Gives coinciding nodes the same index. Coordinates that are not finite never coincide; validation reports each.
class NodeMerger {
  public:
    explicit NodeMerger(std::vector<Vec2> &nodes) : nodes_(nodes) {}

    std::uint32_t add(Vec2 p) {
        const auto next = static_cast<std::uint32_t>(nodes_.size());
        if (isFinite(p)) {
            const auto [place, fresh] = places_.emplace(p, next);
            if (!fresh) {
                return place->second;
            }
        }
        nodes_.push_back(p);
        return next;
    }

  private:
    std::vector<Vec2> &nodes_;
    std::unordered_map<Vec2, std::uint32_t, PlaceHash> places_;
};

/// Adds the segments or the point of shape `number`; `sources` may be null.
void addShape(const Document &document, std::uint32_t number, NodeMerger &merger, Domain &domain,
              DomainSources *sources) {
    const Shape &shape = *document.shapes[number];
    const Outline outline = outlineOf(shape, document.circleTolerance);
    std::vector<std::uint32_t> ids;
    ids.reserve(outline.nodes.size());
    for (std::uint32_t k = 0; k < outline.nodes.size(); ++k) {
        ids.push_back(merger.add(outline.nodes[k]));
        if (sources != nullptr && sources->nodes.size() < domain.nodes.size()) {
            sources->nodes.push_back({number, k});
        }
    }
    if (shape.kind == ShapeKind::Point) {
        if (!ids.empty() && shape.use == ShapeUse::Constraint) {
            domain.points.push_back({ids.front(), shape.tag});
            if (sources != nullptr) {
                sources->points.push_back({number, 0});
            }
        }
        return;
    }
    const SegmentRole role = shape.use == ShapeUse::Boundary ? SegmentRole::Boundary : SegmentRole::Constraint;
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        domain.segments.push_back({ids[k], ids[k + 1 == ids.size() ? 0 : k + 1], segmentTag(shape, k), role});
        if (sources != nullptr) {
            sources->segments.push_back({number, static_cast<std::uint32_t>(k)});
        }
    }
}

Domain domainOf(const Document &document, DomainSources *sources) {
    Domain domain;
    NodeMerger merger(domain.nodes);
    for (std::uint32_t number = 0; number < document.shapes.size(); ++number) {
        addShape(document, number, merger, domain, sources);
    }
    domain.regionMarkers = document.regionMarkers;
    domain.boundaryNames = document.boundaryNames;
    domain.regionNames = document.regionNames;
    return domain;
}

} // namespace

Domain toDomain(const Document &document) {
    return domainOf(document, nullptr);
}

Domain toDomain(const Document &document, DomainSources &sources) {
    return domainOf(document, &sources);
}

} // namespace forefront
