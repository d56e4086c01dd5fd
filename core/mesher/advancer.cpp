#include "core/mesher/advancer.hpp"

#include "core/geometry/predicates.hpp"
#include "core/grid/hierarchical_grid.hpp"
#include "core/grid/no_grid.hpp"
#include "core/grid/uniform_grid.hpp"
#include "core/mesh/quality.hpp"

#include <algorithm>
#include <limits>

namespace forefront {

namespace {

// Clamping of ρ against the length of the base: keeps neighbouring elements within a factor of two.
constexpr double kLeastRho = 0.55;
constexpr double kGreatestRho = 2.0;
constexpr double kLeastHeight = 0.5; ///< of the ideal point, in lengths of the base
// Search radii around the ideal point, in ρ.
constexpr double kFirstRadius = 1.2;
constexpr double kSecondRadius = 1.75;
// The ideal point is withdrawn when a node or a segment of Γ is nearer, in ρ.
constexpr double kNodeClearance = 0.65;
constexpr double kSegmentClearance = 0.5;
/// Below this part of the node spacing a new node counts as small, see FrontState::smallNodesLeft.
constexpr double kSmallNode = 0.5;

double distanceSquaredToSegment(Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 d = b - a;
    const double length2 = lengthSquared(d);
    const double t = length2 > 0.0 ? std::clamp(dot(p - a, d) / length2, 0.0, 1.0) : 0.0;
    return distanceSquared(p, a + t * d);
}

/// True if the closed segments pq and ab have a common point (exact); a may equal b.
bool segmentsMeet(Vec2 p, Vec2 q, Vec2 a, Vec2 b) {
    const int a1 = orientation(p, q, a);
    const int b1 = orientation(p, q, b);
    if (a1 * b1 > 0) {
        return false;
    }
    const int p1 = orientation(a, b, p);
    const int q1 = orientation(a, b, q);
    if (p1 * q1 > 0) {
        return false;
    }
    // Each meets the line of the other. On one line they meet where their boxes do, which the caller has found.
    return true;
}

bool insideOrOn(Vec2 a, Vec2 b, Vec2 c, Vec2 p) {
    return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0;
}

} // namespace

template <class Grid, class Trace>
bool FrontAdvancer<Grid, Trace>::advance(AdvanceDelta &delta) {
    const SlotId slotA = state_.order.take(state_.front);
    if (slotA == kNoSlot) {
        return false;
    }
    const GenerationFront &front = state_.front;
    const SlotId slotB = front.next(slotA);
    Base base{slotA,
              slotB,
              front.start(slotA),
              front.start(slotB),
              front[slotA].node,
              front[slotB].node,
              front[slotA].length,
              0.0,
              0.0,
              {}};
    delta = AdvanceDelta{};
    delta.a = slotA;
    delta.b = slotB;
    delta.markA = front[slotA].mark;
    delivered_ = tested_ = cells_ = ranked_ = 0;
    const std::size_t segments = front.segments();
    if constexpr (Trace::kRecords) {
        trace_.out.advance = state_.work.advances + 1;
        trace_.out.a = base.a;
        trace_.out.b = base.b;
        trace_.out.nodeA = base.nodeA;
        trace_.out.nodeB = base.nodeB;
        trace_.event(Step::TakeBase);
    }
    evaluateSpacing(base);

    Candidate apex;
    const bool secondTime = delta.markA.failureClass > 0;
    bool found = findApex(base, {(secondTime ? kSecondRadius : kFirstRadius) * base.rho, true}, apex);
    if (!found && !secondTime) {
        defer(base, delta);
        delta.kind = AdvanceDelta::Kind::Deferral;
    } else {
        double radius = kSecondRadius * base.rho;
        while (!found) { // ends before the search covers all of Γ: see the class
            radius *= 2.0;
            if constexpr (Trace::kRecords) {
                ++trace_.out.widening;
            }
            found = findApex(base, {radius, false}, apex);
            delta.forced = true;
            FOREFRONT_ASSERT(found || radius < 1e6 * (base.rho + slack_ / std::numeric_limits<double>::epsilon()));
        }
        update(base, apex, delta);
    }
    delta.delivered = delivered_;
    delta.tested = tested_;
    delta.cells = cells_;
    delta.candidates = ranked_;
    count(delta, segments, true);
    return true;
}

/// Steps 3 and 4. ρ at the midpoint of AB and again at the ideal point that follows from it; their mean places the
/// final one.
template <class Grid, class Trace>
void FrontAdvancer<Grid, Trace>::evaluateSpacing(Base &base) {
    const Vec2 middle = midpoint(base.a, base.b);
    const Vec2 normal = (1.0 / base.length) * leftNormal(base.b - base.a);
    const auto clampRho = [&](double rho) {
        return std::clamp(rho, kLeastRho * base.length, kGreatestRho * base.length);
    };
    const auto idealFor = [&](double rho) {
        const double height = std::sqrt(std::max(0.0, rho * rho - 0.25 * base.length * base.length));
        return middle + std::max(height, kLeastHeight * base.length) * normal;
    };
    const double atMiddle = spacing_.at(middle);
    const double atIdeal = spacing_.at(idealFor(clampRho(atMiddle)));
    base.fieldRho = 0.5 * (atMiddle + atIdeal);
    base.rho = clampRho(base.fieldRho);
    base.ideal = idealFor(base.rho);
    if constexpr (Trace::kRecords) {
        trace_.out.rho = base.rho;
        trace_.out.ideal = base.ideal;
        trace_.event(Step::EvaluateSpacing);
        trace_.event(Step::IdealPoint);
    }
}

/// Steps 5 to 8 for one search radius.
template <class Grid, class Trace>
bool FrontAdvancer<Grid, Trace>::findApex(const Base &base, const Limits &limits, Candidate &apex) {
    Box2 box = boxAround(base.ideal, limits.radius);
    box.add(base.a);
    box.add(base.b);
    gather(box);
    rank(base, limits);
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
        std::uint32_t number = static_cast<std::uint32_t>(i);
        if constexpr (Trace::kRecords) {
            number = firstTraced_ + static_cast<std::uint32_t>(i);
            trace_.event(Step::Test, number);
        }
        const Verdict verdict = test(base, candidates_[i], number);
        if constexpr (Trace::kRecords) {
            trace_.out.candidates[number].verdict = verdict;
            trace_.event(Step::Test, number);
        }
        if (verdict == Verdict::Accepted) {
            apex = candidates_[i];
            return true;
        }
    }
    return false;
}

/// The segments of Γ near the box, each once, in the order of their slots: the same whatever the grid delivers beyond
/// them.
template <class Grid, class Trace>
void FrontAdvancer<Grid, Trace>::gather(const Box2 &box) {
    const GenerationFront &front = state_.front;
    if (stamps_.size() < front.capacity()) {
        stamps_.resize(front.capacity() + front.capacity() / 2, 0);
    }
    if (++stamp_ == 0) {
        std::fill(stamps_.begin(), stamps_.end(), 0U);
        stamp_ = 1;
    }
    found_.clear();
    grid_.query(
        front, box,
        [&](SlotId id) {
            std::uint32_t &stamp = stamps_[index(id)];
            if (stamp != stamp_) {
                stamp = stamp_;
                ++delivered_;
                if (segmentNearBox(front.start(id), front.end(id), box, slack_)) {
                    found_.push_back(id);
                }
            }
        },
        [&](const Box2 &cell) {
            ++cells_;
            if constexpr (Trace::kRecords) {
                trace_.out.cells.push_back(cell);
            } else {
                static_cast<void>(cell);
            }
        });
    std::sort(found_.begin(), found_.end());
    neighbours_.clear();
    for (const SlotId id : found_) {
        const FrontSlot &slot = front[id];
        const FrontSlot &end = front[slot.next];
        neighbours_.push_back({id, slot.node, end.node, slot.position, end.position});
    }
}

/// Steps 5 to 7: front nodes within the radius, and the ideal point where it keeps clear of Γ; best score first, ties
/// by id.
template <class Grid, class Trace>
void FrontAdvancer<Grid, Trace>::rank(const Base &base, const Limits &limits) {
    candidates_.clear();
    const double radius2 = limits.radius * limits.radius;
    for (const Neighbour &n : neighbours_) {
        if (n.nodeA != base.nodeA && n.nodeA != base.nodeB && distanceSquared(n.a, base.ideal) <= radius2) {
            candidates_.push_back({score(base, n.a), n.a, n.nodeA, n.slot});
        }
    }
    ranked_ += static_cast<std::uint32_t>(candidates_.size());
    bool withdrawn = false;
    if (limits.newNodes) {
        withdrawn = !idealIsClear(base) || (state_.smallNodesLeft == 0 && base.rho < kSmallNode * base.fieldRho);
        if (!withdrawn) {
            candidates_.push_back({score(base, base.ideal), base.ideal, kNoNode, kNoSlot});
            ++ranked_;
        }
    }
    std::sort(candidates_.begin(), candidates_.end(), [](const Candidate &p, const Candidate &q) {
        if (p.score != q.score) {
            return p.score > q.score;
        }
        return p.node != q.node ? p.node < q.node : p.slot < q.slot;
    });
    if constexpr (Trace::kRecords) {
        trace_.out.searchRadius = limits.radius;
        firstTraced_ = static_cast<std::uint32_t>(trace_.out.candidates.size());
        trace_.event(Step::FindCandidates);
        const auto describe = [&](const Candidate &c, Verdict verdict) {
            CandidateTrace t;
            t.position = c.position;
            t.node = c.node;
            t.alpha = shapeFactor(base.a, base.b, c.position);
            t.deltaAC = spacingConformity(distance(base.a, c.position), base.rho);
            t.deltaCB = spacingConformity(distance(base.b, c.position), base.rho);
            t.score = c.score;
            t.verdict = verdict;
            trace_.out.candidates.push_back(t);
        };
        for (const Candidate &c : candidates_) {
            describe(c, Verdict::NotTried);
        }
        if (withdrawn) {
            describe({score(base, base.ideal), base.ideal, kNoNode, kNoSlot}, Verdict::Withdrawn);
        }
        trace_.event(Step::Score);
        trace_.event(Step::Sort, candidates_.empty() ? kNoIndex : firstTraced_);
    }
}

template <class Grid, class Trace>
bool FrontAdvancer<Grid, Trace>::idealIsClear(const Base &base) const {
    const double node2 = kNodeClearance * kNodeClearance * base.rho * base.rho;
    const double segment2 = kSegmentClearance * kSegmentClearance * base.rho * base.rho;
    return std::none_of(neighbours_.begin(), neighbours_.end(), [&](const Neighbour &n) {
        if (n.slot == base.slotA) {
            return false;
        }
        const bool own = n.nodeA == base.nodeA || n.nodeA == base.nodeB;
        return (!own && distanceSquared(n.a, base.ideal) < node2) ||
               distanceSquaredToSegment(base.ideal, n.a, n.b) < segment2;
    });
}

template <class Grid, class Trace>
double FrontAdvancer<Grid, Trace>::score(const Base &base, Vec2 p) const {
    return shapeFactor(base.a, base.b, p) * spacingConformity(distance(base.a, p), base.rho) *
           spacingConformity(distance(base.b, p), base.rho);
}

/// Step 8.
template <class Grid, class Trace>
Verdict FrontAdvancer<Grid, Trace>::test(const Base &base, const Candidate &candidate, std::uint32_t number) {
    const GenerationFront &front = state_.front;
    if (orientation(base.a, base.b, candidate.position) <= 0) {
        return Verdict::NotLeft;
    }
    if (!anglesAllow(base, candidate)) {
        return Verdict::OutsideAngle;
    }
    const bool known = candidate.slot != kNoSlot;
    const bool existsAC = known && front.prev(base.slotA) == candidate.slot;
    const bool existsCB = known && front.next(base.slotB) == candidate.slot;
    if ((!existsAC && crosses(base, base.a, base.nodeA, candidate, number)) ||
        (!existsCB && crosses(base, base.b, base.nodeB, candidate, number))) {
        return Verdict::CrossesFront;
    }
    return containsNode(base, candidate, number) ? Verdict::ContainsNode : Verdict::Accepted;
}

/// AC and CB leave A, B and C on the unmeshed side. A side that is a segment of Γ already needs no test at its ends.
template <class Grid, class Trace>
bool FrontAdvancer<Grid, Trace>::anglesAllow(const Base &base, const Candidate &candidate) const {
    const GenerationFront &front = state_.front;
    const bool known = candidate.slot != kNoSlot;
    if (!(known && front.prev(base.slotA) == candidate.slot) &&
        !(front.insideAngle(base.slotA, candidate.position) && (!known || front.insideAngle(candidate.slot, base.a)))) {
        return false;
    }
    return (known && front.next(base.slotB) == candidate.slot) ||
           (front.insideAngle(base.slotB, candidate.position) && (!known || front.insideAngle(candidate.slot, base.b)));
}

/// Segments of Γ that share an end with the candidate segment are left out: the angle tests have dealt with them.
template <class Grid, class Trace>
bool FrontAdvancer<Grid, Trace>::crosses(const Base &base, Vec2 from, NodeId fromNode, const Candidate &to,
                                         std::uint32_t number) {
    const Box2 box = boxOf(from, to.position);
    for (const Neighbour &n : neighbours_) {
        const bool sharesEnd = n.nodeA == fromNode || n.nodeB == fromNode || n.nodeA == to.node || n.nodeB == to.node;
        if (n.slot == base.slotA || sharesEnd || !box.overlaps(boxOf(n.a, n.b))) {
            continue;
        }
        ++tested_;
        const bool meets = segmentsMeet(from, to.position, n.a, n.b);
        if constexpr (Trace::kRecords) {
            trace_.out.tests.push_back({from, to.position, n.a, n.b, number, meets});
            trace_.event(Step::Test, number, static_cast<std::uint32_t>(trace_.out.tests.size() - 1));
            if (meets) {
                trace_.out.candidates[number].blocked = true;
                trace_.out.candidates[number].blockA = n.a;
                trace_.out.candidates[number].blockB = n.b;
            }
        } else {
            static_cast<void>(number);
        }
        if (meets) {
            return true;
        }
    }
    return false;
}

template <class Grid, class Trace>
bool FrontAdvancer<Grid, Trace>::containsNode(const Base &base, const Candidate &candidate, std::uint32_t number) {
    Box2 box = boxOf(base.a, base.b);
    box.add(candidate.position);
    for (const Neighbour &n : neighbours_) {
        if (n.nodeA == base.nodeA || n.nodeA == base.nodeB || n.nodeA == candidate.node || !box.contains(n.a)) {
            continue;
        }
        if (insideOrOn(base.a, base.b, candidate.position, n.a)) {
            if constexpr (Trace::kRecords) {
                trace_.out.candidates[number].blocked = true;
                trace_.out.candidates[number].blockA = trace_.out.candidates[number].blockB = n.a;
            } else {
                static_cast<void>(number);
            }
            return true;
        }
    }
    return false;
}

/// Step 9: the element, Γ and the grid.
template <class Grid, class Trace>
void FrontAdvancer<Grid, Trace>::update(const Base &base, const Candidate &apex, AdvanceDelta &delta) {
    GenerationFront &front = state_.front;
    const std::uint32_t region = front[base.slotA].region;
    delta.s = apex.slot;
    NodeId apexNode = apex.node;
    grid_.remove(front, base.slotA);
    if (apex.slot == kNoSlot) {
        apexNode = NodeId{static_cast<std::uint32_t>(state_.nodes.size())};
        applyNewNode(base, apex, delta);
    } else if (front.prev(base.slotA) == apex.slot && front.next(base.slotB) == apex.slot) {
        delta.kind = AdvanceDelta::Kind::Loop;
        delta.markB = front[base.slotB].mark;
        delta.markS = front[apex.slot].mark;
        grid_.remove(front, base.slotB);
        grid_.remove(front, apex.slot);
        front.removeLoop(base.slotA);
    } else if (front.prev(base.slotA) == apex.slot) {
        delta.kind = AdvanceDelta::Kind::Previous;
        delta.markS = front[apex.slot].mark;
        grid_.remove(front, apex.slot);
        front.cutOut(base.slotA);
        offer(apex.slot);
    } else if (front.next(base.slotB) == apex.slot) {
        delta.kind = AdvanceDelta::Kind::Next;
        delta.markB = front[base.slotB].mark;
        grid_.remove(front, base.slotB);
        front.cutOut(base.slotB);
        offer(base.slotA);
    } else {
        delta.kind = AdvanceDelta::Kind::Connection;
        if (front.isolated(apex.slot)) {
            grid_.remove(front, apex.slot);
        }
        delta.t = front.connect(base.slotA, apex.slot);
        offer(base.slotA);
        offer(delta.t);
    }
    state_.elements.push_back({base.nodeA, base.nodeB, apexNode});
    if (state_.manyRegions) {
        state_.elementRegions.push_back(region);
    }
    if constexpr (Trace::kRecords) {
        trace_.out.apex = apex.position;
        trace_.out.element = ElementId{static_cast<std::uint32_t>(state_.elements.size() - 1)};
        trace_.event(Step::Update);
        if (front.empty()) {
            trace_.event(Step::Finish);
        }
    }
}

template <class Grid, class Trace>
void FrontAdvancer<Grid, Trace>::applyNewNode(const Base &base, const Candidate &apex, AdvanceDelta &delta) {
    delta.kind = AdvanceDelta::Kind::NewNode;
    delta.smallNode = base.rho < kSmallNode * base.fieldRho;
    delta.s =
        state_.front.insertAfter(base.slotA, apex.position, NodeId{static_cast<std::uint32_t>(state_.nodes.size())});
    state_.nodes.push_back(apex.position);
    offer(base.slotA);
    offer(delta.s);
}

template <class Grid, class Trace>
void FrontAdvancer<Grid, Trace>::defer(const Base &base, AdvanceDelta &delta) {
    state_.front.setFailureClass(base.slotA, delta.markA.failureClass + 1);
    state_.order.offer(state_.front, base.slotA);
    if constexpr (Trace::kRecords) {
        trace_.out.deferred = true;
        trace_.event(Step::Update);
    }
}

template <class Grid, class Trace>
void FrontAdvancer<Grid, Trace>::offer(SlotId id) {
    grid_.insert(state_.front, id);
    state_.order.offer(state_.front, id);
}

template <class Grid, class Trace>
void FrontAdvancer<Grid, Trace>::count(const AdvanceDelta &delta, std::size_t segments, bool forward) {
    using Kind = AdvanceDelta::Kind;
    WorkCounters &work = state_.work;
    const auto add = [forward](std::uint64_t &sum, std::uint64_t value) { sum = forward ? sum + value : sum - value; };
    add(work.advances, 1);
    add(work.elements, delta.kind != Kind::Deferral);
    add(work.deferrals, delta.kind == Kind::Deferral);
    add(work.newNodes, delta.kind == Kind::NewNode);
    add(work.forced, delta.forced);
    add(work.frontSum, segments);
    add(work.delivered, delta.delivered);
    add(work.tested, delta.tested);
    add(work.cellsVisited, delta.cells);
    add(work.candidates, delta.candidates);
    if (delta.smallNode) {
        forward ? --state_.smallNodesLeft : ++state_.smallNodesLeft;
    }
}

template <class Grid, class Trace>
void FrontAdvancer<Grid, Trace>::retreat(const AdvanceDelta &delta) {
    using Kind = AdvanceDelta::Kind;
    GenerationFront &front = state_.front;
    const Element element = delta.kind == Kind::Deferral ? Element{} : state_.elements.back();
    const auto position = [&](NodeId node) { return state_.nodes[index(node)]; };
    switch (delta.kind) {
    case Kind::Deferral:
        front.setFailureClass(delta.a, delta.markA.failureClass);
        state_.order.offer(front, delta.a);
        break;
    case Kind::NewNode:
        grid_.remove(front, delta.a);
        grid_.remove(front, delta.s);
        front.undoInsertAfter(delta.a, delta.s, delta.markA);
        state_.nodes.pop_back();
        offer(delta.a);
        break;
    case Kind::Previous:
        grid_.remove(front, delta.s);
        front.undoCutOut(delta.a, delta.s, element[0], position(element[0]), delta.markA, delta.markS);
        offer(delta.s);
        offer(delta.a);
        break;
    case Kind::Next:
        grid_.remove(front, delta.a);
        front.undoCutOut(delta.b, delta.a, element[1], position(element[1]), delta.markB, delta.markA);
        offer(delta.a);
        offer(delta.b);
        break;
    case Kind::Loop:
        front.undoRemoveLoop({{delta.a, element[0], position(element[0]), delta.markA},
                              {delta.b, element[1], position(element[1]), delta.markB},
                              {delta.s, element[2], position(element[2]), delta.markS}},
                             state_.manyRegions ? state_.elementRegions.back() : 0);
        offer(delta.a);
        offer(delta.b);
        offer(delta.s);
        break;
    case Kind::Connection:
        grid_.remove(front, delta.a);
        grid_.remove(front, delta.t);
        front.undoConnect(delta.a, delta.s, delta.t, delta.markA);
        if (delta.s == delta.t) {
            grid_.insert(front, delta.s);
        }
        offer(delta.a);
        break;
    }
    if (delta.kind != Kind::Deferral) {
        state_.elements.pop_back();
        if (state_.manyRegions) {
            state_.elementRegions.pop_back();
        }
    }
    count(delta, front.segments(), false);
}

template class FrontAdvancer<NoGrid, NoTrace>;
template class FrontAdvancer<NoGrid, Recorder>;
template class FrontAdvancer<UniformGrid, NoTrace>;
template class FrontAdvancer<UniformGrid, Recorder>;
template class FrontAdvancer<HierarchicalGrid, NoTrace>;
template class FrontAdvancer<HierarchicalGrid, Recorder>;

} // namespace forefront
