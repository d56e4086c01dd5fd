#pragma once

#include "core/engine/mesher/fan.hpp"
#include "core/engine/mesher/front_update.hpp"
#include "core/engine/quads/coloured_search.hpp"
#include "core/engine/quads/even_boundary.hpp"
#include "core/engine/quads/front_layers.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// How the elements of a two-coloured front were made.
struct ColouredWork {
    std::uint64_t rows = 0;     ///< squares that continue a row, with one new node
    std::uint64_t openings = 0; ///< squares that start a row, with two new nodes
    std::uint64_t closings = 0; ///< squares without a new node
    std::uint64_t searched = 0; ///< triangles found by the search
    std::uint64_t forced = 0;   ///< triangles made of existing nodes because no other choice was left

    friend bool operator==(const ColouredWork &, const ColouredWork &) = default;
};

/// The two-coloured front: an advancing front whose triangles are halves of squares. Nodes have two colours; all edges
/// of the boundary join different ones. A triangle has two sides between different colours, its legs, and one between
/// equal colours, its diagonal. Dropping the diagonals joins triangles to quadrilaterals.
///
/// A base makes a whole square where that is simple: it continues a row at a corner of Γ of about 90 degrees, starts a
/// row on both sides of which Γ is straight, or closes a gap one square wide. Everything else goes through a search
/// like the ten steps of the classic method, with its guarantee that the front closes: new nodes keep their distance
/// from Γ, and those closer than the node spacing allows are limited in number.
template <class Grid>
class ColouredFront {
  public:
    /// Refers to the boundary and the spacing. `rows`: see FrontLayers.
    ColouredFront(const ColouredBoundary &boundary, const SpacingField &spacing, Grid grid, std::uint32_t rows);
    ColouredFront(const ColouredFront &) = delete; // its parts refer to its state
    ColouredFront &operator=(const ColouredFront &) = delete;

    /// Makes one to two elements, or defers a base. Returns false when Γ = ∅.
    bool advance();

    const FrontState &state() const { return state_; }
    FrontState &state() { return state_; }
    std::vector<std::uint8_t> &colours() { return colours_; }
    const ColouredWork &work() const { return work_; }

  private:
    bool isLegAt(SlotId id) const { return isLeg(state_.front, colours_, id); }
    bool trySquare(SlotId id);
    bool tryRow(SlotId first);
    bool placeInRow(Fan &fan, double &size) const;
    bool tryOpening(SlotId id);
    bool tryClosing(SlotId id);
    bool isClear(Fan &fan, double size);
    bool tooSmall(double size, Vec2 at) const { return size < kSmallNode * spacing_.at(at); }
    void addTriangle(const Base &base, Candidate apex, std::uint8_t colour, bool forced);
    void made(const AdvanceDelta &delta, std::uint32_t layer, std::size_t segments);
    void setOpposite(SlotId id, NodeId node);

    const SpacingField &spacing_;
    FrontState state_;
    Grid grid_;
    NoTrace trace_;
    FanBuilder<Grid, NoTrace> fans_;
    FrontUpdate<Grid> update_;
    std::vector<std::uint8_t> colours_; ///< per node
    std::vector<NodeId> opposite_;      ///< per slot: the third node of the element behind its segment
    ColouredSearch<Grid> search_;
    FrontLayers layers_;
    SearchWork tested_;
    ColouredWork work_;
    std::uint32_t layer_ = 0; ///< of the current base
};

} // namespace forefront
