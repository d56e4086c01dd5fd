#include "core/engine/mesh/second_order.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/geometry/half_length.hpp"
#include "core/engine/mesh/edge_table.hpp"
#include "core/engine/mesh/even_jacobians.hpp"
#include "core/engine/mesh/jacobian.hpp"
#include "core/engine/mesh/outer_bulges.hpp"
#include "core/engine/mesh/placed_cell.hpp"
#include "core/engine/mesh/uneven_elements.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

namespace {

constexpr const char *kOrderStage = "adding nodes in the middles of edges";
constexpr std::size_t kEdgesPerReport = 4096;

CellKind secondOrderOf(CellKind kind, QuadNodes quadNodes) {
    if (kind == CellKind::Triangle3) {
        return CellKind::Triangle6;
    }
    return quadNodes == QuadNodes::Eight ? CellKind::Quadrilateral8 : CellKind::Quadrilateral9;
}

/// The corners of a mesh and the places of the middle nodes of its edges, from which elements of second order are made.
class MiddlePlaces {
  public:
    explicit MiddlePlaces(Mesh &mesh) : mesh_(mesh), view_(mesh), table_(view_) {
        ofSide_.resize(table_.halfEdges().count());
        table_.forEach([&](NodeId a, NodeId b, std::span<const HalfEdge> sides) {
            for (const HalfEdge side : sides) {
                ofSide_[side] = static_cast<std::uint32_t>(places_.size());
            }
            places_.push_back(midpoint(mesh.nodes[index(a)], mesh.nodes[index(b)]));
        });
    }

    /// Moves the middles of edges along curves onto them. `chords`: as in OrderRequest.
    bool bend(std::span<const std::size_t> chords, SecondOrderReport &report, const Progress &progress) {
        std::vector<bool> isChord(mesh_.edges.size(), false);
        for (const std::size_t edge : chords) {
            isChord[edge] = true;
        }
        for (std::size_t i = 0; i < mesh_.edges.size(); ++i) {
            if (i % kEdgesPerReport == 0) {
                progress(kOrderStage, static_cast<double>(i) / static_cast<double>(mesh_.edges.size()));
                if (progress.cancelled()) {
                    return false;
                }
            }
            const TaggedEdge &edge = mesh_.edges[i];
            const std::span<const HalfEdge> sides = table_.find(edge.a, edge.b);
            if (sides.empty()) {
                continue;
            }
            if (isChord[i]) {
                addStraight(ofSide_[sides[0]], StraightReason::Crossing, report);
            } else if (!mesh_.edgeStretches.empty() && isAlong(mesh_.edgeStretches[i], edge)) {
                bendEdge(ofSide_[sides[0]], edge, mesh_.edgeStretches[i], sides);
            }
        }
        return true;
    }

    /// Moves corners where Jacobian determinants vary too much. Returns false if it was cancelled.
    bool even(const std::vector<bool> &movable, SecondOrderReport &report, const Progress &progress) {
        std::vector<bool> curved(places_.size(), false);
        for (const BentEdge &edge : bent_) {
            curved[edge.middle] = true;
        }
        moved_ = evenJacobians({mesh_, table_, ofSide_, places_, curved}, movable, progress);
        report.movedCorners = moved_.size();
        return !progress.cancelled();
    }

    /// Moves corners back to where they were.
    void undoMoves() {
        for (const MovedCorner &corner : moved_) {
            mesh_.nodes[index(corner.node)] = corner.from;
        }
    }

    /// Straightens edges until all elements are valid and no edge meets another across the outside.
    bool straighten(SecondOrderReport &report, const Progress &progress) {
        std::sort(bentOfSide_.begin(), bentOfSide_.end());
        std::vector<std::uint32_t> open; // the elements to check
        for (const BentEdge &edge : bent_) {
            open.insert(open.end(), edge.elements.begin(), edge.elements.begin() + edge.elementCount);
        }
        std::vector<std::uint32_t> meeting;
        do {
            while (!open.empty()) {
                std::vector<std::uint32_t> folding;
                if (!findFolding(open, folding, progress)) {
                    return false;
                }
                open.clear();
                makeStraight(folding, StraightReason::Folded, open, report);
            }
            meeting = findMeeting();
            makeStraight(meeting, StraightReason::Meeting, open, report);
        } while (!meeting.empty());
        report.curvedEdges = static_cast<std::size_t>(
            std::count_if(bent_.begin(), bent_.end(), [](const BentEdge &edge) { return edge.height > 0.0; }));
        return true;
    }

    /// Returns the number of the middle node of a tagged edge, or kNoNode if it is no edge of an element.
    NodeId middleOf(const TaggedEdge &edge) const {
        const std::span<const HalfEdge> sides = table_.find(edge.a, edge.b);
        return sides.empty() ? kNoNode : nodeOf(ofSide_[sides[0]]);
    }

    /// Returns the blocks of second order, with nodes in the centres of quadrilaterals after all others if they have
    /// them.
    std::vector<CellBlock> blocks(QuadNodes quadNodes) const {
        std::vector<CellBlock> blocks;
        auto next = static_cast<std::uint32_t>(mesh_.nodes.size() + places_.size());
        std::size_t element = 0;
        for (const CellBlock &given : mesh_.blocks) {
            CellBlock block(secondOrderOf(given.kind(), quadNodes));
            block.reserve(given.size());
            block.regions = given.regions;
            for (std::size_t k = 0; k < given.size(); ++k, ++element) {
                std::array<NodeId, kMaxCellNodes> nodes{};
                const std::size_t corners = given.traits().corners;
                std::copy_n(given.nodesOf(k).begin(), corners, nodes.begin());
                for (std::size_t side = 0; side < corners; ++side) {
                    nodes[corners + side] = nodeOf(ofSide_[table_.halfEdges().of(element, side)]);
                }
                if (block.kind() == CellKind::Quadrilateral9) {
                    nodes[8] = NodeId{next++};
                }
                block.add(std::span(nodes).first(block.traits().nodes));
            }
            blocks.push_back(std::move(block));
        }
        return blocks;
    }

    /// Returns the places of the middles of all edges, then those of the centres for blocks().
    std::vector<Vec2> takePlaces(QuadNodes quadNodes) {
        if (quadNodes == QuadNodes::Nine) {
            std::vector<Vec2> centres;
            for (std::size_t e = 0; e < view_.elementCount(); ++e) {
                if (const PlacedCell cell = placed(e); cell.kind == CellKind::Quadrilateral8) {
                    centres.push_back(cell.centre());
                }
            }
            places_.insert(places_.end(), centres.begin(), centres.end());
        }
        return std::move(places_);
    }

  private:
    /// An edge that follows a curve off its chord.
    struct BentEdge {
        std::uint32_t middle = 0; ///< number among the middles
        Vec2 chordMiddle;
        double height = 0.0; ///< of the curve, in lengths of the chord; 0: straightened
        std::array<std::uint32_t, 2> elements{};
        std::size_t elementCount = 0;
    };

    NodeId nodeOf(std::uint32_t middle) const {
        return NodeId{static_cast<std::uint32_t>(mesh_.nodes.size() + middle)};
    }

    void addStraight(std::uint32_t middle, StraightReason reason, SecondOrderReport &report) const {
        report.straight.push_back({nodeOf(middle), places_[middle], reason});
    }

    /// Returns true if an edge follows its stretch: of a curve that bends, and with ends that are near those of the
    /// edge. As in curveChains(), other stretches do not count.
    bool isAlong(const CurveStretch &stretch, const TaggedEdge &edge) const {
        if (stretch.curve >= mesh_.curves.size()) {
            return false; // kNoCurve, too
        }
        const Curve &curve = mesh_.curves[stretch.curve];
        const Vec2 a = mesh_.nodes[index(edge.a)], b = mesh_.nodes[index(edge.b)];
        const auto inRange = [](double t) { return t >= 0.0 && t <= 1.0; };
        if (curve.kind() == CurveKind::Line || !curve.finite() || !inRange(stretch.t0) || !inRange(stretch.t1) ||
            stretch.t0 == stretch.t1) {
            return false;
        }
        const double reach = 0.5 * distance(a, b);
        return distance(curve.point(stretch.t0), a) <= reach && distance(curve.point(stretch.t1), b) <= reach;
    }

    void bendEdge(std::uint32_t middle, const TaggedEdge &tagged, const CurveStretch &stretch,
                  std::span<const HalfEdge> sides) {
        const Curve &curve = mesh_.curves[stretch.curve];
        const Vec2 a = mesh_.nodes[index(tagged.a)], b = mesh_.nodes[index(tagged.b)];
        const Vec2 place = curve.point(halfLength(curve, stretch.t0, stretch.t1));
        if (isMiddleOfChord(a, b, place)) {
            return; // straight, with a middle that does not depend on the rounding of the curve
        }
        BentEdge edge{middle, places_[middle], distance(place, places_[middle]) / distance(a, b), {}, 0};
        for (const HalfEdge side : sides.first(std::min<std::size_t>(sides.size(), edge.elements.size()))) {
            edge.elements[edge.elementCount++] = static_cast<std::uint32_t>(table_.halfEdges().elementOf(side));
            bentOfSide_.emplace_back(side, static_cast<std::uint32_t>(bent_.size()));
        }
        places_[middle] = place;
        bent_.push_back(edge);
    }

    /// Returns an element of second order with 8 nodes at most.
    PlacedCell placed(std::size_t element) const {
        PlacedCell cell(view_, element);
        const std::size_t corners = cell.traits().corners;
        cell.kind = secondOrderOf(cell.kind, QuadNodes::Eight);
        for (std::size_t side = 0; side < corners; ++side) {
            cell.nodes[corners + side] = places_[ofSide_[table_.halfEdges().of(element, side)]];
        }
        return cell;
    }

    /// Finds the edges to straighten so that the elements do not fold.
    bool findFolding(std::vector<std::uint32_t> &elements, std::vector<std::uint32_t> &folding,
                     const Progress &progress) const {
        std::sort(elements.begin(), elements.end());
        elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
        for (std::size_t k = 0; k < elements.size(); ++k) {
            if (k % kEdgesPerReport == 0 && progress.cancelled()) {
                return false;
            }
            if (!isValid(elements[k])) {
                markEdges(elements[k], folding);
            }
        }
        std::sort(folding.begin(), folding.end());
        folding.erase(std::unique(folding.begin(), folding.end()), folding.end());
        return true;
    }

    /// Finds the edges that bulge over others across the outside.
    std::vector<std::uint32_t> findMeeting() const {
        std::vector<OuterEdge> edges;
        std::vector<std::uint32_t> numbers; // of bent edges
        table_.forEach([&](NodeId, NodeId, std::span<const HalfEdge> sides) {
            if (bent_.empty() || sides.size() != 1) {
                return;
            }
            const HalfEdge h = sides[0];
            const Vec2 a = mesh_.nodes[index(table_.halfEdges().startOf(h))],
                       b = mesh_.nodes[index(table_.halfEdges().endOf(h))];
            const std::uint32_t number = bentAt(h);
            const Vec2 middle = number == kNoIndex ? midpoint(a, b) : places_[ofSide_[h]];
            const bool outwards = number != kNoIndex && cross(b - a, middle - a) < 0.0;
            edges.push_back({a, number == kNoIndex ? middle : 2.0 * middle - 0.5 * (a + b), b, outwards});
            numbers.push_back(number);
        });
        std::vector<std::uint32_t> found = meetingBulges(edges);
        for (std::uint32_t &edge : found) {
            edge = numbers[edge];
        }
        return found;
    }

    void makeStraight(const std::vector<std::uint32_t> &numbers, StraightReason reason,
                      std::vector<std::uint32_t> &elements, SecondOrderReport &report) {
        for (const std::uint32_t number : numbers) {
            BentEdge &edge = bent_[number];
            places_[edge.middle] = edge.chordMiddle;
            edge.height = 0.0;
            addStraight(edge.middle, reason, report);
            elements.insert(elements.end(), edge.elements.begin(), edge.elements.begin() + edge.elementCount);
        }
    }

    /// Returns the number of the bent edge of a side, or kNoIndex if it is straight.
    std::uint32_t bentAt(HalfEdge side) const {
        const auto found = std::lower_bound(bentOfSide_.begin(), bentOfSide_.end(), std::pair{side, std::uint32_t{0}});
        const bool bent = found != bentOfSide_.end() && found->first == side && bent_[found->second].height > 0.0;
        return bent ? found->second : kNoIndex;
    }

    bool isValid(std::size_t element) const {
        const PlacedCell cell = placed(element);
        bool convex = true;
        for (std::size_t k = 0; k < cell.corners().size(); ++k) {
            convex = convex && cross(cell.cornerAfter(k) - cell.nodes[k], cell.cornerBefore(k) - cell.nodes[k]) > 0.0;
        }
        // The ratio to an element that is not convex says nothing.
        return !foldIn(cell) && (!convex || leastJacobianRatio(cell) >= kLeastCurvedJacobian);
    }

    /// Adds the bent edges of an element that are the highest.
    void markEdges(std::size_t element, std::vector<std::uint32_t> &marked) const {
        double highest = 0.0;
        std::array<std::uint32_t, kMaxCellCorners> numbers{};
        std::size_t count = 0;
        const unsigned corners = table_.halfEdges().sidesOf(element);
        for (unsigned side = 0; side < corners; ++side) {
            if (const std::uint32_t number = bentAt(table_.halfEdges().of(element, side)); number != kNoIndex) {
                highest = std::max(highest, bent_[number].height);
                numbers[count++] = number;
            }
        }
        for (const std::uint32_t number : std::span(numbers).first(count)) {
            if (bent_[number].height == highest) {
                marked.push_back(number);
            }
        }
    }

    Mesh &mesh_;
    MeshView view_;
    EdgeTable table_;
    std::vector<std::uint32_t> ofSide_; ///< per side of an element, the number of its middle
    std::vector<Vec2> places_;          ///< per middle
    std::vector<BentEdge> bent_;
    std::vector<std::pair<HalfEdge, std::uint32_t>> bentOfSide_; ///< sides of bent edges with the numbers of these
    std::vector<MovedCorner> moved_;
};

} // namespace

bool raiseOrder(Mesh &mesh, const OrderRequest &request, SecondOrderReport &report, const Progress &progress) {
    FOREFRONT_ASSERT(!MeshView(mesh).hasSecondOrder());
    report = {};
    std::vector<CellBlock> blocks;
    {
        MiddlePlaces middles(mesh);
        const bool done = middles.bend(request.chords, report, progress) &&
                          (request.movable == nullptr || middles.even(*request.movable, report, progress)) &&
                          middles.straighten(report, progress);
        if (!done) {
            middles.undoMoves();
            return false;
        }
        blocks = middles.blocks(request.quadNodes);
        for (TaggedEdge &edge : mesh.edges) {
            edge.middle = middles.middleOf(edge);
        }
        const std::vector<Vec2> places = middles.takePlaces(request.quadNodes);
        mesh.nodes.insert(mesh.nodes.end(), places.begin(), places.end());
    }
    mesh.blocks = std::move(blocks);
    std::sort(report.straight.begin(), report.straight.end(),
              [](const StraightEdge &x, const StraightEdge &y) { return x.middle < y.middle; });
    report.uneven = unevenElements(mesh);
    progress(kOrderStage, 1.0);
    return true;
}

} // namespace forefront
