#pragma once

#include "core/engine/base/enum_words.hpp"
#include "core/engine/session/snapshot.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// A layer of a film.
enum class FilmLayer : std::uint8_t { Mesh, Boundary, Front, Candidates, Grid, Caption };
template <>
struct EnumWords<FilmLayer> {
    static constexpr auto kLast = FilmLayer::Caption;
    static constexpr std::array<std::string_view, 6> kList = {"mesh",       "boundary", "front",
                                                              "candidates", "grid",     "caption"};
};

/// The layers that a film shows.
struct FilmLayers {
    std::array<bool, wordsOf<FilmLayer>().size()> shown{true, true, true, true, false, true};

    bool has(FilmLayer layer) const { return shown[static_cast<std::size_t>(layer)]; }
    /// Returns the parts of a snapshot that these layers need.
    SnapshotLayers needed() const;
};

/// The colours of a film, by meaning.
enum class Ink : std::uint8_t { Paper, Face, Edge, Boundary, Front, Base, Candidate, Accepted, Rejected, Cell, Text };
inline constexpr std::size_t kInks = 11;

/// Returns the red, green and blue of an ink.
std::array<std::uint8_t, 3> rgbOf(Ink ink);

/// A line or a dot of a scene. Widths are in pixels.
struct FilmLine {
    Vec2 a, b; ///< equal: a dot of this width
    Ink ink = Ink::Edge;
    double width = 1.0;
};

/// A moment of a run as simple shapes in pixels, y down, to be drawn in this order: elements, lines, caption.
struct FilmScene {
    int width = 0, height = 0;
    std::vector<std::array<Vec2, 3>> elements;
    std::vector<FilmLine> lines;
    std::vector<std::string> caption; ///< its lines; empty: none
    int captionRoom = 1;              ///< number of lines that fit
    double progress = 0.0;            ///< fraction of the run, in [0, 1], shown as a bar at the bottom
};

/// The sheet that all scenes of a film share.
struct FilmSheet {
    Box2 box; ///< part of the plane shown
    int width = 800;

    /// Returns the height that shows the whole box with a band for the caption below.
    int height() const;
};

/// Returns the scene of a moment of a run. `last` is the number of advances of the whole run, for the progress.
FilmScene sceneOf(const SessionSnapshot &moment, const FilmSheet &sheet, const FilmLayers &layers, std::uint64_t last);

/// Returns the caption of a scene as strokes, for pictures without fonts.
std::vector<FilmLine> captionStrokes(const FilmScene &scene);

/// Returns a scene as an SVG drawing.
std::string svgOf(const FilmScene &scene);

} // namespace forefront
