#include "core/drawing_files/world_file/world_file.hpp"

#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

namespace forefront {
namespace {

Diagnostics worldFileFault(const std::filesystem::path &file, const std::string &message, std::string advice) {
    Diagnostics faults =
        error("bad-world-file", "world file " + file.filename().string() + ": " + message, std::move(advice));
    faults.front().file = file.string();
    return faults;
}

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/// Returns the words of a text that blanks and ends of lines separate.
std::vector<std::string> wordsIn(std::string_view text) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t from = at;
        while (at < text.size() && !isBlank(text[at])) {
            ++at;
        }
        if (at > from) {
            words.emplace_back(text.substr(from, at - from));
        }
        at += at < text.size() && isBlank(text[at]) ? 1 : 0;
    }
    return words;
}

/// Reads a number, which some programs write with a decimal comma.
bool readNumber(std::string word, double &value) {
    std::replace(word.begin(), word.end(), ',', '.');
    const char *const from = word.data() + (word.starts_with('+') ? 1 : 0), *const end = word.data() + word.size();
    const auto [stop, fault] = std::from_chars(from, end, value);
    return fault == std::errc() && stop == end && std::isfinite(value);
}

/// Returns an extension in capitals.
std::string inCapitals(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return text;
}

} // namespace

Result<PicturePlace> parseWorldFile(std::string_view text, int columns, int rows, const std::filesystem::path &file) {
    const std::vector<std::string> words = wordsIn(text);
    std::array<double, 6> numbers{};
    if (words.size() != numbers.size()) {
        return worldFileFault(file, "expected 6 numbers, got " + std::to_string(words.size()),
                              "write one number a line: x per column, y per column, x per row, y per row, x and y of "
                              "the upper left pixel");
    }
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        if (!readNumber(words[k], numbers[k])) {
            return worldFileFault(file, "line " + std::to_string(k + 1) + ": expected a number, got '" + words[k] + "'",
                                  "correct the line, or remove the file and place the picture by two points");
        }
    }
    const Vec2 column{numbers[0], numbers[1]}, row{numbers[2], numbers[3]}, firstPixel{numbers[4], numbers[5]};
    const double wide = length(column), high = length(row), area = cross(column, row);
    if (!(wide > 0.0 && high > 0.0) || !std::isfinite(area)) {
        return worldFileFault(file, "a pixel has no width or no height", "correct lines 1 to 4");
    }
    constexpr double kPerpendicular = 1e-6;
    if (std::fabs(dot(column, row)) > kPerpendicular * wide * high) {
        return worldFileFault(file, "it shears the picture, whose rows and columns would no longer be perpendicular",
                              "rectify the picture in a GIS program, or place it by two points");
    }
    if (area > 0.0) { // rows count downwards
        return worldFileFault(file, "it mirrors the picture",
                              "mirror the picture in another program, or correct the "
                              "sign of line 4, which is usually negative");
    }
    PicturePlace place;
    place.size = {wide * columns, high * rows};
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    place.angle = kDegrees * std::atan2(column.y, column.x);
    // From the middle of the upper left pixel to its lower left corner of the picture.
    place.corner = firstPixel - 0.5 * column + (rows - 0.5) * row;
    return place;
}

std::vector<std::filesystem::path> worldFileNames(const std::filesystem::path &picture) {
    const std::string extension = picture.extension().string(); // such as .jpeg
    std::vector<std::string> endings;
    if (extension.size() >= 3) {
        endings.push_back({'.', extension[1], extension.back(), 'w'});
        endings.push_back(extension + 'w');
    }
    endings.emplace_back(".wld");
    std::vector<std::filesystem::path> names;
    for (const std::string &ending : endings) {
        for (const std::string &form : {ending, inCapitals(ending)}) {
            std::filesystem::path name = picture;
            name.replace_extension(form);
            if (std::find(names.begin(), names.end(), name) == names.end()) {
                names.push_back(std::move(name));
            }
        }
    }
    return names;
}

} // namespace forefront
