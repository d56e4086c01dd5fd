#include "core/engine/improve/improve_record.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/mesh/shape_tally.hpp"

#include <algorithm>
#include <bit>
#include <iterator>
#include <utility>

namespace forefront {

namespace {

/// Compares bits, so that the record tells zeros of different signs apart.
bool sameBits(Vec2 p, Vec2 q) {
    return std::bit_cast<std::uint64_t>(p.x) == std::bit_cast<std::uint64_t>(q.x) &&
           std::bit_cast<std::uint64_t>(p.y) == std::bit_cast<std::uint64_t>(q.y);
}

bool sameEdge(const TaggedEdge &a, const TaggedEdge &b) {
    return a.a == b.a && a.b == b.b && a.tag == b.tag && a.middle == b.middle;
}

bool samePoint(const TaggedNode &a, const TaggedNode &b) {
    return a.node == b.node && a.tag == b.tag;
}

/// Returns the kind of pass that a change belongs to: the first of those that alternate in one.
ImproveChange passOf(ImproveChange change) {
    switch (change) {
    case ImproveChange::Restore:
        return ImproveChange::Sweep;
    case ImproveChange::Merge:
    case ImproveChange::Divide:
        return ImproveChange::RelaxedSwap;
    default:
        return change;
    }
}

/// The nodes and edges of a few elements, by their numbers.
struct Skeleton {
    std::vector<std::uint32_t> nodes;                ///< one for each corner
    std::vector<std::array<std::uint32_t, 2>> edges; ///< the lower node first

    void add(const Element &n) {
        for (unsigned k = 0; k < 3 && n[0] != kNoNode; ++k) {
            const auto a = static_cast<std::uint32_t>(index(n[k]));
            const auto b = static_cast<std::uint32_t>(index(n[(k + 1) % 3]));
            nodes.push_back(a);
            edges.push_back({std::min(a, b), std::max(a, b)});
        }
    }
    void sort() {
        std::sort(nodes.begin(), nodes.end());
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    }
    /// Returns the number of corners at a node.
    std::size_t cornersAt(std::uint32_t node) const {
        const auto [first, last] = std::equal_range(nodes.begin(), nodes.end(), node);
        return static_cast<std::size_t>(last - first);
    }
    /// Calls visit(node) once for each node.
    template <class Visit>
    void forEachNode(const Visit &visit) const {
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (i == 0 || nodes[i] != nodes[i - 1]) {
                visit(nodes[i]);
            }
        }
    }
};

} // namespace

std::size_t ImproveRecord::Delta::bytes() const {
    const auto tagged = [](const std::optional<Tagged> &t) {
        return t ? t->edges.size() * sizeof(TaggedEdge) + t->points.size() * sizeof(TaggedNode) : 0;
    };
    return sizeof *this + nodes.size() * sizeof(NodeChange) + cells.size() * sizeof(CellChange) + tagged(taggedBefore) +
           tagged(taggedAfter);
}

ImproveRecord::ImproveRecord(const TriMesh &mesh, std::size_t maxBytes)
    : maxBytes_(maxBytes), hasRegions_(!mesh.regions.empty()), mesh_(mesh) {
    uses_.resize(mesh_.nodes.size(), 0);
    everUsed_.resize(mesh_.nodes.size(), 0);
    cells_.reserve(mesh_.elements.size());
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
        cells_.push_back({mesh_.elements[e], mesh_.region(e)});
        count(cells_.back(), true);
    }
    mesh_.elements.clear();
    mesh_.regions.clear();
}

void ImproveRecord::count(const Cell &cell, bool add) {
    for (unsigned k = 0; k < 3 && cell.nodes[0] != kNoNode; ++k) {
        uses_[index(cell.nodes[k])] += add ? 1U : ~0U;
        everUsed_[index(cell.nodes[k])] = 1;
    }
}

void ImproveRecord::compareNode(Delta &delta, std::size_t n, std::span<const Vec2> places) const {
    const Vec2 before = n < mesh_.nodes.size() ? mesh_.nodes[n] : Vec2{};
    const Vec2 after = n < places.size() ? places[n] : Vec2{};
    if (!sameBits(before, after)) {
        delta.nodes.push_back({static_cast<std::uint32_t>(n), before, after});
    }
}

void ImproveRecord::compareCell(Delta &delta, std::size_t e, const TriMesh &mesh) const {
    const Cell before = e < cells_.size() ? cells_[e] : Cell{};
    Cell after;
    if (e < mesh.elements.size() && mesh.elements[e][0] != kNoNode) {
        after = {mesh.elements[e], mesh.region(e)};
    }
    if (!(before == after)) {
        delta.cells.push_back({static_cast<std::uint32_t>(e), before, after});
    }
}

void ImproveRecord::compareTagged(Delta &delta, const TriMesh &mesh) const {
    if (!std::ranges::equal(mesh_.edges, mesh.edges, sameEdge) ||
        !std::ranges::equal(mesh_.points, mesh.points, samePoint)) {
        delta.taggedBefore = {mesh_.edges, mesh_.points};
        delta.taggedAfter = {mesh.edges, mesh.points};
    }
}

std::optional<ImproveRecord::Delta> ImproveRecord::differenceTo(ImproveChange change, const TriMesh &mesh,
                                                                std::span<const Vec2> places,
                                                                const ChangedParts &parts) const {
    Delta delta{.change = change,
                .nodesBefore = mesh_.nodes.size(),
                .nodesAfter = places.size(),
                .cellsBefore = cells_.size(),
                .cellsAfter = mesh.elements.size(),
                .nodes = {},
                .cells = {},
                .taggedBefore = {},
                .taggedAfter = {}};
    if (parts.all) {
        for (std::size_t n = 0; n < std::max(delta.nodesBefore, delta.nodesAfter); ++n) {
            compareNode(delta, n, places);
        }
        for (std::size_t e = 0; e < std::max(delta.cellsBefore, delta.cellsAfter); ++e) {
            compareCell(delta, e, mesh);
        }
        compareTagged(delta, mesh);
    } else {
        std::vector<std::uint32_t> nodes, elements(parts.elements.begin(), parts.elements.end());
        std::ranges::transform(parts.nodes, std::back_inserter(nodes),
                               [](NodeId n) { return static_cast<std::uint32_t>(index(n)); });
        for (std::vector<std::uint32_t> *list : {&nodes, &elements}) {
            std::sort(list->begin(), list->end());
            list->erase(std::unique(list->begin(), list->end()), list->end());
        }
        for (const std::uint32_t n : nodes) {
            compareNode(delta, n, places);
        }
        for (const std::uint32_t e : elements) {
            compareCell(delta, e, mesh);
        }
    }
    const bool changes = !delta.nodes.empty() || !delta.cells.empty() || delta.taggedAfter ||
                         delta.nodesBefore != delta.nodesAfter || delta.cellsBefore != delta.cellsAfter;
    return changes ? std::optional(std::move(delta)) : std::nullopt;
}

void ImproveRecord::keep(Delta delta) {
    bytes_ += delta.bytes();
    full_ = full_ || bytes_ > maxBytes_;
    const ImproveChange change = delta.change;
    apply(delta, true);
    if (change != ImproveChange::Renumber) {
        const bool samePass = !steps_.empty() && passOf(deltas_[steps_.back()].change) == passOf(change);
        if (samePass) {
            passEnds_.pop_back();
        }
        steps_.push_back(deltas_.size());
        passEnds_.push_back(steps_.size());
    }
    deltas_.push_back(std::move(delta));
    done_ = deltas_.size();
    position_ = steps_.size();
}

void ImproveRecord::changed(ImproveChange change, const TriMesh &mesh, std::span<const Vec2> places,
                            const ChangedParts &parts) {
    if (full_ && change != ImproveChange::Remainder) {
        return;
    }
    if (std::optional<Delta> delta = differenceTo(change, mesh, places, parts)) {
        keep(*std::move(delta));
    }
}

void ImproveRecord::apply(const Delta &delta, bool forward) {
    mesh_.nodes.resize(std::max(delta.nodesBefore, delta.nodesAfter));
    uses_.resize(mesh_.nodes.size(), 0);
    everUsed_.resize(std::max(everUsed_.size(), mesh_.nodes.size()), 0);
    cells_.resize(std::max(delta.cellsBefore, delta.cellsAfter));
    for (const NodeChange &node : delta.nodes) {
        mesh_.nodes[node.at] = forward ? node.after : node.before;
    }
    for (const CellChange &cell : delta.cells) {
        count(forward ? cell.before : cell.after, false);
        count(forward ? cell.after : cell.before, true);
        cells_[cell.at] = forward ? cell.after : cell.before;
    }
    if (const std::optional<Tagged> &tagged = forward ? delta.taggedAfter : delta.taggedBefore) {
        mesh_.edges = tagged->edges;
        mesh_.points = tagged->points;
    }
    mesh_.nodes.resize(forward ? delta.nodesAfter : delta.nodesBefore);
    uses_.resize(mesh_.nodes.size());
    cells_.resize(forward ? delta.cellsAfter : delta.cellsBefore);
}

void ImproveRecord::moveTo(std::size_t step) {
    FOREFRONT_ASSERT(step <= steps());
    // What renumbers is done with the step that follows it, so that a step and the mesh after it have the same numbers.
    // What renumbers after the last step is done with that one.
    moveToDelta(step == steps() ? deltas_.size() : step == 0 ? 0 : steps_[step - 1] + 1);
    position_ = step;
}

void ImproveRecord::moveToDelta(std::size_t target) {
    while (done_ < target) {
        apply(deltas_[done_++], true);
    }
    while (done_ > target) {
        apply(deltas_[--done_], false);
    }
}

/// Returns the number of each node in mesh(), which leaves out nodes that no element has any more. Nodes of tagged
/// points and those that never had an element stay.
std::vector<std::uint32_t> ImproveRecord::numbersOfNodes() const {
    std::vector<std::uint32_t> numbers(mesh_.nodes.size(), kNoIndex);
    std::uint32_t next = 0;
    std::vector<std::uint8_t> stays(mesh_.nodes.size(), 0);
    for (const TaggedNode &point : mesh_.points) {
        stays[index(point.node)] = 1;
    }
    for (std::size_t n = 0; n < numbers.size(); ++n) {
        if (uses_[n] > 0 || everUsed_[n] == 0 || stays[n] != 0) {
            numbers[n] = next++;
        }
    }
    return numbers;
}

TriMesh ImproveRecord::mesh() const {
    TriMesh mesh = mesh_;
    const std::vector<std::uint32_t> numbers = numbersOfNodes();
    const auto renumber = [&](NodeId n) { return NodeId{numbers[index(n)]}; };
    mesh.nodes.clear();
    for (std::size_t n = 0; n < numbers.size(); ++n) {
        if (numbers[n] != kNoIndex) {
            mesh.nodes.push_back(mesh_.nodes[n]);
        }
    }
    for (const Cell &cell : cells_) {
        if (const Element &n = cell.nodes; n[0] != kNoNode) {
            mesh.elements.push_back({renumber(n[0]), renumber(n[1]), renumber(n[2])});
            if (hasRegions_) {
                mesh.regions.push_back(cell.region);
            }
        }
    }
    for (TaggedEdge &edge : mesh.edges) {
        edge.a = renumber(edge.a);
        edge.b = renumber(edge.b);
    }
    for (TaggedNode &point : mesh.points) {
        point.node = renumber(point.node);
    }
    return mesh;
}

MeshQuality ImproveRecord::shapes() const {
    MeshQuality quality = shapesOf(mesh_.nodes, cells_, &Cell::nodes);
    const std::vector<std::uint32_t> numbers = numbersOfNodes();
    quality.nodes = numbers.size() - static_cast<std::size_t>(std::count(numbers.begin(), numbers.end(), kNoIndex));
    return quality;
}

/// Gives moves the numbers that their nodes have at this position, which they have after the step: the places of nodes
/// differ.
void ImproveRecord::renumberMoves(ImproveStep &step) const {
    std::vector<ImproveStep::Move *> moves;
    for (ImproveStep::Move &move : step.moves) {
        moves.push_back(&move);
    }
    const auto before = [](Vec2 p, Vec2 q) { return p.x < q.x || (p.x == q.x && p.y < q.y); };
    std::ranges::sort(moves, before, &ImproveStep::Move::to);
    const std::vector<std::uint32_t> numbers = numbersOfNodes();
    for (std::size_t n = 0; n < numbers.size(); ++n) {
        const auto found = std::ranges::lower_bound(moves, mesh_.nodes[n], before, &ImproveStep::Move::to);
        if (numbers[n] != kNoIndex && found != moves.end() && (*found)->to == mesh_.nodes[n]) {
            (*found)->node = NodeId{numbers[n]};
        }
    }
}

/// Lists the nodes that stay and move.
void ImproveRecord::listMoves(const Delta &delta, ImproveStep &step) const {
    const std::vector<std::uint32_t> numbers = numbersOfNodes();
    for (const NodeChange &node : delta.nodes) {
        const bool stays = node.at < delta.nodesBefore && node.at < delta.nodesAfter && numbers[node.at] != kNoIndex;
        if (stays) {
            step.moves.push_back({NodeId{numbers[node.at]}, node.before, node.after});
        }
    }
}

/// Lists the elements, edges and nodes that come and go.
void ImproveRecord::listElements(const Delta &delta, ImproveStep &step) const {
    std::vector<Vec2> before = mesh_.nodes; // the places before the step
    for (const NodeChange &node : delta.nodes) {
        before[node.at] = node.before;
    }
    Skeleton old, made;
    for (const CellChange &cell : delta.cells) {
        old.add(cell.before.nodes);
        made.add(cell.after.nodes);
        if (const Element &n = cell.after.nodes; n[0] != kNoNode) {
            step.elements.push_back(
                {{mesh_.nodes[index(n[0])], mesh_.nodes[index(n[1])], mesh_.nodes[index(n[2])]}, 3});
        }
    }
    old.sort();
    made.sort();
    std::vector<std::array<std::uint32_t, 2>> removed, added;
    std::ranges::set_difference(old.edges, made.edges, std::back_inserter(removed));
    std::ranges::set_difference(made.edges, old.edges, std::back_inserter(added));
    for (const auto &[a, b] : removed) {
        step.removedEdges.push_back({before[a], before[b]});
    }
    for (const auto &[a, b] : added) {
        step.addedEdges.push_back({mesh_.nodes[a], mesh_.nodes[b]});
    }
    old.forEachNode([&](std::uint32_t n) {
        if (uses_[n] == 0) {
            step.removedNodes.push_back(before[n]);
        }
    });
    made.forEachNode([&](std::uint32_t n) {
        if (made.cornersAt(n) == uses_[n] && old.cornersAt(n) == 0) { // all its elements are new
            step.addedNodes.push_back(mesh_.nodes[n]);
        }
    });
}

ImproveStep ImproveRecord::step() {
    FOREFRONT_ASSERT(position_ > 0);
    const std::size_t number = position_;
    const Delta &delta = deltas_[steps_[number - 1]];
    moveTo(number - 1);
    ImproveStep step;
    step.change = delta.change;
    step.number = number;
    step.before = figures();
    moveToDelta(steps_[number - 1] + 1);
    step.after = figures();
    if (delta.change != ImproveChange::Remainder) {
        listMoves(delta, step);
        listElements(delta, step);
    }
    moveTo(number);
    if (done_ > steps_[number - 1] + 1) {
        renumberMoves(step);
    }
    return step;
}

} // namespace forefront
