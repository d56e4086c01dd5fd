#pragma once

#include "core/engine/improve/improve_step.hpp"
#include "core/engine/improve/improve_watch.hpp"
#include "core/engine/mesh/tri_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace forefront {

/// The steps of an improvement, which can be done and undone on a copy of the mesh. Step 0 is the mesh before. Once
/// recorded, it is bit for bit the mesh that improvement had at each step.
class ImproveRecord final : public ImproveWatch {
  public:
    /// Maximum memory of the changes, by default. The changes after that become one step.
    static constexpr std::size_t kMaxBytes = std::size_t{256} << 20U;

    explicit ImproveRecord(const TriMesh &mesh, std::size_t maxBytes = kMaxBytes);

    void changed(ImproveChange change, const TriMesh &mesh, std::span<const Vec2> places,
                 const ChangedParts &parts) override;

    /// Returns the number of steps. Changes of numbers alone are not counted.
    std::size_t steps() const { return steps_.size(); }
    /// Returns the steps after which a pass ends, ascending: changes of one kind that follow each other.
    const std::vector<std::size_t> &passEnds() const { return passEnds_; }
    /// Moves to the mesh after so many steps, at most steps().
    void moveTo(std::size_t step);
    /// Returns the number of steps done at this position.
    std::size_t position() const { return position_; }

    /// Returns the mesh at this position, without the nodes and elements that were removed.
    TriMesh mesh() const;
    /// Returns the step that led to this position, which must not be 0. The figures are measured.
    ImproveStep step();
    /// Returns the number of nodes and elements of the mesh at this position and the figures of their shapes.
    MeshQuality shapes() const;
    ShapeFigures figures() const { return figuresOf(shapes()); }
    std::size_t bytes() const { return bytes_; }

  private:
    struct NodeChange {
        std::uint32_t at;
        Vec2 before, after;
    };
    /// An element with its region; nodes kNoNode: not there.
    struct Cell {
        Element nodes{kNoNode, kNoNode, kNoNode};
        std::int32_t region = 0;
        friend bool operator==(const Cell &, const Cell &) = default;
    };
    struct CellChange {
        std::uint32_t at;
        Cell before, after;
    };
    /// The tagged edges and points, which change their nodes where these are renumbered.
    struct Tagged {
        std::vector<TaggedEdge> edges;
        std::vector<TaggedNode> points;
    };
    struct Delta {
        ImproveChange change;
        std::size_t nodesBefore, nodesAfter; ///< lengths of the list of nodes, with gaps
        std::size_t cellsBefore, cellsAfter;
        std::vector<NodeChange> nodes;
        std::vector<CellChange> cells;
        std::optional<Tagged> taggedBefore, taggedAfter; ///< if they differ
        std::size_t bytes() const;
    };

    std::optional<Delta> differenceTo(ImproveChange change, const TriMesh &mesh, std::span<const Vec2> places,
                                      const ChangedParts &parts) const;
    void compareNode(Delta &delta, std::size_t n, std::span<const Vec2> places) const;
    void compareCell(Delta &delta, std::size_t e, const TriMesh &mesh) const;
    void compareTagged(Delta &delta, const TriMesh &mesh) const;
    void keep(Delta delta);
    void apply(const Delta &delta, bool forward);
    void count(const Cell &cell, bool add);
    std::vector<std::uint32_t> numbersOfNodes() const;
    void moveToDelta(std::size_t target);
    void renumberMoves(ImproveStep &step) const;
    void listMoves(const Delta &delta, ImproveStep &step) const;
    void listElements(const Delta &delta, ImproveStep &step) const;

    std::size_t maxBytes_;
    std::size_t bytes_ = 0;
    bool full_ = false;              ///< nothing but the remainder is recorded any more
    std::vector<Delta> deltas_;      ///< in order, also those that renumber
    std::vector<std::size_t> steps_; ///< per step: its delta. Those before it that renumber are done with it.
    std::vector<std::size_t> passEnds_;
    std::size_t done_ = 0;     ///< deltas done at this position
    std::size_t position_ = 0; ///< steps done
    bool hasRegions_;          ///< else the regions of the mesh are empty
    // The mesh at this position, with gaps. Its elements are cells_.
    TriMesh mesh_;
    std::vector<Cell> cells_;
    std::vector<std::uint32_t> uses_;    ///< per node: elements that have it
    std::vector<std::uint8_t> everUsed_; ///< per number of a node: an element had it at some step
};

} // namespace forefront
