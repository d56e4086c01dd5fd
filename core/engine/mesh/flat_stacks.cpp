#include "core/engine/mesh/flat_stacks.hpp"

#include "core/engine/mesh/placed_cell.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace forefront {

namespace {

constexpr double kFlat = 0.7; ///< height over width, as where layers end of themselves

class FlatStacks {
  public:
    FlatStacks(const MeshView &mesh, const MeshEdges &edges)
        : mesh_(mesh), edges_(edges), found_(mesh.elementCount(), false) {}

    std::vector<bool> run() {
        for (std::uint32_t k = 0; k < edges_.edges.size(); ++k) {
            if (edges_.edges[k].elements[1] == kNoElement) {
                climb(edges_.edges[k].elements[0], k);
            }
        }
        spread();
        return std::move(found_);
    }

  private:
    /// What a stack has above an edge: the edge that it continues from, if it does, and its elements.
    struct Level {
        std::optional<std::uint32_t> top;
        std::array<ElementId, 2> elements = {kNoElement, kNoElement};
    };

    void climb(ElementId element, std::uint32_t edge) {
        while (element != kNoElement) {
            const std::optional<Level> level = levelAbove(element, edge);
            if (!level || found_[index(level->elements[0])]) {
                return; // it is not flat, or another stack has it
            }
            for (const ElementId e : level->elements) {
                if (e != kNoElement) {
                    mark(e);
                }
            }
            if (!level->top) {
                return;
            }
            const ElementId last = level->elements[1] == kNoElement ? level->elements[0] : level->elements[1];
            edge = *level->top;
            element = beyond(last, edge);
        }
    }

    /// Marks the flat quadrilaterals beside those found: their sides that lead on are the rays.
    void spread() {
        while (!queue_.empty()) {
            const ElementId element = queue_.back();
            queue_.pop_back();
            if (mesh_.cornersOf(index(element)).size() != 4) {
                continue;
            }
            for (std::size_t ray = 0; ray < 4; ++ray) {
                if (heightOver(element, (ray + 1) % 4) >= kFlat) {
                    continue; // the side is not one of the short ones
                }
                const std::uint32_t edge = edges_.of(index(element), ray);
                const ElementId other = beyond(element, edge);
                if (other == kNoElement || found_[index(other)] || mesh_.cornersOf(index(other)).size() != 4) {
                    continue;
                }
                if (heightOver(other, (sideOf(other, edge) + 1) % 4) < kFlat) {
                    mark(other);
                }
            }
        }
    }

    void mark(ElementId element) {
        found_[index(element)] = true;
        queue_.push_back(element);
    }
    ElementId beyond(ElementId element, std::uint32_t edge) const {
        const std::array<ElementId, 2> &sides = edges_.edges[edge].elements;
        return sides[0] == element ? sides[1] : sides[0];
    }
    std::size_t sideOf(ElementId element, std::uint32_t edge) const {
        std::size_t side = 0;
        while (edges_.of(index(element), side) != edge) {
            ++side;
        }
        return side;
    }

    /// Returns the height of a quadrilateral over its width, between the middles of opposite sides, with the width
    /// along side k.
    double heightOver(ElementId element, std::size_t k) const {
        const PlacedCell cell(mesh_, index(element));
        const auto middle = [&](std::size_t side) {
            return midpoint(cell.nodes[side % 4], cell.nodes[(side + 1) % 4]);
        };
        return distance(middle(k), middle(k + 2)) / distance(middle(k + 1), middle(k + 3));
    }

    std::optional<Level> levelAbove(ElementId element, std::uint32_t edge) const {
        const std::size_t side = sideOf(element, edge);
        if (mesh_.cornersOf(index(element)).size() == 4) {
            if (!(heightOver(element, side) < kFlat)) {
                return std::nullopt;
            }
            return Level{edges_.of(index(element), (side + 2) % 4), {element, kNoElement}};
        }
        const PlacedCell cell(mesh_, index(element));
        const Vec2 a = cell.nodes[side], b = cell.nodes[(side + 1) % 3], apex = cell.nodes[(side + 2) % 3];
        if (!(cross(b - a, apex - a) < kFlat * dot(b - a, b - a))) {
            return std::nullopt;
        }
        // The longer one of the other sides is the diagonal of the quadrilateral that two triangles are made of.
        const std::size_t diagonal = (side + (distance(b, apex) > distance(apex, a) ? 1 : 2)) % 3;
        const std::uint32_t shared = edges_.of(index(element), diagonal);
        const ElementId partner = beyond(element, shared);
        if (partner == kNoElement || found_[index(partner)] || mesh_.cornersOf(index(partner)).size() != 3) {
            return Level{std::nullopt, {element, kNoElement}}; // where a number of layers changes
        }
        return withPartner(element, partner, shared, apex);
    }

    /// Returns the level of two triangles, the first of which has an edge below it and `apex` above.
    Level withPartner(ElementId element, ElementId partner, std::uint32_t shared, Vec2 apex) const {
        const PlacedCell other(mesh_, index(partner));
        const std::size_t side = sideOf(partner, shared);
        const std::size_t top = other.nodes[side] == apex ? (side + 2) % 3 : (side + 1) % 3; // the side at the apex
        const Vec2 a = other.nodes[top], b = other.nodes[(top + 1) % 3], below = other.nodes[(top + 2) % 3];
        if (!(cross(b - a, below - a) < kFlat * dot(b - a, b - a))) {
            return {std::nullopt, {element, kNoElement}};
        }
        return {edges_.of(index(partner), top), {element, partner}};
    }

    const MeshView &mesh_;
    const MeshEdges &edges_;
    std::vector<bool> found_;
    std::vector<ElementId> queue_; ///< marked, with neighbours to look at
};

} // namespace

std::vector<bool> elementsOfFlatStacks(const MeshView &mesh, const MeshEdges &edges) {
    return FlatStacks(mesh, edges).run();
}

} // namespace forefront
