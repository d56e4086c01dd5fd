#pragma once

#include "core/base/diagnostic.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace forefront {

/// Formats of meshes that can be written, as --format has them, separated by commas.
std::string formatIds();

/// What is wrong with an output's format; empty: nothing. `id`: from --format; empty: by the extension. A name that
/// says one format for the content of another would mislead whoever reads the file; extensions that no format has may
/// hold any.
std::string checkFormat(const std::filesystem::path &output, const std::string &id);

/// A file to be written.
struct Output {
    std::filesystem::path path;
    std::string format; ///< of a mesh, an id; empty: by the extension
};

/// What can be said of the places of outputs before hours of work are spent: folders that do not exist, paths that are
/// folders, files that are given twice or are inputs.
Diagnostics checkOutputs(const std::vector<Output> &outputs, const std::vector<std::filesystem::path> &inputs = {});

} // namespace forefront
