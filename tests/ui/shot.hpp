#pragma once

#include "tests/ui/driver.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <functional>

namespace forefront::test {

/// Something that a picture is taken of.
struct Shot {
    const char *name;
    std::function<void(Driver &)> show;
    bool hovers = false; ///< the pointer stays where it is
    bool moves = false;  ///< the picture is taken at once, of something that goes on by itself
};

/// Writes a picture as a PPM file, which most viewers and ImageMagick read.
inline void writePicture(const Driver::Picture &picture, const std::filesystem::path &file) {
    std::ofstream out(file, std::ios::binary);
    out << "P6\n" << picture.size.width << ' ' << picture.size.height << "\n255\n";
    for (std::size_t i = 0; i + 3 < picture.rgba.size(); i += 4) {
        out.write(reinterpret_cast<const char *>(&picture.rgba[i]), 3);
    }
    REQUIRE(out.good());
}

/// Opens the dialog for a drawing that is added.
void importBracket(Driver &driver);
/// Offers to combine two rectangles that overlap.
void offerCombination(Driver &driver);

} // namespace forefront::test
