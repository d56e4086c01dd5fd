#pragma once

#include "app/reports/crack_report.hpp"
#include "app/reports/periodic_report.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesh/limits.hpp"
#include "core/engine/mesh/mesh_extent.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/sharp_corners.hpp"
#include "core/engine/mesher/front_rules.hpp"
#include "core/engine/pipeline/pipeline.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// Corners of the domain below this angle, in degrees, are reported: no mesh has larger angles there.
inline constexpr double kSharpCorner = 20.0;

/// The figures of a mesh.
struct MeshReport {
    MeshQuality quality;
    MeshExtent extent;
    Box2 bounds;
    SharpCorners sharp; ///< corners of the domain below kSharpCorner; empty for an invalid mesh
    std::uint64_t hash = 0;
    bool hasSpacing = false;              ///< the conformity to a spacing was measured
    double shortest = 0.0, longest = 0.0; ///< edges, between their corners
    /// Minimum over the elements of the ratio of the smallest to the largest Jacobian determinant; none unless the mesh
    /// is valid and of second order.
    std::optional<double> leastUniformity{};
};

/// Statistics of a finished run.
struct RunReport : MeshReport {
    std::string input; ///< name of the file
    WorkCounters work;
    ImproveLevel improve = ImproveLevel::None;
    Elements elements = Elements::Triangles;
    FrontRules rules{};               ///< the defaults unless the method is classic
    std::optional<double> leastAngle; ///< that was asked for, degrees
    LeastAngleReport angles;          ///< how it was reached
    QuadReport quads;                 ///< unless the elements are triangles
    ElementOrder elementOrder = ElementOrder::First;
    SecondOrderReport order;           ///< of a mesh of second order
    LayerReport layers;                ///< of a mesh with boundary layers
    std::vector<PlacedPairs> periodic; ///< of a mesh with periodic parts
    CrackReport cracks;                ///< of a mesh with cracks
    /// Names of the boundary parts that `layers`, `periodic` and `cracks` refer to.
    std::map<std::int32_t, std::string> boundaryNames;
    double secondsPrepare = 0.0, secondsMesh = 0.0, secondsImprove = 0.0;
    std::uint64_t peakBytes = 0; ///< maximum resident memory of the program so far

    /// Returns the CPU seconds of meshing and improvement, with validation, spacing and discretisation but without
    /// reading and writing.
    double meshCpu() const { return secondsPrepare + secondsMesh + secondsImprove; }
};

/// Measures a mesh. `spacing`: may be null. `valid`: whether its corners can be found. `open`: it may have open lines,
/// which are closed where parts and holes are counted.
MeshReport reportOf(const MeshView &mesh, const SpacingField *spacing, bool valid, bool open = false);
/// Measures the mesh of a finished run.
RunReport reportOf(const MeshingOutcome &outcome, const MeshingOptions &options);
/// Returns a warning if elements of a mesh are flat; else nothing.
Diagnostics flatElements(const MeshQuality &quality);
/// Returns a warning on quadrilaterals that are not convex, and a note on triangles that took the place of such, with
/// their places; nothing if there are none.
Diagnostics concavePlaces(const QuadReport &quads);
/// Returns the JSON object that mesh --stats writes.
std::string statisticsJson(const RunReport &report);
/// Returns the JSON object that check --stats writes: the verdict, then the figures of the mesh by the same names.
std::string statisticsJson(const MeshReport &report, bool valid, const std::vector<LimitVerdict> &verdicts);
/// Returns a line with the area, the number of parts and holes, and the areas of the regions if there are several.
std::string extentLine(double area, const MeshExtent &extent);
/// Returns a line with the number of elements of each kind, the scaled Jacobian and, for second order, how much the
/// Jacobian determinants vary; empty for triangles of 3 nodes.
std::string kindsLine(const MeshReport &report);
/// Returns a line that compares the sizes of the mesh with its node spacing.
std::string conformityLine(const MeshQuality &quality);
/// Returns a summary of a few lines.
std::string summary(const RunReport &report);

} // namespace forefront
