#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace forefront {

/// Returns the assets folder: $FOREFRONT_ASSETS; else `assets` or `share/forefront/assets` in the program's folder
/// or one above it; else where the program was configured to be installed. Empty if none of them exists.
std::filesystem::path assetFolder();

/// Returns the files of the lessons that come with the program, by name.
std::vector<std::filesystem::path> lessonFiles();

struct Sample {
    std::string title;
    std::string about; ///< what it shows, in a few words
    std::filesystem::path path;
};
/// Returns the samples of the gallery in the order of assets/samples/index.txt.
std::vector<Sample> sampleDrawings();

} // namespace forefront
