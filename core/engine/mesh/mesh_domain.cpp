#include "core/engine/mesh/mesh_domain.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/paced_progress.hpp"
#include "core/engine/domain/unused_tag.hpp"
#include "core/engine/mesh/topology.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

namespace forefront {

namespace {

class MeshOutline {
  public:
    MeshOutline(const TriMesh &mesh, const Progress &progress)
        : mesh_(mesh), numbers_(mesh.nodes.size(), kNoIndex), tagged_(mesh.nodes.size(), false),
          progress_(progress, "finding the outline", 2 * mesh.elements.size()) {}

    Result<Domain> run() {
        collectTags();
        chooseTagsOfUnnamed();
        if (!mesh_.elements.empty() && !elementEdges()) {
            return cancelled("finding the outline");
        }
        for (std::size_t k = 0; k < tags_.size(); ++k) {
            if (!used_[k]) {
                addSegment(NodeId{tags_[k].a}, NodeId{tags_[k].b}, tags_[k].tag,
                           mesh_.elements.empty() ? SegmentRole::Boundary : SegmentRole::Constraint, tags_[k].stretch);
            }
        }
        for (const TaggedNode &point : mesh_.points) {
            domain_.points.push_back({number(point.node), point.tag});
        }
        domain_.boundaryNames = mesh_.boundaryNames;
        domain_.regionNames = mesh_.regionNames;
        domain_.curves = mesh_.curves;
        return std::move(domain_);
    }

  private:
    struct Tagged {
        std::uint32_t low, high, a, b;
        std::int32_t tag;
        CurveStretch stretch; ///< from a to b
        auto key() const { return std::tuple(low, high); }
    };

    void collectTags() {
        tags_.reserve(mesh_.edges.size());
        for (std::size_t k = 0; k < mesh_.edges.size(); ++k) {
            const auto a = static_cast<std::uint32_t>(mesh_.edges[k].a);
            const auto b = static_cast<std::uint32_t>(mesh_.edges[k].b);
            const CurveStretch stretch = k < mesh_.edgeStretches.size() ? mesh_.edgeStretches[k] : CurveStretch();
            tags_.push_back({std::min(a, b), std::max(a, b), a, b, mesh_.edges[k].tag, stretch});
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
        neighbours_ = elementNeighbours(mesh_);
        divides_.resize(neighbours_.size());
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
            if (!progress_.next()) {
                return false;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                elementEdge(e, k);
            }
        }
        const bool named = !mesh_.regionNames.empty() ||
                           std::any_of(mesh_.regions.begin(), mesh_.regions.end(), [](auto tag) { return tag != 1; });
        return !named || regionMarkers();
    }

    void elementEdge(std::size_t e, std::size_t k) {
        const ElementId neighbour = neighbours_[e][k];
        const NodeId a = mesh_.elements[e][k];
        const NodeId b = mesh_.elements[e][(k + 1) % 3];
        const std::size_t found = findTag(a, b);
        const bool tagged = found < tags_.size();
        const bool outer = neighbour == kNoElement;
        if (!outer && !tagged && mesh_.region(e) == mesh_.region(index(neighbour))) {
            return;
        }
        divides_[e][k] = true;
        if (tagged && used_[found]) {
            return;
        }
        if (tagged) {
            used_[found] = true;
        } else if (!outer && index(neighbour) < e) {
            return;
        }
        addSegment(a, b,
                   tagged  ? tags_[found].tag
                   : outer ? outerTag_
                           : interfaceTag_,
                   outer ? SegmentRole::Boundary : SegmentRole::Constraint,
                   !tagged                                           ? CurveStretch()
                   : tags_[found].a == static_cast<std::uint32_t>(a) ? tags_[found].stretch
                                                                     : tags_[found].stretch.reversed());
    }

    /// Places a marker in every face, in its largest element. Returns false once cancelled.
    bool regionMarkers() {
        std::vector<bool> seen(mesh_.elements.size(), false);
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
                for (std::size_t k = 0; k < 3; ++k) {
                    const ElementId next = neighbours_[e][k];
                    if (!divides_[e][k] && next != kNoElement && !seen[index(next)]) {
                        seen[index(next)] = true;
                        stack.push_back(index(next));
                    }
                }
            }
            const Element &nodes = mesh_.elements[largest];
            const Vec2 sum = place(nodes[0]) + place(nodes[1]) + place(nodes[2]);
            domain_.regionMarkers.push_back({(1.0 / 3.0) * sum, mesh_.region(largest)});
        }
        return true;
    }

    Vec2 place(NodeId node) const { return mesh_.nodes[index(node)]; }
    double area(std::size_t e) const {
        const Element &nodes = mesh_.elements[e];
        return std::abs(cross(place(nodes[1]) - place(nodes[0]), place(nodes[2]) - place(nodes[0])));
    }

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

    const TriMesh &mesh_;
    std::vector<std::uint32_t> numbers_; ///< per node of the mesh: its index in the domain
    std::vector<bool> tagged_;           ///< per node of the mesh: it is on an edge with a tag
    std::vector<Tagged> tags_;
    std::vector<bool> used_;
    std::int32_t outerTag_ = 1;     ///< for outer edges without a tag
    std::int32_t interfaceTag_ = 2; ///< for interfaces without a tag
    std::vector<std::array<ElementId, 3>> neighbours_;
    std::vector<std::array<bool, 3>> divides_;
    PacedProgress progress_;
    Domain domain_;
};

} // namespace

Result<Domain> domainOfMesh(const TriMesh &mesh, const Progress &progress) {
    if (mesh.elements.empty() && mesh.edges.empty()) {
        return error("empty-domain", "the mesh has neither triangles nor lines that could bound a domain");
    }
    return MeshOutline(mesh, progress).run();
}

} // namespace forefront
