#include "core/engine/session/breakpoint_watch.hpp"

#include "core/engine/geometry/polygon.hpp"
#include "core/engine/geometry/predicates.hpp"
#include "core/engine/mesh/quality.hpp"

#include <algorithm>
#include <limits>

namespace forefront {

const char *stopTitle(StopKind kind) {
    switch (kind) {
    case StopKind::Rejection:
        return "A candidate is rejected";
    case StopKind::Deferral:
        return "A base is deferred";
    case StopKind::Forced:
        return "An element is forced";
    case StopKind::Join:
        return "Two fronts join";
    case StopKind::Split:
        return "A front splits in two";
    case StopKind::Closure:
        return "A front closes";
    case StopKind::LowAlpha:
        return "\xce\xb1 of an element is below";
    case StopKind::FrontLength:
        return "Segments on the front reach";
    case StopKind::Place:
        return "An element covers the point";
    case StopKind::Cell:
        return "The grid cell is visited";
    }
    return "";
}

bool Breakpoints::any() const {
    return std::find(enabled.begin(), enabled.end(), true) != enabled.end();
}

namespace {

using Corners = std::array<Vec2, 3>;

Corners cornersOf(const FrontState &state, std::size_t element) {
    const Element &n = state.elements[element];
    return {state.nodes[index(n[0])], state.nodes[index(n[1])], state.nodes[index(n[2])]};
}

bool covers(const Corners &corners, Vec2 place) {
    return orientation(corners[0], corners[1], place) >= 0 && orientation(corners[1], corners[2], place) >= 0 &&
           orientation(corners[2], corners[0], place) >= 0;
}

bool isWithin(const Box2 &outer, const Box2 &inner) {
    return outer.contains(inner.min) && outer.contains(inner.max);
}

/// The state of a run after one of its advances.
class LastAdvance {
  public:
    explicit LastAdvance(Timeline &timeline)
        : timeline_(timeline), state_(timeline.mesher().state()), delta_(timeline.delta(timeline.position() - 1)) {}

    std::optional<Stop> fulfils(StopKind kind, const Breakpoints &breakpoints) {
        const auto when = [kind](bool condition, double value = 0.0) {
            return condition ? std::optional(Stop{kind, value}) : std::nullopt;
        };
        switch (kind) {
        case StopKind::Rejection:
            return when(delta_.rejected > 0, delta_.rejected);
        case StopKind::Deferral:
            return when(delta_.kind == AdvanceDelta::Kind::Deferral);
        case StopKind::Forced:
            return when(delta_.forced);
        case StopKind::Join:
            return when(connects() && joined());
        case StopKind::Split:
            return when(connects() && !joined());
        case StopKind::Closure:
            return when(delta_.kind == AdvanceDelta::Kind::Loop);
        case StopKind::LowAlpha: {
            const double alpha = minAlpha();
            return when(alpha < breakpoints.alphaBelow, alpha);
        }
        case StopKind::FrontLength:
            return when(crossed(breakpoints.segments), static_cast<double>(state_.front.segments()));
        case StopKind::Place:
            return when(breakpoints.place && coversPlace(*breakpoints.place));
        case StopKind::Cell:
            return when(breakpoints.cell && visited(*breakpoints.cell));
        }
        return std::nullopt;
    }

  private:
    std::size_t firstElement() const { return state_.elements.size() - delta_.elements(); }

    /// Returns true if the advance connected two places of Γ, neither of them an isolated point.
    bool connects() const { return delta_.kind == AdvanceDelta::Kind::Connection && delta_.s != delta_.t; }

    /// Returns true if a connection merged two loops into one: both of its new segments lie on the same loop now.
    bool joined() const {
        const GenerationFront &front = state_.front;
        for (SlotId id = front.next(delta_.a); id != delta_.a; id = front.next(id)) {
            if (id == delta_.t) {
                return true;
            }
        }
        return false;
    }

    double minAlpha() const {
        double alpha = std::numeric_limits<double>::infinity();
        for (std::size_t e = firstElement(); e < state_.elements.size(); ++e) {
            const Corners corners = cornersOf(state_, e);
            alpha = std::min(alpha, shapeFactor(corners[0], corners[1], corners[2]));
        }
        return alpha;
    }

    bool crossed(std::size_t segments) const {
        const auto limit = static_cast<std::int64_t>(segments);
        const auto now = static_cast<std::int64_t>(state_.front.segments());
        return (now - delta_.growth() < limit) != (now < limit);
    }

    bool coversPlace(Vec2 place) const {
        for (std::size_t e = firstElement(); e < state_.elements.size(); ++e) {
            if (covers(cornersOf(state_, e), place)) {
                return true;
            }
        }
        return false;
    }

    /// Repeats the advance with recording if its search may have reached the cell.
    bool visited(const Box2 &cell) {
        if (delta_.cells == 0 || !mayReach(cell)) {
            return false;
        }
        timeline_.back(1);
        const AdvanceExplanation explanation = timeline_.mesher().explainNext();
        timeline_.forward(1);
        return std::any_of(explanation.cells.begin(), explanation.cells.end(),
                           [&](const Box2 &box) { return isWithin(cell, box); });
    }

    /// Returns true if the cell is near the elements made. A search radius is at most 1.75 spacings, and a spacing at
    /// most twice the base.
    bool mayReach(const Box2 &cell) const {
        if (delta_.elements() == 0 || delta_.forced) {
            return true;
        }
        Box2 made;
        for (std::size_t e = firstElement(); e < state_.elements.size(); ++e) {
            for (const Vec2 corner : cornersOf(state_, e)) {
                made.add(corner);
            }
        }
        return made.grown(8.0 * made.diagonal()).overlaps(cell);
    }

    Timeline &timeline_;
    const FrontState &state_;
    const AdvanceDelta &delta_;
};

/// Returns the advance, counted from 1, that made an element.
std::uint64_t advanceOf(const Timeline &timeline, std::size_t element) {
    std::size_t made = 0;
    for (std::uint64_t p = 0; p < timeline.position(); ++p) {
        made += timeline.delta(p).elements();
        if (made > element) {
            return p + 1;
        }
    }
    return timeline.position();
}

/// The parts of elements near a place: the distance of each, and the element it was first seen in.
class BirthSearch {
  public:
    /// `colours`: of the nodes of a two-coloured front, whose edges between equal colours are diagonals of squares and
    /// no edges of the mesh; null: it has none.
    BirthSearch(const FrontState &state, const std::vector<std::uint8_t> *colours, Vec2 place, double tolerance)
        : state_(state), colours_(colours), place_(place), edgeDistance_(tolerance), nodeDistance_(tolerance),
          reach_(boxAround(place, tolerance)) {}

    std::optional<Birth> find() {
        for (std::size_t e = 0; e < state_.elements.size(); ++e) {
            look(e);
        }
        return node_ ? node_ : edge_ ? edge_ : element_;
    }

  private:
    void look(std::size_t e) {
        const Element &nodes = state_.elements[e];
        const Corners corners = cornersOf(state_, e);
        Box2 box = boxOf(corners[0], corners[1]);
        box.add(corners[2]);
        if (!box.overlaps(reach_)) {
            return;
        }
        const ElementId id{static_cast<std::uint32_t>(e)};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            if (const double d = distance(corners[k], place_); d < nodeDistance_) {
                nodeDistance_ = d;
                node_ = Birth{Birth::Kind::Node, nodes[k], kNoNode, id, 0};
            }
            if (const double d = distanceToSegment(corners[k], corners[next], place_);
                d < edgeDistance_ && !isDiagonal(nodes[k], nodes[next])) {
                edgeDistance_ = d;
                edge_ = Birth{Birth::Kind::Edge, nodes[k], nodes[next], id, 0};
            }
        }
        if (!element_ && covers(corners, place_)) {
            element_ = Birth{Birth::Kind::Triangle, kNoNode, kNoNode, id, 0};
        }
    }

    bool isDiagonal(NodeId a, NodeId b) const {
        return colours_ != nullptr && (*colours_)[index(a)] == (*colours_)[index(b)];
    }

    const FrontState &state_;
    const std::vector<std::uint8_t> *colours_;
    Vec2 place_;
    double edgeDistance_, nodeDistance_; ///< of those found, at first the tolerance
    Box2 reach_;
    std::optional<Birth> node_, edge_, element_;
};

} // namespace

std::optional<Stop> stopAfterLast(const Breakpoints &breakpoints, Timeline &timeline) {
    if (timeline.position() == 0) {
        return std::nullopt;
    }
    LastAdvance last(timeline);
    for (std::size_t k = 0; k < kStopKinds; ++k) {
        if (breakpoints.enabled[k]) {
            if (const std::optional<Stop> stop = last.fulfils(static_cast<StopKind>(k), breakpoints)) {
                return stop;
            }
        }
    }
    return std::nullopt;
}

std::optional<Birth> birthAt(const Timeline &timeline, Vec2 place, double tolerance) {
    const Mesher &mesher = timeline.mesher();
    std::optional<Birth> birth = BirthSearch(mesher.state(), mesher.colours(), place, tolerance).find();
    if (birth) {
        birth->advance = advanceOf(timeline, index(birth->element));
        if (mesher.colours() != nullptr) {
            birth->element = kNoElement; // the mesh numbers squares, not their halves
        }
    }
    return birth;
}

bool unmeshed(const GenerationFront &front, Vec2 place) {
    bool inside = false;
    front.forEachSlot([&](SlotId id) { // isolated points have no length, so that the ray never meets them
        const Vec2 a = front.start(id), b = front.end(id);
        if ((a.y > place.y) != (b.y > place.y)) { // the ray to the right of the place
            const int side = orientation(a, b, place);
            inside = inside != ((b.y > a.y) == (side > 0));
        }
    });
    return inside;
}

} // namespace forefront
