#pragma once

#include "core/drawing/arrangement/snapping/node_grid.hpp"
#include "core/drawing/arrangement/snapping/snap_lines.hpp"
#include "core/engine/geometry/box_tree.hpp"

#include <cstddef>
#include <optional>
#include <unordered_map>

namespace forefront {

/// Joins lines within a single radius. Does not limit the distance that successive moves add up to.
class Snapper {
  public:
    /// `preferred`: per line, true if its first end must stay where it is.
    Snapper(std::span<const SnapLine> lines, std::span<const std::uint8_t> preferred, double radius);

    SnappedLines run(const std::stop_token &stop);

  private:
    struct Edge {
        std::uint32_t a = 0, b = 0;       ///< nodes; the same for a point
        std::uint32_t child = 0, end = 0; ///< range in children_; empty: the edge is not split
    };
    struct Cut {
        std::uint32_t edge = 0, node = 0;
        double along = 0.0;
    };
    struct Crossing {
        Vec2 at;
        std::uint32_t first = 0, second = 0;
    };

    struct Layer {
        BoxTree tree;
        std::vector<std::uint32_t> edge; ///< per box; boxes of one edge follow one another
    };

    void collectPlaces(std::span<const std::uint8_t> preferred);
    void makeEdges();
    void chooseAxis();
    Vec2 turned(Vec2 p) const { return {dot(axis_, p), cross(axis_, p)}; }
    std::uint32_t halfEdge(std::uint32_t from, std::uint32_t to);
    Layer layerOf(std::span<const std::uint32_t> edges) const;
    void index(std::uint32_t firstEdge);
    bool findCuts(const std::stop_token &stop);
    void compare(std::uint32_t edge, std::uint32_t other);
    bool apart(const Edge &e, const Edge &f) const;
    bool cutNear(std::uint32_t edge, std::uint32_t node);
    void addCrossing(std::uint32_t edge, std::uint32_t other);
    std::uint32_t nodeWithin(Vec2 at);
    void addCut(std::uint32_t edge, std::uint32_t node);
    void addCrossings();
    void splitEdges();
    void split(std::uint32_t edge, std::vector<Cut> &cuts);
    bool shortens(std::uint32_t edge, const std::vector<Cut> &cuts) const;
    double gap(std::uint32_t edge, std::uint32_t node) const;
    SnappedLines collect() const;

    std::span<const SnapLine> lines_;
    double radius_;
    std::vector<Vec2> places_;          ///< distinct ends of lines, then crossings
    std::vector<std::uint32_t> leader_; ///< per end of a line: the node it became
    std::vector<std::uint32_t> ends_;   ///< per line two: places
    std::size_t givenPlaces_ = 0;
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> children_;                     ///< half-edges
    std::vector<std::uint32_t> lineEdge_;                     ///< per line: its half-edge, or kNoIndex
    std::unordered_map<std::uint64_t, std::uint32_t> byEnds_; ///< only looked up
    std::vector<Layer> layers_;                               ///< edges of each round; split ones are skipped
    Vec2 axis_{1.0, 0.0};                                     ///< boxes lie along it
    double boxLength_ = 0.0;                                  ///< longer slanting edges have several boxes
    std::optional<NodeGrid> grid_;                            ///< nodes of the edges before inGrid_
    std::size_t inGrid_ = 0;
    std::vector<Cut> cuts_;
    std::vector<Crossing> crossings_;
};

} // namespace forefront
