#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/unused_tag.hpp"
#include "core/engine/mesh/crack_sectors.hpp"
#include "core/engine/mesh/cracks.hpp"
#include "core/engine/mesh/open_lines.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace forefront {

namespace {

/// Two sides of elements at the same place, with the elements on opposite sides of it.
struct FacingSides {
    HalfEdge first, second; ///< the first one has the lower number
};

/// Finds the facing sides of a mesh and what their edges are tagged with. Refers to its parts.
class OpenEdges {
  public:
    OpenEdges(const MeshView &mesh, const EdgeTable &table) : mesh_(mesh), table_(table), sides_(table.halfEdges()) {
        std::vector<HalfEdge> boundary;
        table_.forEach([&](NodeId, NodeId, std::span<const HalfEdge> sides) {
            if (sides.size() == 1) {
                boundary.push_back(sides[0]);
            }
        });
        pair(boundary);
        findTags();
    }

    /// Keeps the pairs that have one of these tags, or none.
    void keepOnly(std::span<const std::int32_t> tags) {
        keepIf([&](std::int32_t tag) { return tag == 0 || std::find(tags.begin(), tags.end(), tag) != tags.end(); });
    }
    /// Keeps the pairs with tags that no edge elsewhere has.
    void keepOwnTags() {
        keepIf([this](std::int32_t tag) { return tag != 0 && !elsewhere_.contains(tag); });
    }

    /// Gives the lines whose tags edges elsewhere have, and those without one, unused tags. Adds their names.
    void separateTags(std::map<std::int32_t, std::string> &names) {
        std::set<std::int32_t> taken = elsewhere_;
        for (const auto &[first, second] : tags_) {
            taken.insert({first, second});
        }
        for (const TaggedNode &point : mesh_.points) {
            taken.insert(point.tag);
        }
        for (const OpenLine &line : lines()) {
            if (line.tag != 0 && !elsewhere_.contains(line.tag)) {
                continue;
            }
            const std::int32_t tag = unusedTag(taken, names, TagKind::Boundary);
            taken.insert(tag);
            names[tag] = unusedCrackName(names);
            ownTags_[{line.tag, line.other}] = tag;
        }
    }

    const std::vector<FacingSides> &pairs() const { return pairs_; }
    const EdgeTable &table() const { return table_; }

    /// Returns the lines that the pairs form, by their tags.
    std::vector<OpenLine> lines() const {
        std::map<std::pair<std::int32_t, std::int32_t>, OpenLine> lines;
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
            const OpenLine own = lineOf(tags_[k]);
            const std::int32_t tag = tagOf(k);
            OpenLine &line = lines[{tag, own.other}];
            if (line.edges++ == 0) {
                line.tag = tag;
                line.other = own.other;
                line.at = midpoint(at(sides_.startOf(pairs_[k].first)), at(sides_.endOf(pairs_[k].first)));
            }
        }
        std::vector<OpenLine> found;
        for (const auto &[tags, line] : lines) {
            found.push_back(line);
        }
        return found;
    }
    /// Returns the tag that the closed edge of a pair has; 0: none.
    std::int32_t tagOf(std::size_t pair) const {
        const OpenLine line = lineOf(tags_[pair]);
        const auto own = ownTags_.find({line.tag, line.other});
        return own == ownTags_.end() ? line.tag : own->second;
    }
    /// Returns the tag of the face of a pair whose edge stays; 0: none.
    std::int32_t faceTagOf(std::size_t pair) const { return lineOf(tags_[pair]).tag; }

    /// Returns per node the one that takes its place.
    std::vector<NodeId> joinedNodes() const {
        std::vector<NodeId> joined(mesh_.nodes.size());
        for (std::uint32_t n = 0; n < joined.size(); ++n) {
            joined[n] = NodeId{n};
        }
        const auto rootOf = [&](NodeId n) {
            while (joined[index(n)] != n) {
                n = joined[index(n)];
            }
            return n;
        };
        const auto join = [&](NodeId a, NodeId b) {
            if (a != kNoNode && b != kNoNode) {
                a = rootOf(a);
                b = rootOf(b);
                joined[index(std::max(a, b))] = std::min(a, b);
            }
        };
        for (const FacingSides &pair : pairs_) {
            join(sides_.startOf(pair.first), sides_.endOf(pair.second));
            join(sides_.endOf(pair.first), sides_.startOf(pair.second));
            join(sides_.middleOf(pair.first), sides_.middleOf(pair.second));
        }
        for (NodeId &node : joined) {
            node = rootOf(node);
        }
        return joined;
    }

  private:
    using Tags = std::pair<std::int32_t, std::int32_t>; ///< of both sides; 0: none

    template <class Keeps>
    void keepIf(const Keeps &keeps) {
        std::size_t kept = 0;
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
            if (keeps(lineOf(tags_[k]).tag)) {
                pairs_[kept] = pairs_[k];
                tags_[kept++] = tags_[k];
            }
        }
        pairs_.resize(kept);
        tags_.resize(kept);
    }

    /// Returns a name for a line such that neither it nor the name of its right face is taken.
    static std::string unusedCrackName(const std::map<std::int32_t, std::string> &names) {
        std::set<std::string> used;
        for (const auto &[tag, name] : names) {
            used.insert(name);
        }
        std::string name = "crack";
        for (int number = 2; used.contains(name) || used.contains(crackFaceName(name)); ++number) {
            name = "crack_" + std::to_string(number);
        }
        return name;
    }

    Vec2 at(NodeId node) const { return mesh_.nodes[index(node)]; }
    /// Returns the place of the ends of a side from low to high, the same for facing sides.
    std::pair<Vec2, Vec2> placeOf(HalfEdge h) const {
        const Vec2 a = at(sides_.startOf(h)), b = at(sides_.endOf(h));
        return comesBefore(a, b) ? std::pair(a, b) : std::pair(b, a);
    }
    bool runsUp(HalfEdge h) const { return comesBefore(at(sides_.startOf(h)), at(sides_.endOf(h))); }

    void pair(std::vector<HalfEdge> &boundary) {
        std::sort(boundary.begin(), boundary.end(), [this](HalfEdge g, HalfEdge h) {
            const auto p = placeOf(g), q = placeOf(h);
            return p.first != q.first     ? comesBefore(p.first, q.first)
                   : p.second != q.second ? comesBefore(p.second, q.second)
                                          : g < h;
        });
        for (std::size_t k = 0; k < boundary.size();) {
            std::size_t end = k + 1;
            while (end < boundary.size() && placeOf(boundary[end]) == placeOf(boundary[k])) {
                ++end;
            }
            // More than two are overlapping elements.
            if (end == k + 2 && runsUp(boundary[k]) != runsUp(boundary[k + 1]) &&
                sameMiddle(boundary[k], boundary[k + 1])) {
                pairs_.push_back({boundary[k], boundary[k + 1]});
            }
            k = end;
        }
        std::sort(pairs_.begin(), pairs_.end(),
                  [](const FacingSides &p, const FacingSides &q) { return p.first < q.first; });
    }
    bool sameMiddle(HalfEdge g, HalfEdge h) const {
        const NodeId m = sides_.middleOf(g), n = sides_.middleOf(h);
        return m == kNoNode || n == kNoNode ? m == n : at(m) == at(n);
    }

    void findTags() {
        if (pairs_.empty()) {
            return;
        }
        std::map<HalfEdge, std::int32_t *> wanted;
        tags_.resize(pairs_.size());
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
            wanted[pairs_[k].first] = &tags_[k].first;
            wanted[pairs_[k].second] = &tags_[k].second;
        }
        for (const TaggedEdge &edge : mesh_.edges) {
            const auto sides = table_.find(edge.a, edge.b);
            const auto found = sides.empty() ? wanted.end() : wanted.find(sides.front());
            if (found != wanted.end()) {
                *found->second = edge.tag;
            } else {
                elsewhere_.insert(edge.tag);
            }
        }
    }

    /// Returns the tags of a closed edge whose faces have these.
    OpenLine lineOf(const Tags &tags) const {
        const auto [low, high] = std::minmax(tags.first, tags.second);
        if (low == high || low == 0) {
            return {high, 0, 0, {}};
        }
        const std::string lowName = boundaryName(mesh_.boundaryNames, low),
                          highName = boundaryName(mesh_.boundaryNames, high);
        return lowName == crackFaceName(highName) ? OpenLine{high, low, 0, {}} : OpenLine{low, high, 0, {}};
    }

    const MeshView &mesh_;
    const EdgeTable &table_;
    const HalfEdges &sides_;
    std::vector<FacingSides> pairs_;       ///< by their first sides
    std::vector<Tags> tags_;               ///< per pair
    std::set<std::int32_t> elsewhere_;     ///< tags of edges that are no side of a pair
    std::map<Tags, std::int32_t> ownTags_; ///< new tags of lines, by their tag and that of the other face
};

/// Which of the edges that fall together stays.
struct ClosedEdge {
    std::int32_t face = 0; ///< the first one with this tag
    std::int32_t tag = 0;  ///< that it gets
};

/// Gives the elements, tagged edges and points of a mesh the joined nodes.
void joinNodes(Mesh &mesh, std::span<const NodeId> joined,
               const std::map<std::pair<NodeId, NodeId>, ClosedEdge> &chosen) {
    for (CellBlock &block : mesh.blocks) {
        for (NodeId &node : block.connectivity()) {
            node = joined[index(node)];
        }
    }
    std::set<std::pair<NodeId, NodeId>> done;
    std::vector<TaggedEdge> edges;
    std::vector<CurveStretch> stretches;
    for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
        TaggedEdge edge = mesh.edges[k];
        edge.a = joined[index(edge.a)];
        edge.b = joined[index(edge.b)];
        edge.middle = edge.middle == kNoNode ? kNoNode : joined[index(edge.middle)];
        const std::pair<NodeId, NodeId> ends = std::minmax(edge.a, edge.b);
        if (const auto own = chosen.find(ends); own != chosen.end()) {
            if (edge.tag != own->second.face || !done.insert(ends).second) {
                continue;
            }
            edge.tag = own->second.tag;
        }
        edges.push_back(edge);
        if (!mesh.edgeStretches.empty()) {
            stretches.push_back(mesh.edgeStretches[k]);
        }
    }
    mesh.edges = std::move(edges);
    mesh.edgeStretches = std::move(stretches);
    std::set<std::pair<NodeId, std::int32_t>> known;
    std::vector<TaggedNode> points;
    for (TaggedNode point : mesh.points) {
        point.node = joined[index(point.node)];
        if (known.insert({point.node, point.tag}).second) {
            points.push_back(point);
        }
    }
    mesh.points = std::move(points);
}

ClosedMesh closed(const MeshView &mesh, const OpenEdges &open) {
    ClosedMesh result{copyOf(mesh), open.lines()};
    const std::vector<NodeId> joined = open.joinedNodes();
    std::map<std::pair<NodeId, NodeId>, ClosedEdge> chosen;
    std::vector<TaggedEdge> named; // of lines that had no tag
    const HalfEdges &sides = open.table().halfEdges();
    for (std::size_t k = 0; k < open.pairs().size(); ++k) {
        const HalfEdge h = open.pairs()[k].first;
        const NodeId a = joined[index(sides.startOf(h))], b = joined[index(sides.endOf(h))];
        const ClosedEdge edge{open.faceTagOf(k), open.tagOf(k)};
        chosen[std::minmax(a, b)] = edge;
        if (edge.face == 0 && edge.tag != 0) {
            const NodeId middle = sides.middleOf(h);
            named.push_back({a, b, edge.tag, middle == kNoNode ? kNoNode : joined[index(middle)]});
        }
    }
    joinNodes(result.mesh, joined, chosen);
    result.mesh.edges.insert(result.mesh.edges.end(), named.begin(), named.end());
    if (!result.mesh.edgeStretches.empty()) {
        result.mesh.edgeStretches.resize(result.mesh.edges.size());
    }
    return result;
}

/// Drops the names of other faces that nothing has any longer.
void dropNamesOfFaces(ClosedMesh &closed) {
    std::set<std::int32_t> present;
    for (const TaggedEdge &edge : closed.mesh.edges) {
        present.insert(edge.tag);
    }
    for (const TaggedNode &point : closed.mesh.points) {
        present.insert(point.tag);
    }
    for (const OpenLine &line : closed.lines) {
        if (!present.contains(line.other)) {
            closed.mesh.boundaryNames.erase(line.other);
        }
    }
}

} // namespace

ClosedMesh closeCracks(const MeshView &mesh, std::span<const std::int32_t> only) {
    const EdgeTable table(mesh);
    OpenEdges open(mesh, table);
    if (!only.empty()) {
        open.keepOnly(only);
    }
    return closed(mesh, open);
}

std::optional<ClosedMesh> closeOpenLines(const MeshView &mesh, OpenLineRule rule) {
    const EdgeTable table(mesh);
    OpenEdges open(mesh, table);
    if (rule == OpenLineRule::OwnTags) {
        open.keepOwnTags();
    }
    if (open.pairs().empty()) {
        return std::nullopt;
    }
    std::map<std::int32_t, std::string> names(mesh.boundaryNames);
    open.separateTags(names);
    ClosedMesh result = closed(mesh, open);
    result.mesh.boundaryNames = std::move(names);
    dropNamesOfFaces(result);
    return result;
}

std::vector<OpenLine> openLines(const MeshView &mesh) {
    return openLines(mesh, EdgeTable(mesh));
}

std::vector<OpenLine> openLines(const MeshView &mesh, const EdgeTable &table) {
    return OpenEdges(mesh, table).lines();
}

Diagnostics verifyCracks(const MeshView &mesh, std::span<const std::int32_t> cracks, const MeshNumbers &numbers) {
    const EdgeTable openTable(mesh);
    OpenEdges open(mesh, openTable);
    if (!cracks.empty()) {
        open.keepOnly(cracks);
    }
    const HalfEdges &sides = open.table().halfEdges();
    std::set<HalfEdge> facing;
    for (const FacingSides &pair : open.pairs()) {
        facing.insert({pair.first, pair.second});
    }
    const auto fault = [&](const char *code, std::string what, Vec2 at) {
        Diagnostics faults = error(code, std::move(what));
        faults.front().at = at;
        return faults;
    };
    const auto name = [&](NodeId node) { return std::to_string(numbers.nodes.of(index(node))); };
    for (const TaggedEdge &edge : mesh.edges) {
        const auto beside = open.table().find(edge.a, edge.b);
        const bool isCrack = std::find(cracks.begin(), cracks.end(), edge.tag) != cracks.end();
        if (isCrack && (beside.empty() || !facing.contains(beside.front()))) {
            return fault("crack-closed",
                         "edge " + name(edge.a) + '-' + name(edge.b) + " of crack " +
                             boundaryName(mesh.boundaryNames, edge.tag) +
                             " is not double; expected an edge of each face with nodes of its own",
                         midpoint(mesh.nodes[index(edge.a)], mesh.nodes[index(edge.b)]));
        }
    }
    // In the closed mesh, each sector around a node of a crack must have one node of the open one, and no other has it.
    const ClosedMesh whole = closed(mesh, open);
    const MeshView view(whole.mesh);
    const EdgeTable table(view);
    const HalfEdges &closedSides = table.halfEdges();
    std::vector<bool> cut(closedSides.count(), false), onCrack(mesh.nodes.size(), false);
    for (const HalfEdge h : facing) { // half-edges keep their numbers
        cut[h] = true;
        onCrack[index(closedSides.startOf(h))] = onCrack[index(closedSides.endOf(h))] = true;
    }
    const CrackSectors sectors(table, cut, onCrack);
    std::map<NodeId, HalfEdge> sectorOf; // of nodes of the open mesh
    for (HalfEdge h = 0; h < closedSides.count(); ++h) {
        if (!onCrack[index(closedSides.startOf(h))]) {
            continue;
        }
        const HalfEdge sector = sectors.sectorOf(h);
        const NodeId node = sides.startOf(h);
        if (node != sides.startOf(sector) || sectorOf.try_emplace(node, sector).first->second != sector) {
            return fault("crack-nodes",
                         "node " + name(node) + " at a crack belongs to two sectors between its faces, or a sector " +
                             "has two nodes; expected one node for each sector",
                         mesh.nodes[index(node)]);
        }
    }
    return {};
}

} // namespace forefront
