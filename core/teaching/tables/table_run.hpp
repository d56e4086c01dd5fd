#pragma once

#include "core/engine/pipeline/pipeline.hpp"
#include "core/teaching/tables/table_case.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// A background grid by its name in the tables: none, COLUMNSxROWS or hierarchical.
struct TableGrid {
    std::string name;
    GridKind kind = GridKind::None;
    int columns = 0, rows = 0;
};
/// Parses the name of a grid; std::nullopt for any other text.
std::optional<TableGrid> parseTableGrid(std::string_view text);
/// Returns the values that parseTableGrid() accepts: "none, COLUMNSxROWS or hierarchical".
std::string tableGridList();

/// The figures that depend on the grid: the work, never the mesh.
struct GridFigures {
    std::string grid;
    double seconds = 0.0; ///< CPU time of the front alone, from discretised boundary to Γ = ∅; minimum of several runs
    double neighbours = 0.0; ///< Nc; without a grid every segment of Γ is delivered
    double efficiency = 0.0; ///< time without grid / time with it; 0 if the row was not run without a grid
};

/// The result of the adaptive refinement of a row.
struct AdaptFigures {
    double target = 0.0;     ///< error of the gradient, as a fraction of its norm
    double error = 0.0;      ///< estimated on the raw mesh of the row
    double minSpacing = 0.0; ///< of the last background mesh
    std::size_t rounds = 0;  ///< new meshes until the spacing was found
};

/// Figures of one row. "Raw" is the mesh as the front leaves it, "improved" the same after the default swapping and
/// smoothing.
struct RowFigures {
    TableCase row;
    std::size_t nodes = 0, elements = 0; ///< Nn, Ne
    std::size_t boundaryNodes = 0;
    double expectedElements = 0.0; ///< ∫ 4/(√3·ρ²) dA
    double alphaRaw = 0.0, deltaRaw = 0.0, alphaMinRaw = 0.0;
    double alphaImproved = 0.0, deltaImproved = 0.0, alphaMinImproved = 0.0;
    double secondsImprove = 0.0;         ///< CPU time
    double front = 0.0;                  ///< Nb
    double considered = 0.0;             ///< Ns, as Lo counts it
    double tests = 0.0;                  ///< Nt, exact tests
    std::uint64_t hash = 0;              ///< of the raw mesh, the same for every grid
    std::optional<AdaptFigures> adapted; ///< rows 3 and 4
    std::vector<GridFigures> grids;
};

/// Meshes one row by the classic method with each grid; finds the node spacing by adaptive refinement first where the
/// row calls for it. Faults: "grid-changes-mesh" where two grids differ in the mesh or in the segments tested,
/// "cancelled", and those of the mesher.
Result<RowFigures> runTableRow(const TableCase &row, const std::vector<TableGrid> &grids,
                               const Progress &progress = {});

/// Adds the grids of an earlier run of a row to those of a later one, in the order of the tables: none, fixed grids by
/// their number of cells, hierarchical. A grid of both has its figures of the later run; a run whose mesh differs from
/// that of the later one adds nothing.
void addEarlierGrids(RowFigures &row, const RowFigures &earlier);

} // namespace forefront
