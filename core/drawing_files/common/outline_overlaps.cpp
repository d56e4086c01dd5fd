#include "core/drawing_files/common/outline_overlaps.hpp"

#include "core/engine/base/rows.hpp"
#include "core/engine/geometry/box_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace forefront {

namespace {

/// Pairs of outlines that come near each other, the lower index first.
using RingPairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// Finds which outlines overlap by arranging them as features of their own.
class OverlapSearch {
  public:
    OverlapSearch(const ArrangementInput &input, std::span<const std::uint32_t> starts) : input_(input) {
        for (std::size_t k = 0; k < starts.size(); ++k) {
            const std::uint32_t contour = input.pieces[starts[k]].contour;
            const std::size_t limit = k + 1 < starts.size() ? starts[k + 1] : input.pieces.size();
            std::uint32_t end = starts[k];
            while (end < limit && isOf(input.pieces[end], contour)) {
                ++end;
            }
            if (input.contours[contour].rule == FillRule::EvenOdd) {
                rings_.push_back({starts[k], end});
            }
        }
    }

    OutlineOverlaps run() const {
        const RingPairs pairs = nearPairs();
        std::set<std::uint32_t> near;
        for (const auto &[first, second] : pairs) {
            near.insert({first, second});
        }
        const std::optional<ArrangementChange> found = overlapOf({near.begin(), near.end()});
        if (!found) {
            return {};
        }
        const auto [first, second] = std::minmax({found->piece, partnerOf(found->piece, pairs)});
        return {found->count, found->displacement, found->places, first, second};
    }

  private:
    struct Ring {
        std::uint32_t first = 0, end = 0; ///< pieces
    };

    static bool isOf(const ArrangementPiece &piece, std::uint32_t contour) {
        return piece.role == PieceRole::Outline && piece.contour == contour;
    }

    /// Returns the pairs of outlines of one contour that have pieces whose boxes meet.
    RingPairs nearPairs() const {
        std::vector<Box2> boxes;
        std::vector<std::uint32_t> owners;
        for (std::uint32_t r = 0; r < rings_.size(); ++r) {
            for (std::uint32_t p = rings_[r].first; p < rings_[r].end; ++p) {
                boxes.push_back(boxOfPiece(input_.pieces[p]).grown(input_.tolerance));
                owners.push_back(r);
            }
        }
        RingPairs pairs;
        const BoxTree tree(boxes);
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            tree.query(boxes[k], [&](std::uint32_t other) {
                if (owners[k] < owners[other] && contourOf(owners[k]) == contourOf(owners[other])) {
                    pairs.emplace(owners[k], owners[other]);
                }
            });
        }
        return pairs;
    }

    Box2 boxOfPiece(const ArrangementPiece &piece) const {
        Box2 box = boxOf(piece.a, piece.b);
        if (piece.stretch.follows()) {
            box.add(input_.curves[piece.stretch.curve].bounds(piece.stretch.t0, piece.stretch.t1));
        }
        return box;
    }

    std::uint32_t contourOf(std::uint32_t ring) const { return input_.pieces[rings_[ring].first].contour; }

    /// Returns the overlaps of some outlines, with a piece of the input.
    std::optional<ArrangementChange> overlapOf(const std::vector<std::uint32_t> &rings) const {
        ArrangementInput apart;
        apart.tolerance = input_.tolerance;
        std::vector<std::uint32_t> source;
        std::map<std::uint32_t, std::uint32_t> numbers; // of curves
        for (const std::uint32_t ring : rings) {
            const std::uint32_t contour = apart.addContour(apart.addShape(apart.addFeature(1)), FillRule::EvenOdd);
            for (std::uint32_t p = rings_[ring].first; p < rings_[ring].end; ++p) {
                ArrangementPiece piece = input_.pieces[p];
                piece.contour = contour;
                if (piece.stretch.follows()) {
                    const auto [number, isNew] =
                        numbers.try_emplace(piece.stretch.curve, static_cast<std::uint32_t>(apart.curves.size()));
                    if (isNew) {
                        apart.curves.push_back(input_.curves[piece.stretch.curve]);
                    }
                    piece.stretch.curve = number->second;
                }
                apart.pieces.push_back(piece);
                source.push_back(p);
            }
        }
        Result<Arrangement> arranged = arrange(apart);
        if (!arranged) {
            return std::nullopt; // arranging the drawing itself tells why
        }
        const auto found =
            std::find_if(arranged->changes.begin(), arranged->changes.end(),
                         [](const ArrangementChange &change) { return change.kind == ChangeKind::OverlapsDecided; });
        if (found == arranged->changes.end()) {
            return std::nullopt;
        }
        found->piece = source[found->piece];
        return std::move(*found);
    }

    /// Returns the first piece of an outline that overlaps the one with a piece.
    std::uint32_t partnerOf(std::uint32_t piece, const RingPairs &pairs) const {
        for (const auto &[first, second] : pairs) {
            const bool ofFirst = has(first, piece), ofSecond = has(second, piece);
            if ((ofFirst || ofSecond) && overlapOf({first, second})) {
                return rings_[ofFirst ? second : first].first;
            }
        }
        return piece;
    }

    bool has(std::uint32_t ring, std::uint32_t piece) const {
        return rings_[ring].first <= piece && piece < rings_[ring].end;
    }

    const ArrangementInput &input_;
    std::vector<Ring> rings_; ///< of contours with the even-odd rule
};

} // namespace

OutlineOverlaps findOutlineOverlaps(const ArrangementInput &input, std::span<const std::uint32_t> rings) {
    return rings.size() < 2 ? OutlineOverlaps{} : OverlapSearch(input, rings).run();
}

OutlineCrossings findOutlineCrossings(const ArrangementInput &input, const Arrangement &arrangement) {
    const Domain &domain = arrangement.domain;
    const auto isLine = [&](std::uint32_t piece) { return input.pieces[piece].role == PieceRole::Constraint; };
    const auto isBoundary = [&](std::size_t s) { return domain.segments[s].role == SegmentRole::Boundary; };
    const Rows<std::uint32_t> around(domain.nodes.size(), [&](const auto &add) {
        for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
            if (isBoundary(s)) {
                add(domain.segments[s].a, s);
                add(domain.segments[s].b, s);
            }
        }
    });
    OutlineCrossings found;
    for (std::uint32_t n = 0; n < domain.nodes.size(); ++n) {
        if (around[n].size() != 4) {
            continue;
        }
        std::array<std::pair<double, std::uint32_t>, 4> turns; // direction, piece
        for (std::size_t k = 0; k < 4; ++k) {
            const DomainSegment &segment = domain.segments[around[n][k]];
            const Vec2 along = domain.nodes[segment.a == n ? segment.b : segment.a] - domain.nodes[n];
            turns[k] = {std::atan2(along.y, along.x), arrangement.stretches[around[n][k]].piece};
        }
        std::sort(turns.begin(), turns.end());
        const auto [first, second] = std::minmax(turns[0].second, turns[1].second);
        if (turns[0].second != turns[2].second || turns[1].second != turns[3].second || first == second ||
            !isLine(first) || !isLine(second)) {
            continue;
        }
        if (found.count++ == 0) {
            found.first = first;
            found.second = second;
        }
        if (found.places.size() < ArrangementChange::kPlaces) {
            found.places.push_back(domain.nodes[n]);
        }
    }
    return found;
}

} // namespace forefront
