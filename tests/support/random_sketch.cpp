#include "tests/support/random_sketch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace forefront::tests {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kHolds = 1e-9;

Vec2 turned(Vec2 v, double angle) {
    return {std::cos(angle) * v.x - std::sin(angle) * v.y, std::sin(angle) * v.x + std::cos(angle) * v.y};
}

double angleBetween(Vec2 d, Vec2 e) {
    return std::atan2(cross(d, e), dot(d, e));
}

/// Draws closed paths; corners may be rounded by tangent arcs.
class SketchPen {
  public:
    explicit SketchPen(RandomSketch &sketch) : sketch_(sketch), system_(sketch.system) {}

    SketchPoint point(Vec2 at) {
        sketch_.points.push_back(system_.addPoint(at));
        return sketch_.points.back();
    }
    void circle(Vec2 centre, double radius) {
        const SketchPoint at = point(centre);
        system_.circles.emplace_back(at, system_.addUnknown(radius, UnknownKind::Length));
    }
    void path(const std::vector<Vec2> &places, const std::vector<bool> &round, double radius) {
        const std::size_t n = places.size();
        std::vector<std::pair<SketchPoint, SketchPoint>> ends; // of the edges at each corner
        for (std::size_t k = 0; k < n; ++k) {
            ends.push_back(corner(places[(k + n - 1) % n], places[k], places[(k + 1) % n], round[k], radius));
        }
        for (std::size_t k = 0; k < n; ++k) {
            const auto &[in, out] = ends[k];
            system_.edges.emplace_back(out, ends[(k + 1) % n].first);
            const SketchPoint before = ends[(k + n - 1) % n].second;
            system_.corners.push_back({before, in, in == out ? ends[(k + 1) % n].first : out});
        }
    }

  private:
    std::pair<SketchPoint, SketchPoint> corner(Vec2 a, Vec2 b, Vec2 c, bool round, double radius) {
        const double la = distance(a, b), lc = distance(b, c);
        const Vec2 u = (1.0 / la) * (a - b), v = (1.0 / lc) * (c - b);
        const double half = 0.5 * std::acos(std::clamp(dot(u, v), -1.0, 1.0)), cut = radius / std::tan(half);
        if (!round || cut > 0.35 * std::min(la, lc)) {
            const SketchPoint p = point(b);
            return {p, p};
        }
        const SketchPoint in = point(b + cut * u), out = point(b + cut * v);
        const Vec2 middle = u + v;
        const SketchPoint centre = system_.addPoint(b + (radius / std::sin(half) / length(middle)) * middle);
        const std::uint32_t r = system_.addUnknown(radius, UnknownKind::Length);
        system_.circles.emplace_back(centre, r);
        system_.addEquation(makeOnCircle(in, centre, r), 0);
        system_.addEquation(makeOnCircle(out, centre, r), 0);
        system_.corners.push_back({in, centre, out});
        return {in, out};
    }

    RandomSketch &sketch_;
    SketchSystem &system_;
};

std::vector<bool> roundedCorners(std::size_t count, double share, SketchDice &dice) {
    std::vector<bool> round(count);
    for (std::size_t k = 0; k < count; ++k) {
        round[k] = dice.number() < share;
    }
    return round;
}

void drawProfile(SketchPen &pen, double turn, SketchDice &dice) {
    const std::size_t steps = 2 + dice.below(4);
    std::vector<double> widths, heights;
    double x = 0.0;
    for (std::size_t k = 0; k < steps; ++k) {
        widths.push_back(dice.number(0.5, 2.0));
        double height = dice.number(0.5, 3.0);
        if (k > 0 && std::fabs(height - heights.back()) < 0.3) {
            height = heights.back() + 0.5;
        }
        heights.push_back(height);
        x += widths.back();
    }
    std::vector<Vec2> places = {{0.0, 0.0}, {x, 0.0}};
    for (std::size_t k = 0; k < steps; ++k) {
        places.push_back({x, heights[k]});
        x = k + 1 == steps ? 0.0 : x - widths[k];
        places.push_back({x, heights[k]});
    }
    for (Vec2 &place : places) {
        place = turned(place, turn);
    }
    pen.path(places, roundedCorners(places.size(), 0.3, dice), 0.12);
}

void drawStar(SketchPen &pen, SketchDice &dice) {
    const std::size_t n = 4 + dice.below(7);
    std::vector<Vec2> places;
    for (std::size_t k = 0; k < n; ++k) {
        const double angle = kTurn * (static_cast<double>(k) + dice.number(-0.25, 0.25)) / static_cast<double>(n);
        places.push_back(turned({dice.number(1.0, 2.0), 0.0}, angle));
    }
    pen.path(places, roundedCorners(n, 0.3, dice), 0.1);
}

void drawPlate(SketchPen &pen, double turn, SketchDice &dice) {
    const double w = dice.number(3.0, 6.0), h = dice.number(2.0, 4.0);
    const double inset = dice.number(0.4, 0.7), radius = dice.number(0.1, 0.25);
    pen.path({turned({0.0, 0.0}, turn), turned({w, 0.0}, turn), turned({w, h}, turn), turned({0.0, h}, turn)},
             roundedCorners(4, 0.5, dice), 0.3);
    for (const Vec2 at :
         {Vec2{inset, inset}, Vec2{w - inset, inset}, Vec2{inset, h - inset}, Vec2{w - inset, h - inset}}) {
        pen.circle(turned(at, turn), radius);
        if (dice.below(3) == 0) {
            pen.circle(turned(at, turn), 0.5 * radius);
        }
    }
    if (dice.below(2) == 0) {
        pen.circle(turned({0.5 * w, 0.5 * h}, turn), 0.25 * std::min(w, h));
    }
}

void drawTruss(SketchPen &pen, SketchSystem &system, SketchDice &dice) {
    const std::size_t n = 3 + dice.below(5);
    std::vector<SketchPoint> low, high;
    for (std::size_t k = 0; k < n; ++k) {
        const auto x = static_cast<double>(k);
        const double dx = dice.number(-0.15, 0.15), dy = dice.number(-0.15, 0.15);
        low.push_back(pen.point({x + dx, dy}));
        const double ex = dice.number(-0.15, 0.15), ey = dice.number(-0.2, 0.2);
        high.push_back(pen.point({x + 0.5 + ex, 0.9 + ey}));
    }
    for (std::size_t k = 0; k < n; ++k) {
        system.edges.emplace_back(low[k], high[k]);
        if (k + 1 < n) {
            system.edges.emplace_back(low[k], low[k + 1]);
            system.edges.emplace_back(high[k], high[k + 1]);
            system.edges.emplace_back(high[k], low[k + 1]);
            system.corners.push_back({low[k], high[k], low[k + 1]});
        }
    }
}

/// Collects constraints that hold in a sketch.
class CandidateFinder {
  public:
    CandidateFinder(const RandomSketch &sketch, SketchDice &dice)
        : sketch_(sketch), system_(sketch.system), dice_(dice) {}

    std::vector<SketchCandidate> find() {
        for (std::size_t k = 0; k < system_.edges.size(); ++k) {
            addOfEdge(k);
        }
        for (std::size_t k = 0; k < system_.circles.size(); ++k) {
            addOfCircle(k);
        }
        for (std::size_t k = 0; k < 4 * sketch_.points.size(); ++k) {
            addOfPoint();
        }
        for (int k = 0; k < 200; ++k) {
            addSymmetry();
        }
        dice_.shuffle(geometric_);
        dice_.shuffle(local_);
        dice_.shuffle(distant_);
        geometric_.insert(geometric_.end(), local_.begin(), local_.end());
        geometric_.insert(geometric_.end(), distant_.begin(), distant_.end());
        return std::move(geometric_);
    }

  private:
    Vec2 at(SketchPoint p) const { return system_.place(p); }
    void geometric(std::vector<SketchEquation> equations) { geometric_.push_back({std::move(equations), false}); }
    void local(SketchEquation equation) { local_.push_back({{equation}, true}); }

    void addOfEdge(std::size_t k) {
        const auto &[a, b] = system_.edges[k];
        const Vec2 d = at(b) - at(a);
        if (std::fabs(d.y) < kHolds) {
            geometric({makeEqual(a.y, b.y)});
        }
        if (std::fabs(d.x) < kHolds) {
            geometric({makeEqual(a.x, b.x)});
        }
        local(makeDistance(a, b, length(d)));
        const std::size_t n = system_.edges.size();
        addOfEdges(k, (k + 1) % n, true);
        addOfEdges(k, dice_.below(n), false);
        addOfEdges(k, dice_.below(n), false);
        for (const auto &[centre, radius] : system_.circles) {
            addTangent(a, b, centre, radius);
        }
    }

    void addOfEdges(std::size_t k, std::size_t j, bool next) {
        if (k == j) {
            return;
        }
        const auto &[a, b] = system_.edges[k];
        const auto &[p, q] = system_.edges[j];
        const Vec2 d = at(b) - at(a), e = at(q) - at(p);
        const double scale = length(d) * length(e), angle = angleBetween(d, e);
        const bool parallel = std::fabs(cross(d, e)) < kHolds * scale;
        if (parallel || std::fabs(dot(d, e)) < kHolds * scale) {
            geometric({makeAngle(a, b, p, q, 0.25 * kTurn * std::round(angle / (0.25 * kTurn)))});
        } else if (next) {
            local(makeAngle(a, b, p, q, angle));
        }
        if (parallel && std::fabs(length(d) - length(e)) < kHolds) {
            geometric({makeEqualLength(a, b, p, q)});
        }
    }

    void addTangent(SketchPoint a, SketchPoint b, SketchPoint centre, std::uint32_t radius) {
        const Vec2 d = at(b) - at(a);
        const double height = cross(d, at(centre) - at(a)) / length(d), r = system_.values[radius];
        if (std::fabs(std::fabs(height) - r) > kHolds) {
            return;
        }
        for (const SketchPoint end : {a, b}) { // at an end, the radius is perpendicular: the distance has a double root
            if (std::fabs(distance(at(end), at(centre)) - r) < kHolds) {
                geometric({makeAngle(a, b, centre, end, height > 0.0 ? -0.25 * kTurn : 0.25 * kTurn)});
                return;
            }
        }
        geometric({makeTangentLine(centre, radius, a, b, height > 0.0 ? 1.0 : -1.0)});
    }

    void addOfCircle(std::size_t k) {
        const auto &[centre, radius] = system_.circles[k];
        local(makeValue(radius, system_.values[radius]));
        for (std::size_t j = 0; j < k; ++j) {
            const auto &[other, otherRadius] = system_.circles[j];
            if (std::fabs(system_.values[radius] - system_.values[otherRadius]) < kHolds) {
                geometric({makeEqual(radius, otherRadius)});
            }
            if (distance(at(centre), at(other)) < kHolds) {
                geometric({makeEqual(centre.x, other.x), makeEqual(centre.y, other.y)});
            }
        }
    }

    void addOfPoint() {
        const SketchPoint p = sketch_.points[dice_.below(sketch_.points.size())];
        const SketchPoint q = sketch_.points[dice_.below(sketch_.points.size())];
        const auto &[a, b] = system_.edges[dice_.below(system_.edges.size())];
        if (distance(at(p), at(q)) > 0.3) {
            distant_.push_back({{makeDistance(p, q, distance(at(p), at(q)))}, true});
        }
        if (p == a || p == b) {
            return;
        }
        const double height = cross(at(b) - at(a), at(p) - at(a)) / distance(at(a), at(b));
        if (std::fabs(height) < kHolds) {
            geometric({makePointLine(p, a, b, 0.0, 1.0)});
        } else if (std::fabs(height) > 0.2) {
            distant_.push_back({{makePointLine(p, a, b, std::fabs(height), height > 0.0 ? 1.0 : -1.0)}, true});
        }
    }

    void addSymmetry() {
        const SketchPoint p = sketch_.points[dice_.below(sketch_.points.size())];
        const SketchPoint q = sketch_.points[dice_.below(sketch_.points.size())];
        const auto &[a, b] = system_.edges[dice_.below(system_.edges.size())];
        const SketchEquation across = makeMirrorAcross(p, q, a, b), along = makeMirrorAlong(p, q, a, b);
        if (distance(at(p), at(q)) > 0.2 && std::fabs(system_.residual(across)) < kHolds &&
            std::fabs(system_.residual(along)) < kHolds) {
            geometric({across, along});
        }
    }

    const RandomSketch &sketch_;
    const SketchSystem &system_;
    SketchDice &dice_;
    std::vector<SketchCandidate> geometric_, local_, distant_;
};

} // namespace

double SketchDice::number(double a, double b) {
    return a + (b - a) * (static_cast<double>(engine_() >> 11) / 9007199254740992.0);
}

void RandomSketch::add(std::vector<SketchEquation> equations) {
    ++constraints;
    for (const SketchEquation &equation : equations) {
        system.addEquation(equation, constraints);
    }
}

RandomSketch randomShapes(SketchDice &dice) {
    RandomSketch sketch;
    SketchPen pen(sketch);
    const double turn = dice.below(2) == 0 ? 0.0 : dice.number(0.0, kTurn);
    switch (dice.below(4)) {
    case 0:
        drawProfile(pen, turn, dice);
        break;
    case 1:
        drawStar(pen, dice);
        break;
    case 2:
        drawPlate(pen, turn, dice);
        break;
    default:
        drawTruss(pen, sketch.system, dice);
    }
    return sketch;
}

std::vector<SketchCandidate> candidatesOf(const RandomSketch &sketch, SketchDice &dice) {
    return CandidateFinder(sketch, dice).find();
}

bool IndependentRows::add(const SketchSystem &system, const std::vector<SketchEquation> &equations, double least) {
    const std::size_t before = rows_.size();
    for (const SketchEquation &equation : equations) {
        std::array<double, kEquationUnknowns> values{}, slopes{};
        for (std::size_t k = 0; k < equation.used().size(); ++k) {
            values[k] = system.values[equation.used()[k]];
        }
        residualOf(equation, values.data(), slopes.data());
        std::vector<double> row(columns_, 0.0);
        for (std::size_t k = 0; k < equation.used().size(); ++k) {
            row[equation.used()[k]] += slopes[k];
        }
        const auto normalise = [&row] {
            double squares = 0.0;
            for (const double value : row) {
                squares += value * value;
            }
            for (double &value : row) {
                value /= squares > 0.0 ? std::sqrt(squares) : 1.0;
            }
            return std::sqrt(squares);
        };
        normalise();
        for (int pass = 0; pass < 2; ++pass) {
            for (const std::vector<double> &other : rows_) {
                double product = 0.0;
                for (std::size_t k = 0; k < columns_; ++k) {
                    product += row[k] * other[k];
                }
                for (std::size_t k = 0; k < columns_; ++k) {
                    row[k] -= product * other[k];
                }
            }
        }
        if (rows_.size() >= columns_ || normalise() < least) {
            rows_.resize(before);
            return false;
        }
        rows_.push_back(std::move(row));
    }
    return true;
}

void constrain(RandomSketch &sketch, SketchDice &dice, double share) {
    constexpr double kLeast = 0.02;
    SketchSystem &system = sketch.system;
    const std::size_t n = system.values.size();
    IndependentRows rows(n);
    for (const SketchEquation &equation : std::vector(system.equations)) {
        rows.add(system, {equation}, kHolds);
    }
    const auto tryAll = [&](std::size_t target) {
        for (const SketchCandidate &candidate : candidatesOf(sketch, dice)) {
            if (rows.size() < target && rows.add(system, candidate.equations, kLeast)) {
                sketch.add(candidate.equations);
            }
        }
    };
    if (share < 1.0) {
        tryAll(static_cast<std::size_t>(share * static_cast<double>(n - 3)));
        return;
    }
    const auto [a, b] = system.edges.front();
    const Vec2 d = system.place(b) - system.place(a);
    for (const std::uint32_t unknown : {a.x, a.y, std::fabs(d.x) > std::fabs(d.y) ? b.y : b.x}) {
        const SketchEquation fixed = makeValue(unknown, system.values[unknown]);
        if (rows.add(system, {fixed}, kLeast)) {
            sketch.add({fixed});
        }
    }
    for (int round = 0; round < 20 && rows.size() < n; ++round) {
        tryAll(n);
    }
}

std::vector<double> perturbed(const SketchSystem &system, SketchDice &dice, double share) {
    std::vector<double> room(system.values.size(), std::numeric_limits<double>::infinity());
    double mean = 0.0;
    for (const auto &[a, b] : system.edges) {
        const double length = distance(system.place(a), system.place(b));
        mean += length / static_cast<double>(system.edges.size());
        for (const std::uint32_t unknown : {a.x, a.y, b.x, b.y}) {
            room[unknown] = std::min(room[unknown], length);
        }
    }
    for (const auto &[centre, radius] : system.circles) {
        for (const std::uint32_t unknown : {centre.x, centre.y, radius}) {
            room[unknown] = std::min(room[unknown], system.values[radius]);
        }
    }
    std::vector<double> values = system.values;
    for (std::size_t k = 0; k < values.size(); ++k) {
        values[k] += dice.number(-share, share) * std::min(room[k], mean);
    }
    return values;
}

std::size_t flips(const SketchSystem &system, const std::vector<double> &known, const std::vector<double> &start,
                  const std::vector<double> &end) {
    const auto turn = [](const std::vector<double> &values, const SketchCorner &c) {
        const auto at = [&values](SketchPoint p) { return Vec2{values[p.x], values[p.y]}; };
        return turnAt(at(c.a), at(c.b), at(c.c));
    };
    std::size_t count = 0;
    for (const SketchCorner &corner : system.corners) {
        const double a = turn(known, corner), b = turn(start, corner), c = turn(end, corner);
        count += std::fabs(a) > 0.1 && std::fabs(b) > 0.02 && a * b > 0.0 && a * c < 0.0 ? 1 : 0;
    }
    return count;
}

RandomSketch steppedProfile(std::size_t constraints) {
    constexpr double kRadius = 0.12;
    RandomSketch sketch;
    SketchSystem &system = sketch.system;
    SketchPen pen(sketch);
    const std::size_t steps = std::max<std::size_t>(2, (constraints + 5) / 11);
    std::vector<Vec2> places = {{0.0, 0.0}, {static_cast<double>(steps), 0.0}};
    for (std::size_t k = 0; k < steps; ++k) {
        const double x = static_cast<double>(steps - k), y = 0.6 * static_cast<double>(k + 1);
        places.push_back({x, y});
        places.push_back({x - 1.0, y});
    }
    std::vector<bool> round(places.size(), false);
    for (std::size_t k = 2; k < places.size(); k += 2) {
        round[k] = true;
    }
    pen.path(places, round, kRadius);
    const auto edges = system.edges;
    const auto arcs = system.circles;
    sketch.add({makeValue(edges[0].first.x, 0.0), makeValue(edges[0].first.y, 0.0)});
    sketch.add({makeEqual(edges[0].first.y, edges[0].second.y)});
    for (std::size_t k = 0; k < steps; ++k) {
        const auto &[a, b] = edges[2 * k + 1]; // riser
        const auto &[p, q] = edges[2 * k + 2]; // tread
        const auto &[centre, radius] = arcs[k];
        sketch.add({makeEqual(a.x, b.x)});
        sketch.add({makeEqual(p.y, q.y)});
        sketch.add({makeAngle(a, b, centre, b, -0.25 * kTurn)});
        sketch.add({makeAngle(p, q, centre, p, -0.25 * kTurn)});
        if (k > 0) {
            sketch.add({makeEqual(arcs[k - 1].second, radius)});
            sketch.add({makeEqualLength(a, b, edges[2 * k - 1].first, edges[2 * k - 1].second)});
        }
        sketch.add({makeDistance(p, q, distance(system.place(p), system.place(q)))});
        const Vec2 hole = {static_cast<double>(steps - k) - 0.5, 0.6 * static_cast<double>(k + 1) - 0.3};
        pen.circle(hole, kRadius);
        const auto [middle, holeRadius] = system.circles.back();
        sketch.add({makePointLine(middle, p, q, 0.3, 1.0)});
        sketch.add({makePointLine(middle, a, b, 0.5, 1.0)});
        sketch.add({makeEqual(holeRadius, radius)});
    }
    return sketch;
}

} // namespace forefront::tests
