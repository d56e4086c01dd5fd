#pragma once

#include "app/batch/inputs.hpp"
#include "app/batch/mesh_arguments.hpp"
#include "app/batch/progress_bar.hpp"
#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/drawing/document/background_picture.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/files/source/map_system.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// The files that a mesh is made from.
struct MeshFiles {
    Input input;
    std::optional<Input> spacing; ///< of --spacing-file
};

/// Opens the files that the arguments name.
Result<MeshFiles> openFiles(const MeshArguments &arguments);

/// Sets the reading options of the input. Returns what is wrong with options that depend on the formats of the files;
/// empty if nothing is.
std::string checkFiles(const MeshArguments &arguments, MeshFiles &files);

/// What to mesh, and what else its files say.
struct ReadJob {
    MeshingJob job;
    Box2 box;                                      ///< of the domain
    std::optional<BackgroundPicture> picture;      ///< of a project: sizes may come from it
    MeshLimits limits;                             ///< of a project
    LengthUnit unit = LengthUnit::None;            ///< of the coordinates
    MapSystem system = {};                         ///< of the coordinates of a map
    std::vector<PeriodicSpec> periodicOfMesh = {}; ///< parts that nobody asked for
    std::optional<Repaired> repaired = {};         ///< the repair that produced the domain
    std::vector<std::int32_t> openBoundaries = {}; ///< tags, of a project
    std::string elevation = {};                    ///< of a project, see Document
};

/// Reads the domain and the sizes, shows the progress and prints the notes of the readers.
Result<ReadJob> readJob(const MeshArguments &arguments, const MeshFiles &files, ProgressBar &bar);

/// Repairs and names the domain and applies the options of the command line. Prints notes. Returns the faults, with
/// their places in the input.
Diagnostics applyArguments(const MeshArguments &arguments, const Input &input, const Progress &progress, ReadJob &read);

} // namespace forefront
