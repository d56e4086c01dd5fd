#include "ui/platform/assets.hpp"

#include "core/engine/platform/program.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>

namespace forefront {

namespace fs = std::filesystem;

fs::path assetFolder() {
    std::vector<fs::path> places;
    if (const char *given = std::getenv("FOREFRONT_ASSETS"); given != nullptr && *given != 0) {
        places.emplace_back(given);
    }
    std::error_code ignored;
    const fs::path program = programFile();
    for (fs::path folder = program.parent_path(); !folder.empty(); folder = folder.parent_path()) {
        places.push_back(folder / "assets");
        places.push_back(folder / "share/forefront/assets");
        if (folder == folder.root_path()) {
            break;
        }
    }
    places.emplace_back(FOREFRONT_ASSETS_INSTALLED);
    for (const fs::path &place : places) {
        if (fs::is_regular_file(place / "samples/index.txt", ignored)) {
            return place;
        }
    }
    return {};
}

namespace {

/// Orders files by the number that their names begin with, if they do, and then by name, so that 10 comes after 9.
bool byNumber(const fs::path &a, const fs::path &b) {
    const auto numberOf = [](const fs::path &file) {
        const std::string name = file.filename().string();
        int number = std::numeric_limits<int>::max();
        std::from_chars(name.data(), name.data() + name.size(), number);
        return number;
    };
    const int left = numberOf(a), right = numberOf(b);
    return left != right ? left < right : a < b;
}

} // namespace

std::vector<fs::path> lessonFiles() {
    std::vector<fs::path> found;
    std::error_code ignored;
    for (const auto &entry : fs::directory_iterator(assetFolder() / "lessons", ignored)) {
        if (entry.path().extension() == ".json") {
            found.push_back(entry.path());
        }
    }
    std::sort(found.begin(), found.end(), byNumber);
    return found;
}

std::vector<Sample> sampleDrawings() {
    std::vector<Sample> found;
    const fs::path folder = assetFolder() / "samples";
    std::ifstream index(folder / "index.txt");
    // One "FILE TITLE | ABOUT" per line.
    for (std::string file, words; index >> file && std::getline(index >> std::ws, words);) {
        const std::size_t bar = words.find(" | ");
        const std::string about = bar == std::string::npos ? std::string() : words.substr(bar + 3);
        found.push_back({words.substr(0, bar), about, folder / file});
    }
    return found;
}

} // namespace forefront
