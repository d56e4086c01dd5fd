#pragma once

#include "core/engine/improve/improve_step.hpp"
#include "core/engine/quads/pairing.hpp"
#include "core/engine/quads/quad_watch.hpp"
#include "core/engine/quads/quad_workspace.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace forefront {

/// The steps that make a mesh of quadrilaterals of a closed front, which can be done and undone. Step 1 joins the last
/// triangles; those after it are the joins of left-over triangles and the clean-up. Once recorded, it is bit for bit
/// the mesh at each step.
class QuadRecord final : public QuadWatch {
  public:
    /// Maximum memory of the changes. The changes after that become one step.
    static constexpr std::size_t kMaxBytes = std::size_t{256} << 20U;
    /// How much a step has.
    enum class Detail : std::uint8_t {
        Changes, ///< one change, or one sweep
        Passes   ///< all changes of a pass, or all sweeps between two passes
    };

    /// `front`: the mesh as the front shows it at its end. `boundary`: whose nodes come first; must outlive the record.
    QuadRecord(PairedCells front, const DiscreteDomain &boundary, Detail detail, std::size_t maxBytes = kMaxBytes);

    bool wantsSweeps() const override { return detail_ == Detail::Changes; }
    void changed(ImproveChange change, const QuadWorkspace &mesh, const ChangedCells &parts) override;

    /// Returns the number of steps, at least 1 once the front is joined.
    std::size_t steps() const { return deltas_.size() + 1; }
    /// Returns the steps after which a pass ends, ascending: a kind of change, or a part of the clean-up.
    std::vector<std::size_t> passEnds() const;
    /// Moves to the mesh after so many steps, from 1 to steps().
    void moveTo(std::size_t step);
    std::size_t position() const { return done_ + 1; }

    /// Returns the mesh at this position.
    Mesh mesh() const { return meshOfCells(view(), boundary_); }
    /// Returns the step that led to this position. Its figures are measured.
    ImproveStep step();
    QuadFigures figures() const { return figuresOf(view()); }
    std::size_t elements() const;
    std::size_t bytes() const { return bytes_; }

  private:
    struct NodeChange {
        std::uint32_t at;
        Vec2 before, after;
    };
    struct CellChange {
        std::uint32_t at;
        QuadCell before, after;
        std::uint32_t faceBefore, faceAfter;
    };
    struct Delta {
        ImproveChange change = ImproveChange::Pass;
        std::size_t refused = 0;
        std::size_t nodesBefore = 0, nodesAfter = 0, cellsBefore = 0, cellsAfter = 0; ///< lengths of the lists
        std::vector<NodeChange> nodes;
        std::vector<CellChange> cells;

        std::size_t bytes() const {
            return sizeof *this + nodes.size() * sizeof(NodeChange) + cells.size() * sizeof(CellChange);
        }
    };

    CellView view() const { return {nodes_, cells_, faces_}; }
    QuadFigures figuresOf(const CellView &view) const;
    void begin(const QuadWorkspace &mesh);
    Delta differenceTo(const QuadWorkspace &mesh, const ChangedCells &parts) const;
    void compareNode(Delta &delta, std::size_t n, const QuadWorkspace &mesh) const;
    void compareCell(Delta &delta, std::size_t c, const QuadWorkspace &mesh) const;
    void keep(Delta delta);
    void apply(const Delta &delta, bool forward);
    using Numbers = std::vector<std::uint32_t>;
    static void listMoves(const Delta &delta, const Numbers &before, const Numbers &after, ImproveStep &step);
    void listElements(const Delta &delta, const Numbers &before, const Numbers &after, ImproveStep &step) const;
    ImproveStep pairStep() const;

    PairedCells front_;
    const DiscreteDomain &boundary_;
    Detail detail_;
    std::size_t maxBytes_, bytes_ = 0;
    bool full_ = false; ///< only the remainder is recorded
    ImproveStep pairStep_;
    std::vector<Delta> deltas_;
    std::size_t done_ = 0;              ///< deltas done at this position
    std::vector<std::uint8_t> isFixed_; ///< per node of the joined mesh; nodes made later are free
    // The mesh at this position, with gaps.
    std::vector<Vec2> nodes_;
    std::vector<QuadCell> cells_;
    std::vector<std::uint32_t> faces_; ///< empty if there is one face
};

} // namespace forefront
