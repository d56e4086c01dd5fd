#include "core/drawing/arrangement/cover/hidden_shapes.hpp"

#include "core/engine/base/rows.hpp"
#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/geometry/curve_part.hpp"
#include "core/engine/geometry/predicates.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

namespace forefront {

namespace {

double areaOf(const Box2 &box) {
    const Vec2 size = box.max - box.min;
    return size.x * size.y;
}

class HiddenShapes {
  public:
    HiddenShapes(const ArrangementInput &input, double reach)
        : input_(input), reach_(reach), boxes_(input.shapes.size()), hidden_(input.shapes.size(), 0) {
        pieces_ = Rows<std::uint32_t>(input.shapes.size(), [&](const auto &add) {
            for (std::uint32_t k = 0; k < input.pieces.size(); ++k) {
                if (input.pieces[k].role == PieceRole::Outline) {
                    add(shapeOf(input.pieces[k]), k);
                }
            }
        });
        for (const ArrangementPiece &piece : input.pieces) {
            if (piece.role == PieceRole::Outline) {
                boxes_[shapeOf(piece)].add(boxOf(piece));
            }
        }
    }

    std::vector<std::uint8_t> run() {
        std::vector<std::uint32_t> order;
        for (std::uint32_t shape = 0; shape < boxes_.size(); ++shape) {
            if (input_.shapes[shape].partOf == kNoClip && !boxes_[shape].empty()) {
                order.push_back(shape);
            }
        }
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t s, std::uint32_t t) { return areaOf(boxes_[s]) > areaOf(boxes_[t]); });
        const std::size_t covers = coverCount(order);
        for (std::size_t k = 0; k < covers; ++k) {
            if (hidden_[order[k]] == 0) {
                hideBelow(order[k], std::span(order).subspan(k + 1));
            }
        }
        return std::move(hidden_);
    }

  private:
    /// Returns how many of the shapes, the largest first, may hide others. Of several of the same size all may or none,
    /// so that the order of the shapes does not matter.
    std::size_t coverCount(const std::vector<std::uint32_t> &order) const {
        constexpr std::size_t kMaxCovers = 64; // limits the work; a background is larger than everything else
        if (order.size() <= kMaxCovers) {
            return order.size();
        }
        std::size_t count = kMaxCovers;
        while (count > 0 && areaOf(boxes_[order[count - 1]]) == areaOf(boxes_[order[count]])) {
            --count;
        }
        return count;
    }

    std::uint32_t shapeOf(const ArrangementPiece &piece) const { return input_.contours[piece.contour].shape; }

    /// Returns a box around the chord and its curve.
    Box2 boxOf(const ArrangementPiece &piece) const {
        Box2 box;
        box.add(piece.a);
        box.add(piece.b);
        if (piece.stretch.curve < input_.curves.size()) {
            const CurvePart part(input_.curves[piece.stretch.curve], piece.stretch.t0, piece.stretch.t1);
            for (const Vec2 corner : part.hull()) {
                box.add(corner);
            }
        }
        return box;
    }

    std::span<const std::uint32_t> piecesOf(std::uint32_t shape) const { return pieces_[shape]; }

    /// Marks the smaller shapes within one that have none of its outlines in their boxes.
    void hideBelow(std::uint32_t cover, std::span<const std::uint32_t> smaller) {
        const auto within = [&](std::uint32_t shape) {
            const Box2 box = boxes_[shape].grown(reach_);
            const std::uint32_t limit = input_.shapes[cover].limit;
            return hidden_[shape] == 0 && (limit == kNoClip || limit == input_.shapes[shape].limit) &&
                   boxes_[cover].contains(box.min) && boxes_[cover].contains(box.max);
        };
        const auto first = std::find_if(smaller.begin(), smaller.end(), within);
        if (first == smaller.end()) {
            return;
        }
        std::vector<Box2> outlines;
        for (const std::uint32_t piece : piecesOf(cover)) {
            outlines.push_back(boxOf(input_.pieces[piece]));
        }
        const BoxTree tree(outlines);
        for (const std::uint32_t shape : std::span(first, smaller.end())) {
            if (within(shape) && tree.search(boxes_[shape].grown(reach_), [](std::uint32_t) { return false; }) &&
                covers(cover, tree, boxes_[shape].min)) {
                hidden_[shape] = 1;
            }
        }
    }

    /// Returns true if a place away from the outlines of a shape lies in it, by their crossings with a ray to the
    /// right; false if there are very many.
    bool covers(std::uint32_t shape, const BoxTree &outlines, Vec2 place) const {
        constexpr std::size_t kMaxCrossings = 1000;
        std::map<std::uint32_t, int> winding; // by contour
        std::size_t crossings = 0;
        Box2 ray;
        ray.add(place);
        ray.add(Vec2{boxes_[shape].max.x, place.y});
        const bool all = outlines.search(ray, [&](std::uint32_t k) {
            const ArrangementPiece &piece = input_.pieces[piecesOf(shape)[k]];
            const bool up = piece.a.y <= place.y && piece.b.y > place.y;
            const bool down = piece.b.y <= place.y && piece.a.y > place.y;
            if ((up && orientation(piece.a, piece.b, place) > 0) ||
                (down && orientation(piece.a, piece.b, place) < 0)) {
                winding[piece.contour] += up ? 1 : -1;
            }
            return ++crossings <= kMaxCrossings;
        });
        if (!all) {
            return false;
        }
        const auto inside = [&](const auto &turns) {
            return input_.contours[turns.first].rule == FillRule::EvenOdd ? turns.second % 2 != 0 : turns.second != 0;
        };
        bool covered = false;
        for (const auto &turns : winding) {
            if (inside(turns) && input_.contours[turns.first].hole) {
                return false;
            }
            covered = covered || inside(turns);
        }
        return covered;
    }

    const ArrangementInput &input_;
    double reach_;
    std::vector<Box2> boxes_;    ///< per shape
    Rows<std::uint32_t> pieces_; ///< per shape: its pieces
    std::vector<std::uint8_t> hidden_;
};

} // namespace

std::vector<std::uint8_t> findHiddenShapes(const ArrangementInput &input, double reach) {
    if (input.features.size() != 1 || input.shapes.size() < 2) {
        return {};
    }
    return HiddenShapes(input, reach).run();
}

} // namespace forefront
