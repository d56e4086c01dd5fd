#include "core/engine/layers/wall_chains.hpp"

#include "core/engine/geometry/predicates.hpp"

#include <map>

namespace forefront {

namespace {

/// Half-edge 2s runs along segment s from a to b, 2s + 1 back.
using HalfEdge = std::uint32_t;

class WallWalk {
  public:
    WallWalk(const DiscreteDomain &boundary, std::span<const LayerSpec> specs) : boundary_(boundary) {
        for (std::uint32_t i = 0; i < specs.size(); ++i) {
            specOf_.emplace(specs[i].tag, i);
        }
        findWalls();
        listOutgoing();
    }

    std::vector<WallChain> chains() const {
        std::vector<HalfEdge> next(walls_.size());
        std::vector<std::uint8_t> follows(2 * boundary_.segments.size(), 0); // a wall edge is before it
        for (std::size_t i = 0; i < walls_.size(); ++i) {
            next[i] = nextInFace(walls_[i]);
            follows[next[i]] = 1;
        }
        std::vector<WallChain> list;
        std::vector<std::uint8_t> done(walls_.size(), 0);
        for (const bool open : {true, false}) {
            for (std::size_t i = 0; i < walls_.size(); ++i) {
                if (done[i] == 0 && (!open || follows[walls_[i]] == 0)) {
                    list.push_back(chainFrom(i, next, done));
                }
            }
        }
        return list;
    }

  private:
    std::uint32_t from(HalfEdge h) const { return (h & 1U) == 0 ? segment(h).a : segment(h).b; }
    std::uint32_t to(HalfEdge h) const { return from(h ^ 1U); }
    const DiscreteSegment &segment(HalfEdge h) const { return boundary_.segments[h / 2]; }
    std::uint32_t face(HalfEdge h) const { return (h & 1U) == 0 ? segment(h).leftRegion : segment(h).rightRegion; }
    Vec2 at(std::uint32_t node) const { return boundary_.nodes[node]; }

    void findWalls() {
        number_.assign(2 * boundary_.segments.size(), kNoIndex);
        for (HalfEdge h = 0; h < number_.size(); ++h) {
            if (face(h) != kOutside && specOf_.contains(segment(h).tag)) {
                number_[h] = static_cast<std::uint32_t>(walls_.size());
                walls_.push_back(h);
            }
        }
    }

    /// Lists the half-edges that leave each node.
    void listOutgoing() {
        first_.assign(boundary_.nodes.size() + 1, 0);
        const auto count = static_cast<HalfEdge>(number_.size());
        for (HalfEdge h = 0; h < count; ++h) {
            ++first_[from(h) + 1];
        }
        for (std::size_t i = 1; i < first_.size(); ++i) {
            first_[i] += first_[i - 1];
        }
        outgoing_.resize(count);
        std::vector<std::uint32_t> place(first_.begin(), first_.end() - 1);
        for (HalfEdge h = 0; h < count; ++h) {
            outgoing_[place[from(h)]++] = h;
        }
    }

    /// Returns the rank of the direction from o to p in the turn from o to `start` by `side`: less than half a turn,
    /// half, more.
    static int halfTurn(Vec2 o, Vec2 start, Vec2 p, int side) {
        const int turn = side * orientation(o, start, p);
        return turn > 0 ? 0 : turn == 0 ? 1 : 2;
    }

    /// Returns the half-edge out of the start of `h` that is met first in a turn from it, counter-clockwise if `side`
    /// is 1, clockwise if it is -1; `h` itself if no other leaves there.
    HalfEdge firstInTurn(HalfEdge h, int side) const {
        const Vec2 o = at(from(h)), start = at(to(h));
        HalfEdge best = h;
        for (std::uint32_t i = first_[from(h)]; i < first_[from(h) + 1]; ++i) {
            const HalfEdge other = outgoing_[i];
            if (other == h) {
                continue;
            }
            const Vec2 p = at(to(other)), q = at(to(best));
            const int rank = halfTurn(o, start, p, side), rankBest = best == h ? 3 : halfTurn(o, start, q, side);
            if (rank < rankBest || (rank == rankBest && side * orientation(o, p, q) > 0)) {
                best = other;
            }
        }
        return best;
    }
    HalfEdge nextInFace(HalfEdge h) const { return firstInTurn(h ^ 1U, -1); }

    WallChain chainFrom(std::size_t start, const std::vector<HalfEdge> &next, std::vector<std::uint8_t> &done) const {
        WallChain chain;
        std::size_t i = start;
        for (;;) {
            const HalfEdge h = walls_[i];
            done[i] = 1;
            chain.edges.push_back({from(h), to(h), h / 2, face(h), specOf_.at(segment(h).tag)});
            if (number_[next[i]] == kNoIndex) {
                chain.after = {next[i] / 2, to(next[i])};
                const HalfEdge before = firstInTurn(walls_[start], 1);
                chain.before = {before / 2, to(before)};
                return chain;
            }
            i = number_[next[i]];
            if (i == start) {
                chain.closed = true;
                return chain;
            }
        }
    }

    const DiscreteDomain &boundary_;
    std::map<std::int32_t, std::uint32_t> specOf_;
    std::vector<HalfEdge> walls_;
    std::vector<std::uint32_t> number_; ///< per half-edge: its index in walls_, or kNoIndex
    std::vector<std::uint32_t> first_;  ///< per node: its first entry in outgoing_
    std::vector<HalfEdge> outgoing_;
};

} // namespace

std::vector<WallChain> wallChains(const DiscreteDomain &boundary, std::span<const LayerSpec> specs) {
    return WallWalk(boundary, specs).chains();
}

} // namespace forefront
