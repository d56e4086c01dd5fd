#include "core/engine/mesh/mesh_domain.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/paced_progress.hpp"
#include "core/engine/domain/unused_tag.hpp"
#include "core/engine/mesh/placed_cell.hpp"
#include "core/engine/mesh/topology.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace forefront {

namespace {

class MeshOutline {
  public:
    MeshOutline(const MeshView &mesh, const Progress &progress)
        : mesh_(mesh), sides_(mesh), numbers_(mesh.nodes.size(), kNoIndex), tagged_(mesh.nodes.size(), false),
          progress_(progress, "finding the outline", 2 * mesh.elementCount()) {}

    Result<Domain> run() {
        collectTags();
        chooseTagsOfUnnamed();
        domain_.curves.assign(mesh_.curves.begin(), mesh_.curves.end());
        if (mesh_.elementCount() != 0 && !elementEdges()) {
            return cancelled("finding the outline");
        }
        for (std::size_t k = 0; k < tags_.size(); ++k) {
            if (!used_[k]) {
                const NodeId a{tags_[k].a}, b{tags_[k].b};
                addSegment(a, b, tags_[k].tag,
                           mesh_.elementCount() == 0 ? SegmentRole::Boundary : SegmentRole::Constraint,
                           stretchOf(tags_[k], a, b, tags_[k].middle));
            }
        }
        for (const TaggedNode &point : mesh_.points) {
            domain_.points.push_back({number(point.node), point.tag});
        }
        domain_.boundaryNames = mesh_.boundaryNames;
        domain_.regionNames = mesh_.regionNames;
        return std::move(domain_);
    }
    /// Returns the edges that run() gave a tag.
    std::vector<TaggedEdge> takeUntagged() { return std::move(untagged_); }

  private:
    struct Tagged {
        std::uint32_t low, high, a, b;
        std::int32_t tag;
        CurveStretch stretch; ///< from a to b
        NodeId middle;
        auto key() const { return std::tuple(low, high); }
    };

    void collectTags() {
        tags_.reserve(mesh_.edges.size());
        for (std::size_t k = 0; k < mesh_.edges.size(); ++k) {
            const auto a = static_cast<std::uint32_t>(mesh_.edges[k].a);
            const auto b = static_cast<std::uint32_t>(mesh_.edges[k].b);
            const CurveStretch stretch = k < mesh_.edgeStretches.size() ? mesh_.edgeStretches[k] : CurveStretch();
            tags_.push_back({std::min(a, b), std::max(a, b), a, b, mesh_.edges[k].tag, stretch, mesh_.edges[k].middle});
            tagged_[a] = tagged_[b] = true;
        }
        std::stable_sort(tags_.begin(), tags_.end(),
                         [](const Tagged &a, const Tagged &b) { return a.key() < b.key(); });
        tags_.erase(std::unique(tags_.begin(), tags_.end(),
                                [](const Tagged &a, const Tagged &b) { return a.key() == b.key(); }),
                    tags_.end());
        used_.assign(tags_.size(), false);
    }

    /// Parts without a tag must not get the tag, and with it the name, of another part.
    void chooseTagsOfUnnamed() {
        std::set<std::int32_t> taken;
        for (const Tagged &tag : tags_) {
            taken.insert(tag.tag);
        }
        for (const TaggedNode &point : mesh_.points) {
            taken.insert(point.tag);
        }
        outerTag_ = unusedTag(taken, mesh_.boundaryNames, TagKind::Boundary);
        taken.insert(outerTag_);
        interfaceTag_ = unusedTag(taken, mesh_.boundaryNames, TagKind::Boundary);
    }

    /// Returns the index of the tag of an edge, or tags_.size().
    std::size_t findTag(NodeId a, NodeId b) const {
        if (!tagged_[index(a)] || !tagged_[index(b)]) {
            return tags_.size(); // most edges; a search for each would take longer than the rest
        }
        const std::tuple key(static_cast<std::uint32_t>(std::min(a, b)), static_cast<std::uint32_t>(std::max(a, b)));
        const auto place = std::lower_bound(tags_.begin(), tags_.end(), key,
                                            [](const Tagged &tag, const auto &sought) { return tag.key() < sought; });
        return place != tags_.end() && place->key() == key ? static_cast<std::size_t>(place - tags_.begin())
                                                           : tags_.size();
    }

    /// Returns false once cancelled.
    bool elementEdges() {
        opposite_ = oppositeHalfEdges(EdgeTable(mesh_));
        divides_.assign(opposite_.size(), false);
        for (std::size_t e = 0; e < mesh_.elementCount(); ++e) {
            if (!progress_.next()) {
                return false;
            }
            const HalfEdge begin = sides_.of(e, 0), end = begin + sides_.sidesOf(e);
            for (HalfEdge h = begin; h < end; ++h) {
                elementEdge(e, h);
            }
        }
        const auto isNamed = [](const MeshView::Block &block) {
            return std::any_of(block.regions.begin(), block.regions.end(), [](std::int32_t tag) { return tag != 1; });
        };
        const bool named =
            !mesh_.regionNames.empty() || std::any_of(mesh_.blocks().begin(), mesh_.blocks().end(), isNamed);
        return !named || regionMarkers();
    }

    void elementEdge(std::size_t e, HalfEdge h) {
        const bool outer = opposite_[h] == kNoHalfEdge;
        const NodeId a = sides_.startOf(h), b = sides_.endOf(h);
        const std::size_t found = findTag(a, b);
        const bool tagged = found < tags_.size();
        if (!outer && !tagged && mesh_.region(e) == mesh_.region(sides_.elementOf(opposite_[h]))) {
            return;
        }
        divides_[h] = true;
        if (tagged && used_[found]) {
            return;
        }
        if (tagged) {
            used_[found] = true;
        } else if (!outer && opposite_[h] < h) {
            return;
        }
        const std::int32_t tag = tagged ? tags_[found].tag : outer ? outerTag_ : interfaceTag_;
        if (!tagged) {
            untagged_.push_back({a, b, tag, sides_.middleOf(h)});
        }
        addSegment(a, b, tag, outer ? SegmentRole::Boundary : SegmentRole::Constraint,
                   tagged ? stretchOf(tags_[found], a, b, sides_.middleOf(h)) : parabola(a, b, sides_.middleOf(h)));
    }

    /// Returns the stretch of a tagged edge from a to b: the one that the mesh knows, else that through its middle.
    CurveStretch stretchOf(const Tagged &tagged, NodeId a, NodeId b, NodeId middle) {
        if (!tagged.stretch.follows()) {
            return parabola(a, b, middle);
        }
        return tagged.a == static_cast<std::uint32_t>(a) ? tagged.stretch : tagged.stretch.reversed();
    }

    /// Adds the parabola through the middle node of an edge, unless it is straight.
    CurveStretch parabola(NodeId a, NodeId b, NodeId middle) {
        if (middle == kNoNode) {
            return {};
        }
        const Vec2 from = place(a), to = place(b), through = place(middle);
        constexpr double kStraight = 1e-6; // of the chord: more than what files with few digits round
        if (std::abs(cross(to - from, through - from)) <= kStraight * lengthSquared(to - from)) {
            return {};
        }
        domain_.curves.push_back(Curve::quadratic(from, 2.0 * through - 0.5 * (from + to), to));
        return {static_cast<std::uint32_t>(domain_.curves.size() - 1), 0.0, 1.0};
    }

    /// Places a marker in every face, in its largest element. Returns false once cancelled.
    bool regionMarkers() {
        std::vector<bool> seen(mesh_.elementCount(), false);
        std::vector<std::size_t> stack;
        for (std::size_t start = 0; start < seen.size(); ++start) {
            if (seen[start]) {
                continue;
            }
            std::size_t largest = start;
            seen[start] = true;
            stack.push_back(start);
            while (!stack.empty()) {
                if (!progress_.next()) {
                    return false;
                }
                const std::size_t e = stack.back();
                stack.pop_back();
                largest = area(e) > area(largest) ? e : largest;
                const HalfEdge begin = sides_.of(e, 0), end = begin + sides_.sidesOf(e);
                for (HalfEdge h = begin; h < end; ++h) {
                    if (divides_[h] || opposite_[h] == kNoHalfEdge) {
                        continue;
                    }
                    const std::size_t next = sides_.elementOf(opposite_[h]);
                    if (!seen[next]) {
                        seen[next] = true;
                        stack.push_back(next);
                    }
                }
            }
            domain_.regionMarkers.push_back({PlacedCell(mesh_, largest).centre(), mesh_.region(largest)});
        }
        return true;
    }

    Vec2 place(NodeId node) const { return mesh_.nodes[index(node)]; }
    double area(std::size_t e) const { return std::abs(twiceArea(PlacedCell(mesh_, e))); }

    std::uint32_t number(NodeId node) {
        std::uint32_t &number = numbers_[index(node)];
        if (number == kNoIndex) {
            number = static_cast<std::uint32_t>(domain_.nodes.size());
            domain_.nodes.push_back(place(node));
        }
        return number;
    }
    void addSegment(NodeId a, NodeId b, std::int32_t tag, SegmentRole role, const CurveStretch &stretch) {
        const std::uint32_t from = number(a), to = number(b);
        domain_.segments.push_back({from, to, tag, role, stretch});
    }

    const MeshView &mesh_;
    HalfEdges sides_;
    std::vector<std::uint32_t> numbers_; ///< per node of the mesh: its index in the domain
    std::vector<bool> tagged_;           ///< per node of the mesh: it is on an edge with a tag
    std::vector<Tagged> tags_;
    std::vector<bool> used_;
    std::vector<TaggedEdge> untagged_;
    std::int32_t outerTag_ = 1;     ///< for outer edges without a tag
    std::int32_t interfaceTag_ = 2; ///< for interfaces without a tag
    std::vector<HalfEdge> opposite_;
    std::vector<bool> divides_; ///< per half-edge: it is on a segment
    PacedProgress progress_;
    Domain domain_;
};

/// Returns the periodic parts of a mesh that can be so in its domain: they bound it, and no crack touches them.
std::vector<PeriodicSpec> periodicParts(const MeshView &mesh, const MeshDomain &made) {
    if (mesh.periodic.empty()) {
        return {};
    }
    std::set<std::int32_t> outer, inner;
    std::set<std::uint32_t> cracked; // nodes
    for (const DomainSegment &segment : made.domain.segments) {
        (segment.role == SegmentRole::Boundary ? outer : inner).insert(segment.tag);
        if (std::binary_search(made.cracks.begin(), made.cracks.end(), segment.tag)) {
            cracked.insert({segment.a, segment.b});
        }
    }
    for (const DomainSegment &segment : made.domain.segments) {
        if (cracked.contains(segment.a) || cracked.contains(segment.b)) {
            inner.insert(segment.tag);
        }
    }
    const auto fits = [&](std::int32_t tag) { return outer.contains(tag) && !inner.contains(tag); };
    std::vector<PeriodicSpec> parts;
    for (const PeriodicLink &link : mesh.periodic) {
        if (fits(link.from) && fits(link.to)) {
            parts.push_back({link.from, link.to});
        }
    }
    return parts;
}

} // namespace

Result<MeshDomain> domainOfMesh(const MeshView &mesh, const Progress &progress, OpenLineRule rule) {
    if (mesh.elementCount() == 0 && mesh.edges.empty()) {
        return error("empty-domain", "the mesh has neither elements nor lines that could bound a domain");
    }
    std::optional<ClosedMesh> closed = mesh.elementCount() == 0 ? std::nullopt : closeOpenLines(mesh, rule);
    const MeshView whole = closed ? MeshView(closed->mesh) : mesh;
    Result<Domain> domain = MeshOutline(whole, progress).run();
    if (!domain) {
        return domain.faults();
    }
    MeshDomain made;
    made.domain = std::move(*domain);
    if (closed) {
        made.lines = std::move(closed->lines);
    }
    std::set<std::int32_t> cracks; // a line may have several other faces
    for (const OpenLine &line : made.lines) {
        cracks.insert(line.tag);
    }
    made.cracks.assign(cracks.begin(), cracks.end());
    made.periodic = periodicParts(mesh, made);
    return made;
}

std::vector<TaggedEdge> untaggedEdges(const MeshView &mesh) {
    const Progress none; // the outline refers to it
    MeshOutline outline(mesh, none);
    const Result<Domain> domain = outline.run();
    return domain ? outline.takeUntagged() : std::vector<TaggedEdge>();
}

} // namespace forefront
