#pragma once

#include "core/engine/quads/coloured_candidate.hpp"
#include "core/engine/quads/square_trace.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace forefront {

/// A segment of Γ joins two colours (a leg of half a square) or is the diagonal that two halves share.
inline bool isLeg(const GenerationFront &front, const std::vector<std::uint8_t> &colours, SlotId id) {
    return colours[index(front[id].node)] != colours[index(front[front.next(id)].node)];
}

/// Returns the free angle at a slot in radians, in (0, 2π].
double freeAngle(const GenerationFront &front, SlotId id);
/// Returns the unit vector along the first of the parts that the free angle at a slot has if it is divided into about
/// right angles. `beside`: the outgoing segment (true) or the incoming one.
Vec2 sideDirection(const GenerationFront &front, SlotId id, bool besideOutgoing);

/// Finds the apex for a base of the two-coloured front: the right angle of half a square over a leg, or the second half
/// of one over a diagonal. Changes only its own scratch memory.
template <class Grid, class Trace>
class ColouredSearch {
  public:
    /// Refers to all of its arguments. `colours`: per node. `opposite`: per slot, the third node of the element that
    /// made its segment. `fixed`: the number of nodes of the boundary, which come first.
    ColouredSearch(const FrontState &state, const Grid &grid, const SpacingField &spacing, Trace &trace,
                   const std::vector<std::uint8_t> &colours, const std::vector<NodeId> &opposite, std::size_t fixed)
        : state_(state), grid_(grid), spacing_(spacing), trace_(trace), colours_(colours), opposite_(opposite),
          fixed_(fixed) {}

    /// Evaluates ρ at the base and finds the best apex within `radius` node spacings, new or on Γ. Returns false if
    /// there is none.
    bool find(Base &base, double radius, ColouredCandidate &apex, SearchWork &work);
    /// Finds an apex among existing nodes alone, of any colour; doubles the radius until one passes, which cannot fail.
    void force(Base &base, double radius, ColouredCandidate &apex, SearchWork &work);
    /// Returns a node that exists as an apex for a base with the spacing `rho`.
    ColouredCandidate existing(Base base, double rho, NodeId node, Vec2 at) const;

  private:
    using Neighbour = NearSegment;
    struct Ideal {
        Vec2 at;
        std::uint8_t colour;
    };

    std::uint8_t colour(NodeId node) const { return colours_[index(node)]; }
    void placeIdeals(Base &base);
    struct Limits {
        double radius;
        bool newNodes;
        bool flat;
    };
    void gather(const Box2 &box, SearchWork &work);
    bool look(const Base &base, const Limits &limits, ColouredCandidate &apex, SearchWork &work);
    void propose(const Base &base, const Limits &limits);
    std::optional<Obstacle> obstacle(const Base &base, Vec2 p) const;
    bool flattensCorner(const Base &base, const Neighbour &n) const;
    ColouredScore score(const Base &base, Vec2 p, std::uint8_t colour) const;
    ColouredCandidate candidate(const Base &base, const Neighbour &n) const;
    Verdict test(const Base &base, const Candidate &apex, bool flat, SearchWork &work);
    bool containsNode(const Base &base, const Candidate &apex, bool flat);

    const FrontState &state_;
    const Grid &grid_;
    const SpacingField &spacing_;
    Trace &trace_;
    const std::vector<std::uint8_t> &colours_;
    const std::vector<NodeId> &opposite_;
    std::size_t fixed_;
    std::vector<Ideal> ideals_;
    std::vector<std::uint32_t> stamps_; ///< per slot: search in which it was last delivered
    std::uint32_t stamp_ = 0;
    std::vector<SlotId> found_;
    std::vector<Neighbour> neighbours_; ///< by slot
    std::vector<ColouredCandidate> candidates_;
};

} // namespace forefront
