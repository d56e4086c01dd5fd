#include "core/teaching/lesson/glossary_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace forefront {

Box2 Figure::bounds() const {
    Box2 box;
    for (const auto &element : elements) {
        for (const Vec2 corner : element) {
            box.add(corner);
        }
    }
    for (const FigureLine &line : lines) {
        box.add(line.a);
        box.add(line.b);
    }
    for (const FigureLabel &label : labels) {
        box.add(label.at);
    }
    return box;
}

namespace figures {

namespace {

using Ink = FigureInk;

const double kHeight = std::sqrt(3.0) / 2.0; ///< of an equilateral triangle of side 1

/// Adds the head of an arrow in the middle of a segment.
void arrow(Figure &figure, Vec2 a, Vec2 b, Ink ink) {
    constexpr double kHead = 0.11;
    const double length = distance(a, b);
    const Vec2 along = (kHead / length) * (b - a), left{-along.y, along.x}, tip = midpoint(a, b) + 0.5 * along;
    figure.lines.push_back({tip, tip - along + 0.6 * left, ink});
    figure.lines.push_back({tip, tip - along - 0.6 * left, ink});
}

/// Adds lines; those of the front and its base have a direction, which they show.
void add(Figure &figure, Ink ink, const std::vector<Vec2> &points, bool closed = false) {
    const auto line = [&](Vec2 a, Vec2 b) {
        figure.lines.push_back({a, b, ink});
        if (ink == Ink::Front || ink == Ink::Base) {
            arrow(figure, a, b, ink);
        }
    };
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        line(points[k], points[k + 1]);
    }
    if (closed) {
        line(points.back(), points.front());
    }
}

void dot(Figure &figure, Vec2 at, Ink ink) {
    figure.lines.push_back({at, at, ink});
}

/// Adds an element with its edges.
void element(Figure &figure, Vec2 a, Vec2 b, Vec2 c) {
    figure.elements.push_back({a, b, c});
    add(figure, Ink::Edge, {a, b, c}, true);
}

void circle(Figure &figure, Vec2 centre, double radius, Ink ink) {
    constexpr int kSides = 40;
    std::vector<Vec2> points;
    for (int k = 0; k < kSides; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / kSides;
        points.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    add(figure, ink, points, true);
}

/// Adds a square lattice.
void lattice(Figure &figure, Vec2 corner, double cell, int columns, int rows) {
    for (int k = 0; k <= columns; ++k) {
        add(figure, Ink::Cell, {corner + Vec2{k * cell, 0.0}, corner + Vec2{k * cell, rows * cell}});
    }
    for (int k = 0; k <= rows; ++k) {
        add(figure, Ink::Cell, {corner + Vec2{0.0, k * cell}, corner + Vec2{columns * cell, k * cell}});
    }
}

const std::vector<Vec2> kOutline = {{0, 0}, {2, -0.3}, {4, 0}, {4.3, 2}, {3, 3}, {1, 3}, {-0.3, 1.6}};

/// Adds the front that most figures share: a shallow valley with the base at its bottom.
void valley(Figure &figure) {
    add(figure, Ink::Front, {{-2.1, 1.3}, {-1.2, 0.55}, {-0.5, 0.0}});
    add(figure, Ink::Front, {{0.5, 0.0}, {1.35, 0.45}, {2.2, 1.2}});
    add(figure, Ink::Base, {{-0.5, 0.0}, {0.5, 0.0}});
    figure.labels.push_back({{-0.5, -0.25}, "A", Ink::Base});
    figure.labels.push_back({{0.5, -0.25}, "B", Ink::Base});
}

} // namespace

Figure domain() {
    Figure figure;
    add(figure, Ink::Boundary, kOutline, true);
    add(figure, Ink::Boundary, {{1.5, 1}, {1.5, 2}, {2.6, 2}, {2.6, 1}}, true);
    figure.labels.push_back({{0.6, 1.4}, "\xce\xa9", Ink::Text});
    figure.labels.push_back({{2.05, 1.5}, "hole", Ink::Text});
    return figure;
}

Figure spacing() {
    Figure figure;
    double x = 0.0;
    for (const double step : {0.4, 0.55, 0.75, 1.0, 1.35}) {
        element(figure, {x, 0}, {x + step, 0}, {x + step / 2, kHeight * step});
        x += step;
    }
    figure.labels.push_back({{0.2, -0.25}, "small \xcf\x81", Ink::Text});
    figure.labels.push_back({{3.4, -0.25}, "large \xcf\x81", Ink::Text});
    return figure;
}

Figure front() {
    Figure figure;
    element(figure, {0, 0}, {1, 0}, {0.5, kHeight});
    element(figure, {1, 0}, {2, 0}, {1.5, kHeight});
    element(figure, {1, 0}, {1.5, kHeight}, {0.5, kHeight});
    add(figure, Ink::Boundary, {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 2}, {0, 2}, {0, 0}});
    add(figure, Ink::Front, {{0, 0}, {0.5, kHeight}, {1.5, kHeight}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {0, 2}, {0, 0}});
    figure.labels.push_back({{1.6, 1.45}, "unmeshed", Ink::Text});
    figure.labels.push_back({{2.3, 0.6}, "\xce\x93", Ink::Front});
    return figure;
}

Figure base() {
    Figure figure;
    valley(figure);
    figure.labels.push_back({{0.0, 0.7}, "unmeshed side", Ink::Text});
    return figure;
}

Figure idealPoint() {
    Figure figure;
    valley(figure);
    add(figure, Ink::Candidate, {{-0.5, 0}, {0, kHeight}, {0.5, 0}});
    dot(figure, {0, kHeight}, Ink::Candidate);
    figure.labels.push_back({{0, kHeight + 0.25}, "C", Ink::Candidate});
    figure.labels.push_back({{-0.45, 0.55}, "\xcf\x81", Ink::Text});
    figure.labels.push_back({{0.45, 0.55}, "\xcf\x81", Ink::Text});
    return figure;
}

Figure candidates() {
    Figure figure = idealPoint();
    circle(figure, {0, kHeight}, 1.5, Ink::Cell);
    for (const Vec2 node : {Vec2{-1.2, 0.55}, Vec2{1.35, 0.45}}) {
        dot(figure, node, Ink::Candidate);
    }
    return figure;
}

Figure candidateSegments() {
    Figure figure;
    valley(figure);
    add(figure, Ink::Candidate, {{-0.5, 0}, {1.35, 0.45}, {0.5, 0}});
    dot(figure, {1.35, 0.45}, Ink::Candidate);
    figure.labels.push_back({{1.5, 0.25}, "C", Ink::Candidate});
    return figure;
}

Figure score() {
    Figure figure;
    valley(figure);
    add(figure, Ink::Accepted, {{-0.5, 0}, {0, kHeight}, {0.5, 0}});
    add(figure, Ink::Candidate, {{-0.5, 0}, {1.35, 0.45}, {0.5, 0}});
    figure.labels.push_back({{0, kHeight + 0.25}, "0.98", Ink::Accepted});
    figure.labels.push_back({{1.75, 0.35}, "0.31", Ink::Candidate});
    return figure;
}

Figure shapeFactor() {
    Figure figure;
    element(figure, {0, 0}, {1, 0}, {0.5, kHeight});
    element(figure, {1.5, 0}, {2.5, 0}, {1.5, 1});
    element(figure, {3, 0}, {4, 0}, {3.5, 0.2});
    figure.labels.push_back({{0.5, -0.25}, "\xce\xb1 = 1", Ink::Text});
    figure.labels.push_back({{2.0, -0.25}, "0.87", Ink::Text});
    figure.labels.push_back({{3.5, -0.25}, "0.44", Ink::Text});
    return figure;
}

Figure conformity() {
    Figure figure;
    const struct {
        double y, length;
        std::string_view text;
    } rows[] = {{1.4, 2.0, "L = \xcf\x81: \xce\xb4 = 1"},
                {0.7, 1.0, "L = \xcf\x81/2: \xce\xb4 = 0.5"},
                {0.0, 4.0, "L = 2\xcf\x81: \xce\xb4 = 0.5"}};
    for (const auto &row : rows) {
        add(figure, Ink::Edge, {{0, row.y}, {row.length, row.y}});
        dot(figure, {0, row.y}, Ink::Edge);
        dot(figure, {row.length, row.y}, Ink::Edge);
        figure.labels.push_back({{1.2, row.y + 0.25}, row.text, Ink::Text});
    }
    return figure;
}

Figure grid() {
    Figure figure;
    lattice(figure, {0, 0}, 1.0, 4, 3);
    lattice(figure, {1, 1}, 0.5, 2, 2);
    add(figure, Ink::Front, {{0.2, 0.3}, {1.2, 1.1}, {1.5, 1.4}, {1.9, 1.6}, {3.2, 2.4}, {3.8, 2.7}});
    return figure;
}

Figure neighbours() {
    Figure figure;
    lattice(figure, {0, 0}, 1.0, 4, 3);
    add(figure, Ink::Edge, {{0.1, 2.7}, {0.8, 2.2}});
    add(figure, Ink::Front, {{0.8, 2.2}, {1.3, 1.5}, {2.1, 1.2}, {2.8, 1.6}});
    add(figure, Ink::Edge, {{2.8, 1.6}, {3.9, 2.6}});
    circle(figure, {1.9, 1.8}, 0.7, Ink::Candidate);
    return figure;
}

Figure rejection() {
    Figure figure;
    valley(figure);
    add(figure, Ink::Front, {{0.6, 1.6}, {0.1, 0.55}, {-0.9, 1.5}});
    add(figure, Ink::Rejected, {{-0.5, 0}, {0, kHeight}, {0.5, 0}});
    dot(figure, {0, kHeight}, Ink::Rejected);
    return figure;
}

Figure deferral() {
    Figure figure;
    valley(figure);
    add(figure, Ink::Front, {{1.4, 1.6}, {0.0, 0.22}, {-1.4, 1.6}});
    add(figure, Ink::Rejected, {{-0.5, 0}, {0, 0.5}, {0.5, 0}});
    figure.labels.push_back({{0, -0.55}, "back to the list", Ink::Text});
    return figure;
}

Figure closing() {
    Figure figure;
    const std::vector<Vec2> loop = {{0, 0}, {1.1, -0.2}, {2, 0.4}, {1.6, 1.3}, {0.4, 1.2}};
    element(figure, loop[0], loop[1], loop[4]);
    element(figure, loop[1], loop[3], loop[4]);
    add(figure, Ink::Front, {loop[1], loop[2], loop[3], loop[1]});
    figure.labels.push_back({{1.6, 0.5}, "last", Ink::Front});
    return figure;
}

Figure gradation() {
    Figure figure;
    add(figure, Ink::Cell, {{0, 0}, {4, 0}});
    add(figure, Ink::Rejected, {{0, 1.6}, {1.5, 1.6}, {1.5, 0.3}, {2.5, 0.3}, {2.5, 1.6}, {4, 1.6}});
    add(figure, Ink::Accepted, {{0, 0.75}, {1.5, 0.3}, {2.5, 0.3}, {4, 0.75}});
    figure.labels.push_back({{0.6, 1.8}, "\xcf\x81 as given", Ink::Rejected});
    figure.labels.push_back({{0.5, 0.85}, "limited", Ink::Accepted});
    return figure;
}

Figure methods() {
    Figure figure;
    element(figure, {0, 0}, {1, 0}, {0.5, kHeight});
    figure.labels.push_back({{0.5, -0.25}, "classic: one", Ink::Text});
    element(figure, {2, 0}, {3, 0}, {3, 1});
    element(figure, {3, 0}, {4, 0}, {3, 1});
    element(figure, {4, 0}, {4, 1}, {3, 1});
    figure.labels.push_back({{3, -0.25}, "fast: up to three", Ink::Text});
    dot(figure, {3, 1}, Ink::Accepted);
    dot(figure, {0.5, kHeight}, Ink::Accepted);
    return figure;
}

Figure improvement() {
    Figure figure;
    const Vec2 a{0, 0}, b{1.6, -0.2}, c{1.7, 0.7}, d{0.1, 0.9}, move{2.6, 0};
    element(figure, a, b, c);
    element(figure, a, c, d);
    element(figure, a + move, b + move, d + move);
    element(figure, b + move, c + move, d + move);
    add(figure, Ink::Rejected, {a, c});
    add(figure, Ink::Accepted, {b + move, d + move});
    return figure;
}

/// A prism and Schönhardt's, side by side, each in an oblique view: the twist, the folded sides, and in red a diagonal
/// that runs outside.
Figure schoenhardt() {
    constexpr double kTwist = std::numbers::pi / 6.0, kTall = 1.5, kApart = 4.2;
    Figure figure;
    const auto corner = [](double around, double up, double right) {
        const Vec2 flat{std::cos(around), std::sin(around)};
        return Vec2{flat.x + right, 0.35 * flat.y + up};
    };
    for (const bool twisted : {false, true}) {
        std::vector<Vec2> low, high;
        for (int k = 0; k < 3; ++k) {
            const double around = std::numbers::pi * (2.0 * k / 3.0 + 0.4);
            low.push_back(corner(around, 0.0, twisted ? kApart : 0.0));
            high.push_back(corner(around + (twisted ? kTwist : 0.0), kTall, twisted ? kApart : 0.0));
        }
        add(figure, Ink::Edge, low, true);
        add(figure, Ink::Boundary, high, true);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            add(figure, Ink::Edge, {low[k], high[k]});
            add(figure, Ink::Candidate, {low[k], high[next]});
        }
        if (twisted) {
            add(figure, Ink::Rejected, {low[1], high[0]});
        }
        for (const Vec2 at : low) {
            dot(figure, at, Ink::Edge);
        }
        for (const Vec2 at : high) {
            dot(figure, at, Ink::Boundary);
        }
    }
    figure.labels.push_back({{0.0, -0.7}, "prism", Ink::Text});
    figure.labels.push_back({{kApart, -0.7}, "twisted by 30 degrees", Ink::Text});
    return figure;
}

/// Adds a function that rises steeply at x = 4, and the straight pieces between its values at some nodes.
void interpolated(Figure &figure, double up, Ink ink, const std::vector<double> &nodes) {
    const auto place = [up](double x) { return Vec2{x, up + 0.5 * std::atan(2.0 * (x - 4.0))}; };
    constexpr int kPieces = 60;
    std::vector<Vec2> curve, chords;
    for (int k = 0; k <= kPieces; ++k) {
        curve.push_back(place(8.0 * k / kPieces));
    }
    for (const double x : nodes) {
        chords.push_back(place(x));
        dot(figure, place(x), ink);
    }
    add(figure, Ink::Edge, curve);
    add(figure, ink, chords);
}

Figure adaptation() {
    Figure figure;
    interpolated(figure, 2.4, Ink::Rejected, {0, 1.6, 3.2, 4.8, 6.4, 8});
    interpolated(figure, 0.0, Ink::Accepted, {0, 2.6, 3.5, 3.85, 4.15, 4.5, 5.4, 8});
    figure.labels.push_back({{1.6, 2.6}, "one size", Ink::Rejected});
    figure.labels.push_back({{1.6, 0.2}, "adapted", Ink::Accepted});
    return figure;
}

Figure strips() {
    constexpr double kWide = 1.5, kTall = 2.0;
    Figure figure;
    for (int k = 0; k <= 4; ++k) {
        add(figure, Ink::Cell, {{k * kWide, 0}, {k * kWide, kTall}});
        if (k < 4) {
            add(figure, Ink::Candidate, {{(k + 0.5) * kWide, -0.3}, {(k + 0.5) * kWide, 0}});
        }
    }
    add(figure, Ink::Boundary, {{0, 0}, {4 * kWide, 0}, {4 * kWide, kTall}, {0, kTall}}, true);
    const Vec2 inside{0.5 * kWide, 1.3}, seam{2.0 * kWide, 1.3};
    for (const Vec2 middle : {inside, seam}) {
        add(figure, Ink::Base, {middle - Vec2{0.2, 0}, middle + Vec2{0.2, 0}});
        circle(figure, middle, 0.5, middle.x == inside.x ? Ink::Accepted : Ink::Rejected);
    }
    figure.labels.push_back({{inside.x, 0.4}, "now", Ink::Accepted});
    figure.labels.push_back({{seam.x, 0.4}, "waits", Ink::Rejected});
    return figure;
}

} // namespace figures

} // namespace forefront
