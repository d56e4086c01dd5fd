#include "core/engine/front/generation_front.hpp"

#include "core/engine/boundary/discretise.hpp"
#include "core/engine/geometry/predicates.hpp"

#include <algorithm>
#include <numeric>

namespace forefront {

namespace {

/// A discrete segment seen from one of its ends.
struct FrontSpoke {
    std::uint32_t other; ///< node at the far end
    SlotId outgoing;     ///< front segment that starts here along the spoke, or kNoSlot
    SlotId incoming;     ///< front segment that ends here along the spoke, or kNoSlot
};

/// Returns true for directions in [0, 180) degrees; comparing coordinates is exact.
bool inUpperHalf(Vec2 centre, Vec2 p) {
    return p.y > centre.y || (p.y == centre.y && p.x > centre.x);
}

bool anglePrecedes(Vec2 centre, Vec2 p, Vec2 q) {
    const bool upperP = inUpperHalf(centre, p);
    const bool upperQ = inUpperHalf(centre, q);
    if (upperP != upperQ) {
        return upperP;
    }
    return orientation(centre, p, q) > 0;
}

} // namespace

GenerationFront::GenerationFront(const DiscreteDomain &boundary) {
    std::vector<std::uint32_t> degree(boundary.nodes.size(), 0);
    for (const DiscreteSegment &s : boundary.segments) {
        ++degree[s.a];
        ++degree[s.b];
    }
    std::vector<std::uint32_t> offset(boundary.nodes.size() + 1, 0);
    std::inclusive_scan(degree.begin(), degree.end(), offset.begin() + 1);
    std::vector<FrontSpoke> spokes(offset.back());
    std::vector<std::uint32_t> fill(offset.begin(), offset.end() - 1);
    const auto addSlot = [&](std::uint32_t from, std::uint32_t face) {
        const SlotId id = allocate();
        FrontSlot &slot = slots_[index(id)];
        slot.position = boundary.nodes[from];
        slot.node = NodeId{from};
        slot.face = face;
        return id;
    };
    std::size_t sides = 0;
    for (const DiscreteSegment &s : boundary.segments) {
        sides += (s.leftRegion != kOutside ? 1U : 0U) + (s.rightRegion != kOutside ? 1U : 0U);
    }
    slots_.reserve(sides + boundary.points.size());
    for (const DiscreteSegment &s : boundary.segments) {
        const SlotId forward = s.leftRegion != kOutside ? addSlot(s.a, s.leftRegion) : kNoSlot;
        const SlotId backward = s.rightRegion != kOutside ? addSlot(s.b, s.rightRegion) : kNoSlot;
        spokes[fill[s.a]++] = {s.b, forward, backward};
        spokes[fill[s.b]++] = {s.a, backward, forward};
    }
    for (std::uint32_t n = 0; n < boundary.nodes.size(); ++n) {
        const auto first = spokes.begin() + offset[n];
        const auto last = spokes.begin() + offset[n + 1];
        const Vec2 centre = boundary.nodes[n];
        std::sort(first, last, [&](const FrontSpoke &p, const FrontSpoke &q) {
            return anglePrecedes(centre, boundary.nodes[p.other], boundary.nodes[q.other]);
        });
        // The free angle left of an incoming segment extends clockwise to the next spoke, where the front goes out
        // again.
        for (auto spoke = first; spoke != last; ++spoke) {
            if (spoke->incoming != kNoSlot) {
                const auto leaving = spoke == first ? last - 1 : spoke - 1;
                FOREFRONT_ASSERT(leaving->outgoing != kNoSlot);
                link(spoke->incoming, leaving->outgoing);
            }
        }
    }
    segments_ = slots_.size();
    for (std::uint32_t i = 0; i < segments_; ++i) {
        renew(SlotId{i});
    }
    for (const ConstraintPoint &point : boundary.points) {
        if (degree[point.node] == 0) {
            const SlotId id = addSlot(point.node, 0);
            link(id, id);
            degree[point.node] = 1; // in case it is listed twice
        }
    }
}

SlotId GenerationFront::allocate() {
    SlotId id;
    if (free_.empty()) {
        id = SlotId{static_cast<std::uint32_t>(slots_.size())};
        slots_.emplace_back();
    } else {
        id = free_.back();
        free_.pop_back();
        slots_[index(id)] = FrontSlot{};
    }
    slots_[index(id)].alive = true;
    return id;
}

void GenerationFront::release(SlotId id) {
    slots_[index(id)].alive = false;
    free_.push_back(id);
}

SlotId GenerationFront::revive(SlotId expected, NodeId node, Vec2 position, std::uint32_t face, SegmentMark mark) {
    const SlotId id = allocate();
    FOREFRONT_ASSERT(id == expected);
    static_cast<void>(expected);
    FrontSlot &slot = slots_[index(id)];
    slot.node = node;
    slot.position = position;
    slot.face = face;
    slot.mark = mark;
    return id;
}

void GenerationFront::link(SlotId from, SlotId to) {
    slots_[index(from)].next = to;
    slots_[index(to)].prev = from;
}

void GenerationFront::renew(SlotId id) {
    restore(id, {nextSerial_++, 0});
}

void GenerationFront::restore(SlotId id, SegmentMark mark) {
    FrontSlot &slot = slots_[index(id)];
    slot.length = distance(slot.position, slots_[index(slot.next)].position);
    slot.mark = mark;
}

SlotId GenerationFront::insertAfter(SlotId a, Vec2 position, NodeId node) {
    const SlotId b = next(a);
    const SlotId c = allocate();
    FrontSlot &slot = slots_[index(c)];
    slot.position = position;
    slot.node = node;
    slot.face = slots_[index(a)].face;
    link(a, c);
    link(c, b);
    renew(a);
    renew(c);
    ++segments_;
    return c;
}

void GenerationFront::undoInsertAfter(SlotId a, SlotId c, SegmentMark base) {
    link(a, next(c));
    release(c);
    restore(a, base);
    nextSerial_ -= 2;
    --segments_;
}

void GenerationFront::cutOut(SlotId x) {
    const SlotId p = prev(x);
    link(p, next(x));
    release(x);
    renew(p);
    --segments_;
}

void GenerationFront::undoCutOut(SlotId x, SlotId p, NodeId node, Vec2 position, SegmentMark mark,
                                 SegmentMark markOfP) {
    const SlotId n = next(p);
    revive(x, node, position, slots_[index(p)].face, mark);
    link(p, x);
    link(x, n);
    restore(p, markOfP);
    restore(x, mark);
    --nextSerial_;
    ++segments_;
}

void GenerationFront::replace(SlotId x, Vec2 position, NodeId node) {
    slots_[index(x)].position = position;
    slots_[index(x)].node = node;
    renew(prev(x));
    renew(x);
}

void GenerationFront::undoReplace(SlotId x, NodeId node, Vec2 position, SegmentMark mark, SegmentMark markOfPrev) {
    slots_[index(x)].position = position;
    slots_[index(x)].node = node;
    restore(x, mark);
    restore(prev(x), markOfPrev);
    nextSerial_ -= 2;
}

void GenerationFront::removeLoop(SlotId a) {
    const SlotId b = next(a);
    const SlotId c = next(b);
    FOREFRONT_ASSERT(next(c) == a);
    release(a);
    release(b);
    release(c);
    segments_ -= 3;
}

void GenerationFront::undoRemoveLoop(const LoopSlot (&loop)[3], std::uint32_t face) {
    for (int k = 2; k >= 0; --k) {
        revive(loop[k].id, loop[k].node, loop[k].position, face, loop[k].mark);
    }
    for (int k = 0; k < 3; ++k) {
        link(loop[k].id, loop[(k + 1) % 3].id);
    }
    for (const LoopSlot &slot : loop) {
        restore(slot.id, slot.mark);
    }
    segments_ += 3;
}

SlotId GenerationFront::connect(SlotId a, SlotId s) {
    const SlotId b = next(a);
    SlotId t = s;
    if (isolated(s)) {
        slots_[index(s)].face = slots_[index(a)].face;
    } else {
        const SlotId before = prev(s);
        t = allocate();
        slots_[index(t)].position = slots_[index(s)].position;
        slots_[index(t)].node = slots_[index(s)].node;
        slots_[index(t)].rho = slots_[index(s)].rho;
        slots_[index(t)].face = slots_[index(a)].face;
        link(before, t);
    }
    link(a, s);
    link(t, b);
    renew(a);
    renew(t);
    ++segments_;
    return t;
}

void GenerationFront::undoConnect(SlotId a, SlotId s, SlotId t, SegmentMark base) {
    const SlotId b = next(t);
    if (s == t) {
        link(s, s);
        slots_[index(s)].mark = {};
        slots_[index(s)].length = 0.0;
        slots_[index(s)].face = 0;
    } else {
        link(prev(t), s);
        release(t);
    }
    --segments_;
    link(a, b);
    restore(a, base);
    nextSerial_ -= 2;
}

bool GenerationFront::insideAngle(SlotId s, Vec2 p) const {
    if (isolated(s)) {
        return true;
    }
    const Vec2 apex = start(s);
    const Vec2 out = end(s);
    const Vec2 in = start(prev(s));
    const int turn = orientation(apex, out, in);
    if (turn > 0) {
        return orientation(apex, out, p) > 0 && orientation(apex, p, in) > 0;
    }
    if (turn < 0) { // more than 180 degrees: all except the closed angle from `in` to `out`
        return !(orientation(apex, in, p) >= 0 && orientation(apex, p, out) >= 0);
    }
    // Collinear: comparing coordinates shows exactly on which side of the apex both ends lie.
    const bool sameSide = out.x != apex.x ? (out.x > apex.x) == (in.x > apex.x) && in.x != apex.x
                                          : (out.y > apex.y) == (in.y > apex.y) && in.y != apex.y;
    if (!sameSide) { // a straight angle
        return orientation(apex, out, p) > 0;
    }
    // The tip of a slit: everything except the direction of the slit.
    if (orientation(apex, out, p) != 0) {
        return true;
    }
    return out.x != apex.x ? (out.x > apex.x) != (p.x > apex.x) : (out.y > apex.y) != (p.y > apex.y);
}

bool GenerationFront::consistent() const {
    std::size_t live = 0;
    std::size_t points = 0;
    for (std::uint32_t i = 0; i < slots_.size(); ++i) {
        const FrontSlot &slot = slots_[i];
        if (!slot.alive) {
            continue;
        }
        ++live;
        const SlotId id{i};
        if (prev(slot.next) != id || next(slot.prev) != id || !slots_[index(slot.next)].alive) {
            return false;
        }
        if (isolated(id)) {
            ++points;
        } else if (slot.length != distance(slot.position, end(id)) || slot.mark.serial >= nextSerial_) {
            return false;
        }
    }
    return live == segments_ + points && live + free_.size() == slots_.size();
}

void GenerationFront::addTo(Hash64 &hash) const {
    hash.add(static_cast<std::uint64_t>(segments_));
    hash.add(static_cast<std::uint64_t>(nextSerial_));
    for (std::uint32_t i = 0; i < slots_.size(); ++i) {
        const FrontSlot &slot = slots_[i];
        if (slot.alive) {
            hash.add((static_cast<std::uint64_t>(i) << 32) | index(slot.node));
            hash.add((static_cast<std::uint64_t>(index(slot.next)) << 32) | index(slot.prev));
            hash.add((static_cast<std::uint64_t>(slot.mark.serial) << 32) | slot.mark.failureClass);
            hash.add(slot.position.x);
            hash.add(slot.position.y);
            hash.add(slot.length);
        }
    }
    // The free list decides which ids come next. Ids at its bottom that descend from the last one are equivalent to ids
    // that were never used.
    std::size_t bottom = 0;
    while (bottom < free_.size() && index(free_[bottom]) == slots_.size() - 1 - bottom) {
        ++bottom;
    }
    for (std::size_t i = bottom; i < free_.size(); ++i) {
        hash.add(static_cast<std::uint64_t>(index(free_[i])));
    }
}

} // namespace forefront
