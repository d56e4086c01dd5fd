#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace forefront {

/// The folder of assets: $FOREFRONT_ASSETS, or beside the program (../assets, ../share/forefront/assets, ...), or where
/// the program was built from. Empty where none is found.
std::filesystem::path assetFolder();

struct Sample {
    std::string title;
    std::filesystem::path path;
};
/// The samples of the gallery in the order of assets/samples/index.txt.
std::vector<Sample> samples();

} // namespace forefront
