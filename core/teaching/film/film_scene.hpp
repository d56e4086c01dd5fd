#pragma once

#include "core/engine/base/enum_words.hpp"
#include "core/engine/session/snapshot.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// A layer of a film.
enum class FilmLayer : std::uint8_t {
    Mesh,
    Boundary,
    Front,
    Candidates,
    Grid,
    Caption,
    Labels,
    Improvement,
    Colours ///< of the nodes of a two-coloured front
};
template <>
struct EnumWords<FilmLayer> {
    static constexpr auto kLast = FilmLayer::Colours;
    static constexpr std::array<std::string_view, 9> kList = {
        "mesh", "boundary", "front", "candidates", "grid", "caption", "labels", "improvement", "colours"};
};

/// The layers that a film shows.
struct FilmLayers {
    std::array<bool, wordsOf<FilmLayer>().size()> shown{true, true, true, true, false, true, false, true, true};

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

/// A circle of a scene, in pixels.
struct FilmCircle {
    Vec2 centre;
    double radius = 0.0;
    Ink ink = Ink::Candidate;
    double width = 1.0; ///< of its line
};

/// The outline of an element of a scene, in pixels: its corners, of second order with the middle of each edge.
struct FilmElement {
    std::array<Vec2, 8> places;
    std::size_t count = 0; ///< places that it has

    void add(Vec2 place) { places[count++] = place; }
    const Vec2 *begin() const { return places.data(); }
    const Vec2 *end() const { return places.data() + count; }
};

/// A text of a scene.
struct FilmText {
    Vec2 at; ///< start of its baseline
    std::string text;
    Ink ink = Ink::Text;
    double size = 13.0;        ///< of the font, in pixels
    std::optional<Vec2> place; ///< of a label: the point of the plane that it names
};

/// A moment of a run as simple shapes in pixels, y down, to be drawn in this order: elements, lines, circles, texts.
/// Every format of pictures draws these.
struct FilmScene {
    int width = 0, height = 0;
    std::vector<FilmElement> elements;
    std::vector<FilmLine> lines;
    std::vector<FilmCircle> circles;
    std::vector<FilmText> texts;     ///< labels, and the lines of the caption
    std::optional<double> paperFrom; ///< y of the top of a band of paper, which covers shapes and circles but no texts
    double progress = 0.0;           ///< fraction of the run, in [0, 1], shown as a bar at the bottom; 0: no bar
};

/// The sheet that all scenes of a film share.
struct FilmSheet {
    Box2 box; ///< part of the plane shown
    int width = 800;
    bool cut = false;    ///< what is drawn may reach beyond the box, and is cut off there
    bool legend = false; ///< a legend of the colours of labelled moments stands above the caption

    /// Returns where the band for the caption begins, in pixels from the top.
    double bandTop() const;
    /// Returns the height that shows the whole box with a band for legend and caption below.
    int height() const;
};

/// Returns the scene of a moment of a run: within an advance, only what its events have shown so far; after a step of
/// the improvement, what it has changed. `last` is the last position of the whole run, for the progress in a film; a
/// single picture has none.
FilmScene sceneOf(const SessionSnapshot &moment, const FilmSheet &sheet, const FilmLayers &layers,
                  std::optional<std::uint64_t> last = {});

/// Returns the width of a text in a font of a size, both in pixels.
double filmTextWidth(std::string_view text, double size);
/// Returns the texts of a scene as strokes, for pictures without fonts.
std::vector<FilmLine> textStrokes(const FilmScene &scene);

/// Returns a scene as an SVG drawing.
std::string svgOf(const FilmScene &scene);

} // namespace forefront
