#include "core/files/elevations.hpp"

#include "core/engine/base/note.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/lazy_faces.hpp"
#include "core/engine/spacing/parts/expression/expression.hpp"
#include "core/files/files.hpp"
#include "core/files/read_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace forefront {

namespace {

/// Returns the values unless some are missing.
Result<std::vector<double>> complete(const MeshView &mesh, std::vector<double> values, const char *reason) {
    std::size_t missing = 0, first = 0;
    for (std::size_t n = values.size(); n-- > 0;) {
        if (!std::isfinite(values[n])) {
            ++missing;
            first = n;
        }
    }
    if (missing == 0) {
        return values;
    }
    Diagnostics faults =
        error("no-elevation",
              "no elevation at " + countText(missing, "node") + " of " + std::to_string(values.size()) + ": " + reason,
              missing == 1 ? "" : "the place is that of the first");
    faults.front().at = mesh.nodes[first];
    faults.front().ids = {static_cast<std::uint32_t>(first)};
    return faults;
}

Result<std::vector<double>> evaluated(const MeshView &mesh, const Result<ExpressionProgram> &program) {
    if (!program) {
        return program.faults();
    }
    std::vector<double> values(mesh.nodes.size());
    program->evaluateMany(mesh.nodes, values);
    return complete(mesh, std::move(values), "the expression is not finite there");
}

} // namespace

Result<Raster> readRaster(const std::filesystem::path &path, const ImportOptions &options, ImportNotes *notes) {
    return readFile<Raster>(
        engineFormats(), path, options, notes, [](const Format &format) { return format.readRaster != nullptr; },
        [](const Format &format, const SourceText &source) { return format.readRaster(source); });
}

Result<std::vector<double>> elevationsOf(const MeshView &mesh, const Raster &raster) {
    std::vector<double> values;
    values.reserve(mesh.nodes.size());
    for (const Vec2 node : mesh.nodes) {
        values.push_back(raster.at(node));
    }
    return complete(mesh, std::move(values), "the grid has no value there, or does not reach there");
}

Result<std::vector<double>> elevationsOf(const MeshView &mesh, const std::string &expression) {
    return evaluated(mesh, compileExpression(expression));
}

Result<std::vector<double>> elevationsOf(const MeshView &mesh, const std::string &expression,
                                         const SpacingSpec &spacing, const Domain &domain) {
    const Result<ExpressionProgram> program = compileSpacingExpression(expression, spacing, &domain);
    const LazyFaces faces(domain);
    for (std::size_t k = 0; program && k < program->functions().size(); ++k) {
        // Else it would take values from afar.
        if (Diagnostics gaps = program->functions()[k]->gaps(domain, faces.inside()); !gaps.empty()) {
            return gaps;
        }
    }
    return evaluated(mesh, program);
}

Diagnostics warnOfDryElevations(std::span<const double> elevations) {
    const bool dry =
        !elevations.empty() && std::ranges::all_of(elevations, [](double elevation) { return elevation > 0.0; });
    return dry ? Diagnostics{warningOf("dry-elevations", "all elevations are above 0, so that all depths are negative",
                                       "if the values are depths, change their sign")}
               : Diagnostics();
}

std::vector<double> renumberedElevations(std::span<const double> elevations, std::span<const NodeId> numbers) {
    std::vector<double> renumbered(elevations.size());
    for (std::size_t n = 0; n < elevations.size(); ++n) {
        renumbered[index(numbers[n])] = elevations[n];
    }
    return renumbered;
}

void addMiddleElevations(const MeshView &mesh, std::vector<double> &elevations) {
    const std::size_t known = elevations.size();
    elevations.resize(mesh.nodes.size(), 0.0);
    for (const MeshView::Block &block : mesh.blocks()) {
        const std::size_t corners = block.traits().corners;
        for (std::size_t e = 0; e < block.size(); ++e) {
            const std::span<const NodeId> nodes = block.nodesOf(e);
            double sum = 0.0;
            for (std::size_t k = 0; k < corners; ++k) {
                sum += elevations[index(nodes[k])];
            }
            for (std::size_t k = corners; k < nodes.size(); ++k) {
                const std::size_t side = k - corners;
                const double mean =
                    side < corners
                        ? 0.5 * (elevations[index(nodes[side])] + elevations[index(nodes[(side + 1) % corners])])
                        : sum / static_cast<double>(corners);
                if (index(nodes[k]) >= known) {
                    elevations[index(nodes[k])] = mean;
                }
            }
        }
    }
}

} // namespace forefront
