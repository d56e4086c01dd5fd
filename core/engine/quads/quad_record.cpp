#include "core/engine/quads/quad_record.hpp"

#include "core/engine/base/assert.hpp"

#include <algorithm>
#include <bit>
#include <iterator>
#include <utility>

namespace forefront {

namespace {

bool equalBits(Vec2 p, Vec2 q) {
    return std::bit_cast<std::uint64_t>(p.x) == std::bit_cast<std::uint64_t>(q.x) &&
           std::bit_cast<std::uint64_t>(p.y) == std::bit_cast<std::uint64_t>(q.y);
}

/// Returns the part of the work that a change belongs to: changes of one part that follow each other make a pass.
ImproveChange partOf(ImproveChange change) {
    switch (change) {
    case ImproveChange::Collapse:
    case ImproveChange::Rotate:
    case ImproveChange::Split:
    case ImproveChange::Doublet:
    case ImproveChange::Raise:
    case ImproveChange::Insert:
    case ImproveChange::Inset:
        return ImproveChange::Pass;
    default:
        return change;
    }
}

using Edge = std::array<std::uint32_t, 2>;

/// The edges and corners of some elements, ascending.
struct CellOutline {
    std::vector<std::uint32_t> corners; ///< a node once for each element
    std::vector<Edge> edges;            ///< the lower node first, each once

    void add(const QuadCell &cell) {
        for (unsigned k = 0; isAlive(cell) && k < cornersOf(cell); ++k) {
            corners.push_back(cell[k]);
            edges.push_back({std::min(cell[k], nextCorner(cell, k)), std::max(cell[k], nextCorner(cell, k))});
        }
    }
    void sort() {
        std::ranges::sort(corners);
        std::ranges::sort(edges);
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    }
    std::vector<Edge> without(const CellOutline &other) const {
        std::vector<Edge> rest;
        std::ranges::set_difference(edges, other.edges, std::back_inserter(rest));
        return rest;
    }
    template <class Visit>
    void forEachNode(const Visit &visit) const {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if (i == 0 || corners[i] != corners[i - 1]) {
                visit(corners[i]);
            }
        }
    }
};

std::uint32_t numberOf(const std::vector<std::uint32_t> &numbers, std::uint32_t node) {
    return node < numbers.size() ? numbers[node] : kNoIndex;
}

StepElement elementOf(const QuadCell &cell, std::span<const Vec2> nodes) {
    StepElement element;
    element.count = cornersOf(cell);
    for (unsigned k = 0; k < element.count; ++k) {
        element.at[k] = nodes[cell[k]];
    }
    return element;
}

/// Returns the number of elements around each node.
std::vector<std::uint32_t> valences(const CellView &view) {
    std::vector<std::uint32_t> counts(view.nodes.size(), 0);
    for (const QuadCell &cell : view.cells) {
        for (unsigned k = 0; isAlive(cell) && k < cornersOf(cell); ++k) {
            ++counts[cell[k]];
        }
    }
    return counts;
}

std::vector<std::array<Vec2, 2>> placesOf(const std::vector<Edge> &edges, std::span<const Vec2> nodes) {
    std::vector<std::array<Vec2, 2>> places;
    places.reserve(edges.size());
    for (const auto &[a, b] : edges) {
        places.push_back({nodes[a], nodes[b]});
    }
    return places;
}

} // namespace

QuadRecord::QuadRecord(PairedCells front, const DiscreteDomain &boundary, Detail detail, std::size_t maxBytes)
    : front_(std::move(front)), boundary_(boundary), detail_(detail), maxBytes_(maxBytes) {}

void QuadRecord::begin(const QuadWorkspace &mesh) {
    nodes_ = mesh.nodes;
    cells_ = mesh.cells;
    faces_ = mesh.faces;
    isFixed_.resize(nodes_.size());
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
        isFixed_[n] = mesh.isFixed(n) ? 1 : 0;
    }
    pairStep_ = pairStep();
    front_ = {};
}

/// Returns what joining the last triangles has changed: the elements that the front does not have.
ImproveStep QuadRecord::pairStep() const {
    ImproveStep step;
    step.change = ImproveChange::Pair;
    step.number = 1;
    step.quads = true;
    const auto sorted = [](const std::vector<QuadCell> &cells) {
        std::vector<QuadCell> all = cells;
        for (QuadCell &cell : all) { // from the lowest node on
            std::rotate(cell.begin(), std::min_element(cell.begin(), cell.begin() + cornersOf(cell)),
                        cell.begin() + cornersOf(cell));
        }
        std::ranges::sort(all);
        return all;
    };
    const std::vector<QuadCell> before = sorted(front_.cells), after = sorted(cells_);
    std::vector<QuadCell> gone, made;
    std::ranges::set_difference(before, after, std::back_inserter(gone));
    std::ranges::set_difference(after, before, std::back_inserter(made));
    CellOutline old, now;
    std::ranges::for_each(gone, [&](const QuadCell &cell) { old.add(cell); });
    for (const QuadCell &cell : made) {
        now.add(cell);
        step.elements.push_back(elementOf(cell, nodes_));
    }
    old.sort();
    now.sort();
    step.removedEdges = placesOf(old.without(now), front_.nodes);
    step.addedEdges = placesOf(now.without(old), nodes_);
    for (std::size_t n = front_.nodes.size(); n < nodes_.size(); ++n) {
        step.addedNodes.push_back(nodes_[n]);
    }
    step.quadsBefore = figuresOf({front_.nodes, front_.cells, {}});
    step.quadsAfter = figures();
    return step;
}

void QuadRecord::compareNode(Delta &delta, std::size_t n, const QuadWorkspace &mesh) const {
    const Vec2 before = n < nodes_.size() ? nodes_[n] : Vec2{}, after = n < mesh.nodes.size() ? mesh.nodes[n] : Vec2{};
    // Places of nodes without an element are left over from trials.
    const bool unused = n < mesh.nodes.size() && mesh.valence(static_cast<std::uint32_t>(n)) == 0;
    if (!unused && !equalBits(before, after)) {
        delta.nodes.push_back({static_cast<std::uint32_t>(n), before, after});
    }
}

void QuadRecord::compareCell(Delta &delta, std::size_t c, const QuadWorkspace &mesh) const {
    const QuadCell before = c < cells_.size() ? cells_[c] : kNoCell;
    const QuadCell after = c < mesh.cells.size() ? mesh.cells[c] : kNoCell;
    const std::uint32_t faceBefore = c < faces_.size() ? faces_[c] : 0;
    const std::uint32_t faceAfter = c < mesh.faces.size() ? mesh.faces[c] : 0;
    if (before != after || (isAlive(after) && faceBefore != faceAfter)) {
        delta.cells.push_back({static_cast<std::uint32_t>(c), before, after, faceBefore, faceAfter});
    }
}

QuadRecord::Delta QuadRecord::differenceTo(const QuadWorkspace &mesh, const ChangedCells &parts) const {
    Delta delta;
    delta.refused = parts.refused;
    delta.nodesBefore = nodes_.size();
    delta.nodesAfter = mesh.nodes.size();
    delta.cellsBefore = cells_.size();
    delta.cellsAfter = mesh.cells.size();
    if (parts.all) {
        for (std::size_t n = 0; n < std::max(delta.nodesBefore, delta.nodesAfter); ++n) {
            compareNode(delta, n, mesh);
        }
        for (std::size_t c = 0; c < std::max(delta.cellsBefore, delta.cellsAfter); ++c) {
            compareCell(delta, c, mesh);
        }
        return delta;
    }
    const auto ordered = [](std::span<const std::uint32_t> list) {
        std::vector<std::uint32_t> sorted(list.begin(), list.end());
        std::ranges::sort(sorted);
        sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
        return sorted;
    };
    for (const std::uint32_t n : ordered(parts.nodes)) {
        compareNode(delta, n, mesh);
    }
    for (const std::uint32_t c : ordered(parts.cells)) {
        compareCell(delta, c, mesh);
    }
    return delta;
}

void QuadRecord::changed(ImproveChange change, const QuadWorkspace &mesh, const ChangedCells &parts) {
    if (change == ImproveChange::Pair) {
        begin(mesh);
        return;
    }
    if ((full_ && change != ImproveChange::Remainder) || (detail_ == Detail::Passes && !parts.all)) {
        return;
    }
    Delta delta = differenceTo(mesh, parts);
    delta.change = change;
    if (!delta.nodes.empty() || !delta.cells.empty()) {
        keep(std::move(delta));
    }
}

void QuadRecord::keep(Delta delta) {
    bytes_ += delta.bytes();
    full_ = full_ || bytes_ > maxBytes_;
    apply(delta, true);
    deltas_.push_back(std::move(delta));
    done_ = deltas_.size();
}

void QuadRecord::apply(const Delta &delta, bool forward) {
    nodes_.resize(std::max(delta.nodesBefore, delta.nodesAfter));
    cells_.resize(std::max(delta.cellsBefore, delta.cellsAfter), kNoCell);
    const bool hasFaces = !faces_.empty();
    faces_.resize(hasFaces ? cells_.size() : 0, 0);
    for (const NodeChange &node : delta.nodes) {
        nodes_[node.at] = forward ? node.after : node.before;
    }
    for (const CellChange &cell : delta.cells) {
        cells_[cell.at] = forward ? cell.after : cell.before;
        if (hasFaces) {
            faces_[cell.at] = forward ? cell.faceAfter : cell.faceBefore;
        }
    }
    nodes_.resize(forward ? delta.nodesAfter : delta.nodesBefore);
    cells_.resize(forward ? delta.cellsAfter : delta.cellsBefore);
    faces_.resize(hasFaces ? cells_.size() : 0);
}

std::vector<std::size_t> QuadRecord::passEnds() const {
    std::vector<std::size_t> ends{1};
    for (std::size_t i = 0; i < deltas_.size(); ++i) {
        if (i > 0 && partOf(deltas_[i].change) == partOf(deltas_[i - 1].change)) {
            ends.pop_back();
        }
        ends.push_back(i + 2);
    }
    return ends;
}

void QuadRecord::moveTo(std::size_t step) {
    FOREFRONT_ASSERT(step >= 1 && step <= steps());
    while (done_ + 1 < step) {
        apply(deltas_[done_++], true);
    }
    while (done_ + 1 > step) {
        apply(deltas_[--done_], false);
    }
}

std::size_t QuadRecord::elements() const {
    return static_cast<std::size_t>(std::ranges::count_if(cells_, isAlive));
}

QuadFigures QuadRecord::figuresOf(const CellView &view) const {
    QuadFigures figures;
    double sum = 0.0;
    std::size_t count = 0;
    for (const QuadCell &cell : view.cells) {
        if (isAlive(cell)) {
            const double shape = scaledJacobian(cell, view.nodes);
            figures.jacobianMin = count == 0 ? shape : std::min(figures.jacobianMin, shape);
            sum += shape;
            ++count;
        }
    }
    figures.jacobianMean = count == 0 ? 0.0 : sum / static_cast<double>(count);
    const std::vector<std::uint32_t> counts = valences(view);
    for (std::size_t n = 0; n < counts.size(); ++n) {
        const bool isFree = n >= isFixed_.size() || isFixed_[n] == 0;
        figures.irregular += isFree && counts[n] > 0 && counts[n] != 4 ? 1U : 0U;
    }
    return figures;
}

/// Lists the nodes that stay and move. `before`, `after`: the numbers of nodes in the meshes before and after the step.
void QuadRecord::listMoves(const Delta &delta, const Numbers &before, const Numbers &after, ImproveStep &step) {
    for (const NodeChange &node : delta.nodes) {
        if (numberOf(before, node.at) != kNoIndex && numberOf(after, node.at) != kNoIndex) {
            step.moves.push_back({NodeId{after[node.at]}, node.before, node.after});
        }
    }
}

/// Lists the elements, edges and nodes that come and go.
void QuadRecord::listElements(const Delta &delta, const Numbers &numbersBefore, const Numbers &numbersAfter,
                              ImproveStep &step) const {
    std::vector<Vec2> before = nodes_; // the places before the step
    before.resize(std::max(delta.nodesBefore, delta.nodesAfter));
    for (const NodeChange &node : delta.nodes) {
        before[node.at] = node.before;
    }
    CellOutline old, made;
    for (const CellChange &cell : delta.cells) {
        old.add(cell.before);
        made.add(cell.after);
        if (isAlive(cell.after)) {
            step.elements.push_back(elementOf(cell.after, nodes_));
        }
    }
    old.sort();
    made.sort();
    step.removedEdges = placesOf(old.without(made), before);
    step.addedEdges = placesOf(made.without(old), nodes_);
    old.forEachNode([&](std::uint32_t n) {
        if (numberOf(numbersAfter, n) == kNoIndex) {
            step.removedNodes.push_back(before[n]);
        }
    });
    made.forEachNode([&](std::uint32_t n) {
        if (numberOf(numbersBefore, n) == kNoIndex) {
            step.addedNodes.push_back(nodes_[n]);
        }
    });
}

ImproveStep QuadRecord::step() {
    const std::size_t number = position();
    if (number == 1) {
        return pairStep_;
    }
    const Delta &delta = deltas_[number - 2];
    ImproveStep step;
    step.change = delta.change;
    step.number = number;
    step.quads = true;
    step.refused = delta.refused;
    moveTo(number - 1);
    step.quadsBefore = figures();
    const Numbers before = numbersInMesh(view(), boundary_.nodes.size());
    moveTo(number);
    step.quadsAfter = figures();
    if (delta.change != ImproveChange::Remainder) {
        const Numbers after = numbersInMesh(view(), boundary_.nodes.size());
        listElements(delta, before, after, step);
        listMoves(delta, before, after, step);
    }
    return step;
}

} // namespace forefront
