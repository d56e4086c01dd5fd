#include "core/engine/base/cancelled.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/unused_tag.hpp"
#include "core/engine/mesh/crack_sectors.hpp"
#include "core/engine/mesh/cracks.hpp"
#include "core/engine/mesh/placed_cell.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace forefront {

std::string crackFaceName(const std::string &crack) {
    return crack + "_right";
}

namespace {

/// Opens the cracks of one mesh.
class CrackOpening {
  public:
    CrackOpening(const Mesh &mesh, std::span<const std::int32_t> tags)
        : mesh_(mesh), tags_(tags.begin(), tags.end()), table_(mesh), sides_(table_.halfEdges()),
          onCrack_(mesh.nodes.size(), false), cornerNode_(sides_.count(), kNoNode) {}

    Result<CrackReport> run(Mesh &mesh, const Progress &progress) {
        if (Status faults = chooseTags(); !faults.empty()) {
            return faults;
        }
        findLines();
        progress("opening cracks", 0.25);
        if (progress.cancelled()) {
            return cancelled("opening cracks");
        }
        const std::vector<bool> cut = cutLines();
        if (Status faults = checkInside(); !faults.empty()) {
            return faults;
        }
        const CrackSectors sectors(table_, cut, onCrack_);
        progress("opening cracks", 0.5);
        if (progress.cancelled()) {
            return cancelled("opening cracks");
        }
        placeNodes(sectors);
        if (Status faults = checkOpens(); !faults.empty()) {
            return faults;
        }
        placeMiddles();
        write(mesh);
        return std::move(report_);
    }

  private:
    bool isCrack(std::size_t edge) const { return tags_.contains(mesh_.edges[edge].tag); }

    Status chooseTags() {
        std::set<std::int32_t> taken{0};
        for (const TaggedEdge &edge : mesh_.edges) {
            taken.insert(edge.tag);
        }
        for (const TaggedNode &point : mesh_.points) {
            taken.insert(point.tag);
        }
        std::set<std::string> names;
        for (const auto &[tag, name] : mesh_.boundaryNames) {
            taken.insert(tag);
            names.insert(name);
        }
        for (const std::int32_t tag : tags_) {
            const std::string name = boundaryName(mesh_.boundaryNames, tag);
            if (names.contains(crackFaceName(name))) {
                return error("crack-name",
                             "crack " + name + ": another boundary part has the name of its right face, " +
                                 crackFaceName(name),
                             "rename that part, or the crack");
            }
            const std::int32_t last = *taken.rbegin();
            const std::int32_t right = last < std::numeric_limits<std::int32_t>::max()
                                           ? last + 1
                                           : unusedTag(taken, mesh_.boundaryNames, TagKind::Boundary);
            taken.insert(right);
            report_.cracks.push_back({tag, right});
        }
        return {};
    }

    CrackFaces &facesOf(std::int32_t tag) {
        return *std::find_if(report_.cracks.begin(), report_.cracks.end(),
                             [tag](const CrackFaces &faces) { return faces.left == tag; });
    }

    /// Gives the edges of each line one direction, that of the first of them.
    void findLines() {
        std::map<std::pair<std::int32_t, NodeId>, std::vector<std::size_t>> meeting; // edges by tag and node
        for (std::size_t i = 0; i < mesh_.edges.size(); ++i) {
            if (isCrack(i)) {
                for (const NodeId node : {mesh_.edges[i].a, mesh_.edges[i].b}) {
                    meeting[{mesh_.edges[i].tag, node}].push_back(i);
                    onCrack_[index(node)] = true;
                }
            }
        }
        forward_.assign(mesh_.edges.size(), true);
        std::vector<bool> done(mesh_.edges.size(), false);
        for (std::size_t first = 0; first < mesh_.edges.size(); ++first) {
            if (!isCrack(first) || done[first]) {
                continue;
            }
            done[first] = true;
            for (const bool ahead : {true, false}) {
                std::size_t edge = first;
                NodeId node = ahead ? mesh_.edges[first].b : mesh_.edges[first].a;
                for (;;) {
                    const std::vector<std::size_t> &here = meeting[{mesh_.edges[first].tag, node}];
                    const std::size_t next = here.size() != 2 ? edge : here[0] == edge ? here[1] : here[0];
                    if (next == edge || done[next]) {
                        break;
                    }
                    done[next] = true;
                    const bool startsHere = mesh_.edges[next].a == node;
                    forward_[next] = startsHere == ahead;
                    node = startsHere ? mesh_.edges[next].b : mesh_.edges[next].a;
                    edge = next;
                }
            }
        }
    }

    std::vector<bool> cutLines() {
        std::vector<bool> cut(sides_.count(), false);
        left_.assign(mesh_.edges.size(), kNoHalfEdge);
        right_.assign(mesh_.edges.size(), kNoHalfEdge);
        for (std::size_t i = 0; i < mesh_.edges.size(); ++i) {
            if (!isCrack(i)) {
                continue;
            }
            const TaggedEdge &edge = mesh_.edges[i];
            const NodeId start = forward_[i] ? edge.a : edge.b;
            for (const HalfEdge h : table_.find(edge.a, edge.b)) {
                cut[h] = true;
                (sides_.startOf(h) == start ? left_ : right_)[i] = h;
            }
            CrackFaces &faces = facesOf(edge.tag);
            ++faces.edges;
            faces.length += edgeLength(mesh_.nodes, edge.a, edge.middle, edge.b);
        }
        return cut;
    }

    Diagnostics faultAt(std::size_t edge, const char *code, const char *what, const char *advice) const {
        const TaggedEdge &at = mesh_.edges[edge];
        Diagnostics faults = error(code, "crack " + boundaryName(mesh_.boundaryNames, at.tag) + what, advice);
        faults.front().at = midpoint(mesh_.nodes[index(at.a)], mesh_.nodes[index(at.b)]);
        return faults;
    }
    Status checkInside() const {
        for (std::size_t i = 0; i < mesh_.edges.size(); ++i) {
            if (isCrack(i) && (left_[i] == kNoHalfEdge || right_[i] == kNoHalfEdge)) {
                return faultAt(i, "crack-outside", " has an element on one side alone; expected a line inside the mesh",
                               "name only lines inside the domain as cracks");
            }
        }
        return {};
    }

    /// Gives the corners at nodes of cracks their nodes.
    void placeNodes(const CrackSectors &sectors) {
        std::vector<std::vector<HalfEdge>> corners(mesh_.nodes.size());
        for (HalfEdge h = 0; h < sides_.count(); ++h) {
            if (onCrack_[index(sides_.startOf(h))]) {
                corners[index(sides_.startOf(h))].push_back(h);
            }
        }
        for (std::size_t n = 0; n < corners.size(); ++n) {
            const NodeId node{static_cast<std::uint32_t>(n)};
            for (const HalfEdge corner : corners[n]) {
                const HalfEdge sector = sectors.sectorOf(corner);
                if (sector == corner) {
                    cornerNode_[corner] = corner == corners[n].front() ? node : added(node);
                } else {
                    cornerNode_[corner] = cornerNode_[sector];
                }
            }
        }
    }
    NodeId added(NodeId node) {
        copies_.push_back(node);
        return NodeId{static_cast<std::uint32_t>(mesh_.nodes.size() + copies_.size() - 1)};
    }

    NodeId nodeAt(HalfEdge corner) const {
        return cornerNode_[corner] == kNoNode ? sides_.startOf(corner) : cornerNode_[corner];
    }
    /// Returns the nodes of a side of an element.
    std::pair<NodeId, NodeId> endsOf(HalfEdge h) const { return {nodeAt(h), nodeAt(sides_.next(h))}; }

    /// Refuses edges both of whose ends are tips.
    Status checkOpens() {
        std::set<NodeId> tips;
        for (std::size_t i = 0; i < mesh_.edges.size(); ++i) {
            if (!isCrack(i)) {
                continue;
            }
            const auto [a, b] = endsOf(left_[i]);
            const auto [c, d] = endsOf(right_[i]);
            if (a == d && b == c) {
                return faultAt(i, "crack-edge",
                               " has a single edge between its tips, which cannot open; expected two or more",
                               "choose a smaller element size there");
            }
            if (a == d) {
                tips.insert(a);
            }
            if (b == c) {
                tips.insert(b);
            }
        }
        report_.tips = tips.size();
        return {};
    }

    void placeMiddles() {
        for (std::size_t i = 0; i < mesh_.edges.size(); ++i) {
            if (isCrack(i) && sides_.middleOf(right_[i]) != kNoNode) {
                middles_[right_[i]] = added(sides_.middleOf(right_[i]));
            }
        }
        report_.addedNodes = copies_.size();
    }

    void write(Mesh &mesh) {
        std::vector<TaggedEdge> edges = mesh_.edges, rightEdges;
        std::vector<CurveStretch> stretches = mesh_.edgeStretches;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            if (isCrack(i)) {
                TaggedEdge right = facing(edges[i], right_[i]);
                right.tag = facesOf(edges[i].tag).right;
                rightEdges.push_back(right);
                if (!mesh_.edgeStretches.empty()) {
                    stretches.push_back(mesh_.edgeStretches[i]);
                }
                edges[i] = facing(edges[i], left_[i]);
            } else if (const auto beside = table_.find(edges[i].a, edges[i].b); !beside.empty()) {
                edges[i] = facing(edges[i], beside.front());
            }
        }
        edges.insert(edges.end(), rightEdges.begin(), rightEdges.end());
        std::vector<TaggedNode> points = mesh_.points;
        std::multimap<NodeId, std::uint32_t> copiesOf; // of equal nodes, in the order of their numbers
        for (std::size_t k = 0; k < copies_.size(); ++k) {
            copiesOf.emplace(copies_[k], static_cast<std::uint32_t>(mesh_.nodes.size() + k));
        }
        for (const TaggedNode &point : mesh_.points) {
            const auto [first, last] = copiesOf.equal_range(point.node);
            for (auto copy = first; copy != last; ++copy) {
                points.push_back({NodeId{copy->second}, point.tag});
            }
        }
        writeElements(mesh);
        for (const NodeId node : copies_) {
            mesh.nodes.push_back(Vec2(mesh.nodes[index(node)]));
        }
        mesh.edges = std::move(edges);
        mesh.edgeStretches = std::move(stretches);
        mesh.points = std::move(points);
        for (const CrackFaces &faces : report_.cracks) {
            mesh.boundaryNames[faces.right] = crackFaceName(boundaryName(mesh.boundaryNames, faces.left));
        }
    }
    /// Returns a tagged edge with the nodes of a side of an element that it lies on.
    TaggedEdge facing(TaggedEdge edge, HalfEdge h) const {
        const bool along = sides_.startOf(h) == edge.a;
        const auto [from, to] = endsOf(h);
        edge.a = along ? from : to;
        edge.b = along ? to : from;
        if (const auto middle = middles_.find(h); middle != middles_.end()) {
            edge.middle = middle->second;
        }
        return edge;
    }
    void writeElements(Mesh &mesh) {
        const HalfEdgeNumbers numbers = sides_;
        std::vector<std::pair<std::size_t, NodeId>> changes; // of the connectivity of a block
        std::size_t first = 0;
        for (CellBlock &block : mesh.blocks) {
            const CellTraits &traits = block.traits();
            changes.clear();
            for (std::size_t k = 0; k < block.size(); ++k) {
                for (std::size_t c = 0; c < traits.corners; ++c) {
                    const HalfEdge h = numbers.of(first + k, c);
                    if (cornerNode_[h] != kNoNode) {
                        changes.emplace_back(k * traits.nodes + c, cornerNode_[h]);
                    }
                    if (const auto middle = middles_.find(h); middle != middles_.end()) {
                        changes.emplace_back(k * traits.nodes + traits.corners + c, middle->second);
                    }
                }
            }
            for (const auto &[place, node] : changes) {
                block.connectivity()[place] = node;
            }
            first += block.size();
        }
    }

    const Mesh &mesh_;
    std::set<std::int32_t> tags_;
    EdgeTable table_;
    const HalfEdges &sides_;
    std::vector<bool> onCrack_;          ///< per node
    std::vector<bool> forward_;          ///< per tagged edge: it runs as the first edge of its line does
    std::vector<HalfEdge> left_, right_; ///< per tagged edge of a crack: the sides of its elements
    std::vector<NodeId> cornerNode_;     ///< per half-edge that starts at a node of a crack: its node
    std::map<HalfEdge, NodeId> middles_; ///< middle nodes of the sides of right faces
    std::vector<NodeId> copies_;         ///< per added node, the node that it is a copy of
    CrackReport report_;
};

} // namespace

Result<CrackReport> openCracks(Mesh &mesh, std::span<const std::int32_t> tags, const Progress &progress) {
    progress("opening cracks", 0.0);
    return CrackOpening(mesh, tags).run(mesh, progress);
}

} // namespace forefront
