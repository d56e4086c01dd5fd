#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace forefront {

/// Marks a figure that is not in the published tables.
inline constexpr double kNotPublished = -1.0;

/// One line of the statistics that S. H. Lo published for his advancing front mesher (Tables 3.1 and 3.2).
struct PublishedFigures {
    std::string_view table;
    std::string_view row;              ///< 1A ... 1E, 2A ... 2E, 3, 4
    double rhoMin = 0.0;               ///< smallest node spacing
    double delta = 0.0;                ///< mean spacing conformity; one value per row
    std::string_view grid;             ///< none, 30x20 or 60x40
    std::uint32_t nodes = 0;           ///< Nn
    std::uint32_t elements = 0;        ///< Ne
    double seconds = 0.0;              ///< mesh generation and graphics display on an unknown machine
    double alpha = 0.0;                ///< mean shape factor
    double front = 0.0;                ///< Nb
    double neighbours = kNotPublished; ///< Nc; kNotPublished without a grid
    double tests = 0.0;                ///< Ns
    double efficiency = 0.0;           ///< time without grid / time with it
};

/// Returns all lines, in the order of the tables. Generated from assets/lo_tables.csv when the program is built.
std::span<const PublishedFigures> publishedFigures();

/// Returns the line for a row and a grid; for a grid that Lo did not use, the line for 60x40, his best; null for an
/// unknown row.
const PublishedFigures *publishedFigures(std::string_view row, std::string_view grid);

} // namespace forefront
