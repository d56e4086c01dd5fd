#include "core/teaching/film/film_scene.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/teaching/film/film_labels.hpp"
#include "core/teaching/film/film_legend.hpp"
#include "core/teaching/film/stroke_font.hpp"
#include "core/teaching/moment/candidate_sides.hpp"
#include "core/teaching/moment/moment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace forefront {

namespace {

constexpr double kMargin = 12.0, kBand = 30.0; ///< pixels around the drawing, and of the band below it
constexpr double kCaptionSize = 13.0;          ///< font size of a caption, in pixels
constexpr double kTextUnit = 1.6 / 13.0;       ///< units of the stroke font, in font sizes
constexpr double kLineHeight = 18.0;           ///< pixels between the baselines of a caption
constexpr double kWidestCaption = 1000.0;      ///< pixels; about as wide as the longest captions

/// Adds the shapes of a moment to a scene.
class SceneBuilder {
  public:
    SceneBuilder(const SessionSnapshot &moment, const FilmSheet &sheet, FilmScene &scene)
        : moment_(moment), told_(momentOf(moment)), sheet_(sheet), scene_(scene) {
        const Vec2 size = sheet.box.size();
        scale_ = (sheet.width - 2.0 * kMargin) / (size.x > 0.0 ? size.x : 1.0);
    }

    /// The advance shown, as far as it is known; empty: there is none.
    const Moment &told() const { return told_; }

    void addMesh() {
        const MeshView mesh = moment_.mesh->view();
        for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
            const FilmElement element = outlineOf(mesh, e);
            if (!onSheet(element)) {
                continue;
            }
            scene_.elements.push_back(element);
            for (std::size_t k = 0; k < element.count; ++k) {
                scene_.lines.push_back({element.places[k], element.places[(k + 1) % element.count], Ink::Edge, 0.8});
            }
        }
    }
    void addBoundary() {
        const TriMesh &mesh = moment_.mesh->mesh;
        for (const TaggedEdge &edge : mesh.edges) {
            line(mesh.nodes[index(edge.a)], mesh.nodes[index(edge.b)], Ink::Boundary, 2.0);
        }
    }
    void addGrid() {
        for (const GridCellView &cell : *moment_.cells) {
            const Vec2 a = cell.box.min, c = cell.box.max, b{c.x, a.y}, d{a.x, c.y};
            line(a, b, Ink::Cell, 0.7);
            line(b, c, Ink::Cell, 0.7);
            line(c, d, Ink::Cell, 0.7);
            line(d, a, Ink::Cell, 0.7);
        }
    }
    void addFront() {
        for (const FrontSegmentView &segment : *moment_.front) {
            line(segment.a, segment.b, Ink::Front, 2.4);
        }
    }
    /// Adds the two colours of the nodes of a front: discs and rings, where its segments have room for them.
    void addColours() {
        constexpr double kDisc = 7.0, kRing = 4.0, kMinSegment = 14.0; // pixels
        for (const FrontSegmentView &segment : *moment_.front) {
            if (segment.colour >= 0 && scale_ * distance(segment.a, segment.b) > kMinSegment) {
                line(segment.a, segment.a, Ink::Front, kDisc);
                if (segment.colour == 0) {
                    line(segment.a, segment.a, Ink::Paper, kRing);
                }
            }
        }
    }
    void addCandidates() {
        const AdvanceExplanation &advance = *told_.advance;
        for (std::size_t k = 0; k < told_.candidates; ++k) {
            const CandidateTrace &candidate = advance.candidates[k];
            const bool accepted = candidate.verdict == Verdict::Accepted && told_.judged[k];
            const bool open = candidate.verdict == Verdict::NotTried || !told_.judged[k];
            const Ink ink = accepted ? Ink::Accepted : open ? Ink::Candidate : Ink::Rejected;
            if (!open) {
                for (const auto &[from, to] : sidesOf(advance, candidate)) {
                    line(from, to, ink, 1.4);
                }
            }
            line(candidate.position, candidate.position, ink, 8.0);
            if (candidate.square == SquareKind::Opening) {
                line(candidate.second, candidate.second, ink, 8.0);
            }
        }
        line(advance.a, advance.b, Ink::Base, 3.6);
    }
    /// Adds what a step of the improvement has changed: edges and nodes that came and went, and where nodes come from.
    void addImprovement(const ImproveStep &step) {
        constexpr double kVisible = 1.0; // pixels, of a move
        for (const auto &[a, b] : step.removedEdges) {
            line(a, b, Ink::Rejected, 1.4);
        }
        for (const auto &[a, b] : step.addedEdges) {
            line(a, b, Ink::Accepted, 2.0);
        }
        for (const ImproveStep::Move &move : step.moves) {
            if (scale_ * distance(move.from, move.to) >= kVisible) {
                line(move.from, move.to, Ink::Accepted, 1.8);
            }
        }
        for (const Vec2 node : step.addedNodes) {
            line(node, node, Ink::Accepted, 8.0);
        }
        for (const Vec2 node : step.removedNodes) {
            line(node, node, Ink::Rejected, 8.0);
        }
    }
    /// Adds C, the circle of the search and the labels.
    void addNames() {
        constexpr double kArm = 4.5; // pixels, of the cross at C
        const AdvanceExplanation &advance = *told_.advance;
        const Vec2 c = at(advance.ideal);
        if (told_.idealKnown) {
            scene_.lines.push_back({c - Vec2{kArm, kArm}, c + Vec2{kArm, kArm}, Ink::Base, 1.4});
            scene_.lines.push_back({c - Vec2{kArm, -kArm}, c + Vec2{kArm, -kArm}, Ink::Base, 1.4});
        }
        if (told_.candidatesKnown && advance.searchRadius > 0.0) {
            scene_.circles.push_back({c, scale_ * advance.searchRadius, Ink::Candidate, 1.0});
        }
        addLabels(
            told_, [this](Vec2 p) { return at(p); }, scale_ * sheet_.box.size().y + 2.0 * kMargin, scene_);
    }

  private:
    FilmElement outlineOf(const MeshView &mesh, std::size_t e) const {
        const std::span<const NodeId> nodes = mesh.nodesOf(e);
        const CellTraits &traits = traitsOf(mesh.kindOf(e));
        FilmElement element;
        for (std::size_t k = 0; k < traits.corners; ++k) {
            element.add(at(mesh.nodes[index(nodes[k])]));
            if (traits.order == 2) {
                element.add(at(mesh.nodes[index(nodes[traits.corners + k])]));
            }
        }
        return element;
    }
    Vec2 at(Vec2 p) const {
        return {kMargin + scale_ * (p.x - sheet_.box.min.x), kMargin + scale_ * (sheet_.box.max.y - p.y)};
    }
    /// Returns false for points of which no line or triangle can be seen.
    template <class Points>
    bool onSheet(const Points &points) const {
        Box2 box;
        for (const Vec2 p : points) {
            box.add(p);
        }
        const Box2 sheet{{0.0, 0.0}, {static_cast<double>(scene_.width), static_cast<double>(scene_.height)}};
        return !sheet_.cut || box.overlaps(sheet);
    }
    void line(Vec2 a, Vec2 b, Ink ink, double width) {
        const FilmLine drawn{at(a), at(b), ink, width};
        if (onSheet(std::array{drawn.a, drawn.b})) {
            scene_.lines.push_back(drawn);
        }
    }

    const SessionSnapshot &moment_;
    const Moment told_;
    const FilmSheet &sheet_;
    FilmScene &scene_;
    double scale_ = 1.0;
};

std::string colourText(Ink ink) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t part : rgbOf(ink)) {
        text += kDigits[part / 16];
        text += kDigits[part % 16];
    }
    return text;
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    }
    return result;
}

/// Returns a length or coordinate, rounded to hundredths of a pixel.
std::string pixels(double value) {
    return numberText(std::round(value * 100.0) / 100.0, 8);
}
std::string pair(Vec2 p) {
    return pixels(p.x) + ' ' + pixels(p.y);
}

/// Splits a text at spaces into lines that fit a width in pixels.
std::vector<std::string> wrapped(const std::string &text, double width) {
    std::vector<std::string> lines(1);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        std::string &line = lines.back();
        if (line.empty()) {
            line = word;
        } else if (filmTextWidth(line + ' ' + word, kCaptionSize) <= width) {
            line += ' ' + word;
        } else {
            lines.push_back(word);
        }
        at = end + 1;
    }
    return lines;
}

/// Returns the number of caption lines that fit on a sheet.
int captionLines(int width) {
    return static_cast<int>(std::ceil(kWidestCaption / (width - 2.0 * kMargin)));
}

/// Adds the lines of a caption below the drawing; those that do not fit are left out.
void addCaption(const std::string &text, FilmScene &scene) {
    const int room = captionLines(scene.width);
    const std::vector<std::string> lines = wrapped(text, scene.width - 2.0 * kMargin);
    for (int k = 0; k < std::min(room, static_cast<int>(lines.size())); ++k) {
        const Vec2 at{kMargin, scene.height - 14.0 - kLineHeight * static_cast<double>(room - 1 - k)};
        scene.texts.push_back({at, lines[static_cast<std::size_t>(k)], Ink::Text, kCaptionSize, {}});
    }
}

/// Returns the caption of a moment: its step of the improvement, or its advance with what is known of it.
std::string captionOf(const SessionSnapshot &moment, const Moment &told) {
    if (moment.improvement) {
        return caption(*moment.improvement, moment.improveSteps);
    }
    std::string text = "Advance " + std::to_string(moment.advance) + ", " + std::to_string(moment.frontSegments) +
                       " segments on the front";
    if (told) {
        text += ". " + caption(*told.advance, told.cursor);
    }
    return text + (moment.improved ? "; the mesh is improved" : "");
}

/// Appends a text. A label also says which point it names, in the units of the drawing.
void appendText(const FilmText &text, std::string &svg) {
    svg += "<text x=\"" + pixels(text.at.x) + "\" y=\"" + pixels(text.at.y) +
           "\" font-family=\"sans-serif\" font-size=\"" + pixels(text.size) + "\" fill=\"" + colourText(text.ink) + '"';
    if (text.place) {
        svg += " data-x=\"" + exactText(text.place->x) + "\" data-y=\"" + exactText(text.place->y) + '"';
    }
    svg += '>' + escaped(text.text) + "</text>\n";
}

/// Appends the lines as one path for each stretch of equal ink and width.
void appendLines(const std::vector<FilmLine> &lines, std::string &svg) {
    for (std::size_t k = 0; k < lines.size();) {
        const FilmLine &first = lines[k];
        svg += "<path stroke=\"" + colourText(first.ink) + "\" stroke-width=\"" + pixels(first.width) + "\" d=\"";
        for (; k < lines.size() && lines[k].ink == first.ink && lines[k].width == first.width; ++k) {
            svg += 'M' + pair(lines[k].a) + 'L' + pair(lines[k].b);
        }
        svg += "\"/>\n";
    }
}

} // namespace

SnapshotLayers FilmLayers::needed() const {
    return {.mesh = true, // carries the boundary, too
            .front = has(FilmLayer::Front) || has(FilmLayer::Colours),
            .cells = has(FilmLayer::Grid),
            .explanation = has(FilmLayer::Candidates) || has(FilmLayer::Caption) || has(FilmLayer::Labels)};
}

std::array<std::uint8_t, 3> rgbOf(Ink ink) {
    constexpr std::array<std::array<std::uint8_t, 3>, kInks> kColours = {{{255, 255, 255},
                                                                          {219, 233, 246},
                                                                          {122, 142, 164},
                                                                          {44, 58, 74},
                                                                          {217, 95, 2},
                                                                          {117, 40, 140},
                                                                          {150, 150, 150},
                                                                          {27, 158, 119},
                                                                          {214, 39, 40},
                                                                          {200, 200, 180},
                                                                          {40, 40, 40}}};
    return kColours[static_cast<std::size_t>(ink)];
}

double FilmSheet::bandTop() const {
    const Vec2 size = box.size();
    const double scale = (width - 2.0 * kMargin) / (size.x > 0.0 ? size.x : 1.0);
    return scale * size.y + 2.0 * kMargin;
}

int FilmSheet::height() const {
    const double text = kLineHeight * (captionLines(width) - 1 + (legend ? legendLines(width) : 0));
    constexpr double kRounding = 1e-6; // boxes of equal proportions must give equal heights
    return static_cast<int>(std::ceil(bandTop() + kBand + text - kRounding));
}

FilmScene sceneOf(const SessionSnapshot &moment, const FilmSheet &sheet, const FilmLayers &layers,
                  std::optional<std::uint64_t> last) {
    FilmScene scene;
    scene.width = sheet.width;
    scene.height = sheet.height();
    if (last) {
        scene.progress =
            *last == 0 ? 1.0 : std::min(1.0, static_cast<double>(moment.position()) / static_cast<double>(*last));
    }
    if (sheet.cut || layers.has(FilmLayer::Labels)) { // the circle of the search may reach beyond the box
        scene.paperFrom = sheet.bandTop();
    }
    SceneBuilder builder(moment, sheet, scene);
    if (layers.has(FilmLayer::Mesh) && moment.mesh) {
        builder.addMesh();
    }
    if (layers.has(FilmLayer::Grid) && moment.cells) {
        builder.addGrid();
    }
    if (layers.has(FilmLayer::Boundary) && moment.mesh) {
        builder.addBoundary();
    }
    if (layers.has(FilmLayer::Front) && moment.front) {
        builder.addFront();
    }
    if (layers.has(FilmLayer::Colours) && moment.front) {
        builder.addColours();
    }
    const bool explained = static_cast<bool>(builder.told());
    if (layers.has(FilmLayer::Candidates) && explained) {
        builder.addCandidates();
    }
    if (layers.has(FilmLayer::Labels) && explained) {
        builder.addNames();
    }
    if (layers.has(FilmLayer::Improvement) && moment.improvement) {
        builder.addImprovement(*moment.improvement);
    }
    if (sheet.legend) {
        addLegend(sheet.bandTop(), scene);
    }
    if (layers.has(FilmLayer::Caption)) {
        addCaption(captionOf(moment, builder.told()), scene);
    }
    return scene;
}

double filmTextWidth(std::string_view text, double size) {
    return size * kTextUnit * strokeTextWidth(text);
}

std::vector<FilmLine> textStrokes(const FilmScene &scene) {
    std::vector<FilmLine> lines;
    for (const FilmText &text : scene.texts) {
        const auto at = [&](Vec2 p) { return text.at + text.size * kTextUnit * Vec2{p.x, -p.y}; };
        for (const auto &[a, b] : strokeText(text.text)) {
            lines.push_back({at(a), at(b), text.ink, 0.1 * text.size});
        }
    }
    return lines;
}

std::string svgOf(const FilmScene &scene) {
    const std::string width = std::to_string(scene.width), height = std::to_string(scene.height);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
                      "\" viewBox=\"0 0 " + width + ' ' + height +
                      "\" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n<rect width=\"" + width +
                      "\" height=\"" + height + "\" fill=\"" + colourText(Ink::Paper) + "\"/>\n";
    if (!scene.elements.empty()) {
        svg += "<path fill=\"" + colourText(Ink::Face) + "\" d=\"";
        for (const FilmElement &element : scene.elements) {
            for (const Vec2 &corner : element) {
                svg += (&corner == element.begin() ? 'M' : 'L') + pair(corner);
            }
            svg += "Z\n";
        }
        svg += "\"/>\n";
    }
    appendLines(scene.lines, svg);
    for (const FilmCircle &circle : scene.circles) {
        svg += "<circle cx=\"" + pixels(circle.centre.x) + "\" cy=\"" + pixels(circle.centre.y) + "\" r=\"" +
               pixels(circle.radius) + "\" stroke=\"" + colourText(circle.ink) + "\" stroke-width=\"" +
               pixels(circle.width) + "\"/>\n";
    }
    if (scene.paperFrom) {
        svg += "<rect y=\"" + pixels(*scene.paperFrom) + "\" width=\"" + width + "\" height=\"" +
               pixels(scene.height - *scene.paperFrom) + "\" fill=\"" + colourText(Ink::Paper) + "\"/>\n";
    }
    for (const FilmText &text : scene.texts) {
        appendText(text, svg);
    }
    if (scene.progress > 0.0) {
        svg += "<rect y=\"" + pixels(scene.height - 4.0) + "\" width=\"" + pixels(scene.progress * scene.width) +
               "\" height=\"4\" fill=\"" + colourText(Ink::Front) + "\"/>\n";
    }
    return svg + "</svg>\n";
}

} // namespace forefront
