#include "core/engine/domain/add_loop.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/scaled_field.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/support/sanitizers.hpp"
#include "tests/support/spacing_samples.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <random>
#include <stop_token>
#include <thread>

using namespace forefront;
using namespace forefront::testing;

namespace {

Domain rectangle(double width, double height, int piecesX, int piecesY) {
    Domain domain;
    const auto side = [&](Vec2 from, Vec2 to, int pieces) {
        for (int i = 0; i < pieces; ++i) {
            domain.nodes.push_back(lerp(from, to, static_cast<double>(i) / pieces));
        }
    };
    side({0, 0}, {width, 0}, piecesX);
    side({width, 0}, {width, height}, piecesY);
    side({width, height}, {0, height}, piecesX);
    side({0, height}, {0, 0}, piecesY);
    const auto n = static_cast<std::uint32_t>(domain.nodes.size());
    for (std::uint32_t i = 0; i < n; ++i) {
        domain.segments.push_back({i, (i + 1) % n, 1, SegmentRole::Boundary});
    }
    return domain;
}

} // namespace

TEST_CASE("SpacingField: a constant spacing is the same everywhere and is reported as constant") {
    SpacingSpec spec;
    spec.size = 0.3;
    const auto field = fieldOf(spec, rectangle(2, 1, 4, 2));
    CHECK(field->at({0.1, 0.2}) == 0.3);
    CHECK(field->minimum() == 0.3);
    CHECK(field->maximum() == 0.3);
    CHECK(field->sample({1, 1}).origin == SpacingOrigin::Constant);
}

TEST_CASE("SpacingField: sources, constant and expression combine by minimum and are clamped") {
    SpacingSpec spec;
    spec.size = 1.0;
    spec.expression = "0.5 + 0.1*x";
    spec.minimum = 0.08;
    spec.sources.push_back({SourceShape::Point, {3, 3}, {}, 0.0, 0.05, 0.2, "pier head"});
    spec.sources.push_back({SourceShape::Line, {0, 9}, {10, 9}, 0.5, 0.2, 0.3, ""});
    spec.sources.push_back({SourceShape::Circle, {8, 2}, {}, 1.0, 0.1, 0.5, "tank"});
    const auto field = fieldOf(spec, rectangle(10, 10, 4, 4));
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0.0, 10.0);
    for (int i = 0; i < 2000; ++i) {
        const Vec2 p{place(random), place(random)};
        const double point = 0.05 + 0.2 * distance(p, {3, 3});
        const double line = 0.2 + 0.3 * std::max(0.0, std::fabs(p.y - 9) - 0.5);
        const double circle = 0.1 + 0.5 * std::max(0.0, distance(p, {8, 2}) - 1.0);
        const double expected = std::max(0.08, std::min({1.0, 0.5 + 0.1 * p.x, point, line, circle}));
        CHECK(field->at(p) == doctest::Approx(expected).epsilon(1e-12));
        CHECK(field->at(p) >= field->minimum());
        CHECK(field->at(p) <= field->maximum());
        CHECK(field->sample(p).rho == field->at(p));
    }
    CHECK(field->sample({3, 3}).describe == "minimum spacing");
    CHECK(field->sample({3.5, 3}).describe == "source 'pier head'");
    CHECK(field->sample({5, 9.6}).describe == "source 1");
    CHECK(field->sample({0.5, 6}).describe == "expression 0.5 + 0.1*x");
}

TEST_CASE("SpacingField: a sample names the rule with the next larger size") {
    Domain domain = rectangle(8, 4, 1, 1);
    domain.segments[1].tag = 5; // from (8, 0) to (8, 4)
    domain.boundaryNames[5] = "outlet";
    SpacingSpec spec;
    spec.size = 1.0;
    const auto constant = fieldOf(spec, domain);
    CHECK_FALSE(constant->sample({4, 2}).runnerUp);
    spec.sources.push_back({SourceShape::Point, {2, 2}, {}, 0.0, 0.25, 0.25, "pier"});
    spec.partSizes = {{5, {0.125, 0.25}}};
    const auto field = fieldOf(spec, domain);
    const auto check = [&](Vec2 p, const char *winner, double rho, const char *next) {
        const SpacingSample sample = field->sample(p);
        CHECK(sample.describe == winner);
        CHECK(sample.rho == field->at(p));
        REQUIRE(sample.runnerUp);
        CHECK(sample.runnerUp->rho == doctest::Approx(rho));
        CHECK(sample.runnerUp->describe == next);
    };
    check({2, 2}, "source 'pier'", 1.0, "constant"); // the size of the outlet would be 1.625
    check({4.5, 2}, "source 'pier'", 1.0, "constant");
    check({5, 2}, "size of 'outlet'", 1.0, "constant"); // 0.875; the source asks for 1.0 as well
    check({6, 2}, "size of 'outlet'", 1.0, "constant");
    check({4.8, 2}, "size of 'outlet'", 0.95, "source 'pier'"); // 0.925
    check({4.7, 2}, "source 'pier'", 0.95, "size of 'outlet'"); // 0.925
    check({0, 0}, "source 'pier'", 1.0, "constant");
    spec.size = 0.1;
    const auto fine = fieldOf(spec, domain);
    CHECK(fine->sample({2, 2}).describe == "constant");
    CHECK(fine->sample({2, 2}).runnerUp->describe == "source 'pier'");
    CHECK(scaledField(fine, 2.0)->sample({2, 2}).runnerUp->rho == doctest::Approx(0.5));
}

TEST_CASE("SpacingField: the lengths of all boundary segments are one rule, with sites in a list and in a tree") {
    for (const int pieces : {5, 500}) {
        CAPTURE(pieces);
        SpacingSpec spec;
        spec.fromBoundary = true;
        spec.size = 5.0;
        const auto field = fieldOf(spec, rectangle(10, 10, pieces, pieces));
        for (const Vec2 p : {Vec2{5, 0.1}, Vec2{0.3, 0.2}, Vec2{9.9, 7}}) {
            const SpacingSample sample = field->sample(p);
            CHECK(sample.describe.starts_with("length of a segment of 'boundary_1' at ("));
            REQUIRE(sample.runnerUp);
            CHECK(sample.runnerUp->rho == 5.0);
            CHECK(sample.runnerUp->describe == "constant");
        }
    }
}

TEST_CASE("SpacingField: automatic spacing respects short segments and is graded") {
    const Domain domain = rectangle(10, 5, 200, 5);
    const auto field = fieldOf({}, domain);
    CHECK(field->at({5, 0}) == doctest::Approx(0.05).epsilon(0.01));
    CHECK(field->maximum() <= 0.5);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(0.0, 1.0);
    for (int i = 0; i < 20000; ++i) {
        const Vec2 p{10 * place(random), 5 * place(random)};
        const double reach = i % 2 == 0 ? 10.0 : 0.1;
        const Vec2 q{std::clamp(p.x + reach * (place(random) - 0.5), 0.0, 10.0),
                     std::clamp(p.y + reach * (place(random) - 0.5), 0.0, 5.0)};
        CHECK(std::fabs(field->at(p) - field->at(q)) <= 0.25 * distance(p, q) + 0.012 * field->at(p));
    }
}

TEST_CASE("SpacingField: a faulty expression is refused with its column") {
    SpacingSpec spec;
    spec.expression = "0.1 + * x";
    const auto field = SpacingField::build(spec, rectangle(1, 1, 1, 1));
    REQUIRE(!field.ok());
    CHECK(field.faults().front().code == "expression-syntax");
    CHECK(field.faults().front().advice.find("dist(a, b)") != std::string::npos);
    CHECK(field.faults().front().column == 7);
}

TEST_CASE("SpacingField: an expression without a positive value somewhere is refused with the place") {
    SpacingSpec spec;
    spec.expression = "x - 0.25";
    const auto field = SpacingField::build(spec, rectangle(1, 1, 1, 1));
    REQUIRE(!field.ok());
    CHECK(field.faults().front().code == "expression-value");
    REQUIRE(field.faults().front().at.has_value());
    CHECK(field.faults().front().at->x <= 0.25);
}

TEST_CASE("SpacingField: an expression that elements can follow is left exactly as given") {
    SpacingSpec spec;
    spec.expression = "max(0.1, 0.48*abs(dist(5, 5) - 3))";
    const auto field = fieldOf(spec, rectangle(10, 10, 1, 1));
    for (double x = 0.05; x < 10.0; x += 0.37) {
        CHECK(field->at({x, 4.2}) ==
              doctest::Approx(std::max(0.1, 0.48 * std::fabs(distance({x, 4.2}, {5, 5}) - 3))).epsilon(1e-14));
    }
    CHECK(field->minimum() <= 0.1);
    CHECK(field->maximum() >= 0.48 * (std::sqrt(50.0) - 3));
    CHECK(field->maximum() <= 0.48 * (std::sqrt(50.0) - 3) * 1.1);
    CHECK(field->notes().empty());
}

TEST_CASE(
    "SpacingField: an expression that elements cannot follow is limited, with a note, unless a gradation is given") {
    const Domain domain = rectangle(1, 1, 1, 1);
    SpacingSpec spec;
    spec.expression = "max(0.01, 2*sqrt((x-.5)^2+(y-.5)^2))";
    const auto field = fieldOf(spec, domain);
    for (const Vec2 p : {Vec2{0, 0}, Vec2{0.5, 0.9}, Vec2{0.1, 0.45}, Vec2{0.52, 0.5}}) {
        const double expected = 0.01 + 0.5 * (distance(p, {0.5, 0.5}) - 0.005); // 0.01 within 0.005
        CHECK(field->at(p) == doctest::Approx(expected).epsilon(0.03));
    }
    CHECK(field->at({0.5, 0.5}) == 0.01);
    CHECK(field->sample({0.9, 0.9}).describe.starts_with("limited by gradation 0.5 from the expression at (0.50"));
    REQUIRE(field->notes().size() == 1);
    CHECK(field->notes().front().severity == Severity::Note);
    CHECK(field->notes().front().message == "the spacing expression changes by more than 0.5 per unit of distance, "
                                            "which elements cannot follow; limited to 0.5");
    CHECK(field->notes().front().advice == "set a gradation for another limit");
    spec.gradation = 2.5;
    const auto steep = fieldOf(spec, domain);
    CHECK(steep->at({0, 0}) == doctest::Approx(std::sqrt(2.0)));
    CHECK(steep->notes().empty());
}

TEST_CASE("SpacingField: a note tells of growths of sources and boundary parts that elements cannot follow") {
    const Domain domain = rectangle(10, 10, 1, 1);
    SpacingSpec spec;
    spec.sources.push_back({SourceShape::Point, {5, 5}, {}, 0.0, 0.05, 2.0, "well"});
    SizeSource gradient{SourceShape::Line, {0, 0}, {1, 0}, 0.0, 0.1, 0.0, ""};
    gradient.endSize = 5.0;
    gradient.plane = true;
    spec.sources.push_back(gradient);
    spec.partSizes = {{1, {0.2, 0.7}}};
    const auto field = fieldOf(spec, domain);
    CHECK(field->at({5, 5.1}) == doctest::Approx(0.25)); // as given
    std::vector<std::string> messages;
    for (const Diagnostic &note : field->notes()) {
        messages.push_back(note.message);
    }
    const std::string end = " per unit of distance, which elements cannot follow; expected at most 0.5";
    CHECK(messages == std::vector<std::string>{"size source 'well' grows by 2" + end,
                                               "size source 1 grows by 4.9" + end,
                                               "the size of 'boundary_1' grows by 0.7" + end});
    spec.gradation = 3.0;
    CHECK(fieldOf(spec, domain)->notes().empty());
    CHECK(fieldOf(spec, domain)->at({5, 5.1}) == doctest::Approx(0.25));
}

TEST_CASE("SpacingField: a steep expression is limited by the gradation formula within 2 %") {
    for (const char *const text : {"max(0.05, 2*abs(dist(5, 5) - 3))", "x + y < 8 ? 0.1 : 1.5", "0.1 + x^2/20",
                                   "0.5 + 0.4*sin(3*x)*cos(2*y)", "0.3"}) {
        SpacingSpec spec;
        spec.expression = text;
        const Domain domain = rectangle(10, 10, 1, 1);
        const auto plain = fieldOf(spec, domain);
        spec.gradation = 0.2;
        const auto limited = fieldOf(spec, domain);
        std::mt19937 random(31);
        std::uniform_real_distribution<double> place(0.0, 10.0);
        for (int n = 0; n < (forefront::testing::kSanitized ? 8 : 40); ++n) {
            const Vec2 p{place(random), place(random)};
            double expected = plain->at(p);
            for (int j = 0; j <= 1000; ++j) {
                for (int i = 0; i <= 1000; ++i) {
                    const Vec2 q{0.01 * i, 0.01 * j};
                    expected = std::min(expected, plain->at(q) + 0.2 * distance(p, q));
                }
            }
            CHECK_MESSAGE(limited->at(p) == doctest::Approx(expected).epsilon(0.02), text);
        }
    }
}

TEST_CASE("SpacingField: the foot of a steep slope is found on folds along the cells of the search, too") {
    struct Fold {
        const char *text;
        double (*expected)(Vec2);
    };
    constexpr double kSlope = 0.5; // that an expression is limited to
    const Fold folds[] = {
        {"max(0.01, 5*abs(x - 0.5))",
         [](Vec2 p) { return 0.01 + kSlope * std::max(0.0, std::fabs(p.x - 0.5) - 0.002); }},
        {"0.01 + 5*abs(y - 0.25)", [](Vec2 p) { return 0.01 + kSlope * std::fabs(p.y - 0.25); }},
        {"0.01 + 5*abs(x - 0.25) + 3*abs(y - 0.75)",
         [](Vec2 p) {
             return 0.01 + kSlope * distance(p, {0.25, 0.75});
         }},
    };
    const Domain domain = rectangle(1, 1, 1, 1);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0.0, 1.0);
    for (const auto &[text, expected] : folds) {
        CAPTURE(text);
        SpacingSpec spec;
        spec.expression = text;
        const auto field = fieldOf(spec, domain);
        for (int n = 0; n < 200; ++n) {
            const Vec2 p{place(random), place(random)};
            CHECK(field->at(p) == doctest::Approx(expected(p)).epsilon(0.03));
        }
    }
}

TEST_CASE("SpacingField: the gradation limits the difference between any two places") {
    SpacingSpec spec;
    spec.expression = "0.2 + 0.15*sin(5*x) + (y > 6 ? 0.7 : 0)";
    spec.sources.push_back({SourceShape::Point, {3, 3}, {}, 0.2, 0.02, 3.0, "steep"});
    spec.sources.push_back({SourceShape::Circle, {7, 8}, {}, 1.0, 0.05, 0.1, "gentle"});
    spec.minimum = 0.04;
    spec.maximum = 0.8;
    spec.gradation = 0.2;
    spec.fromBoundary = true;
    const auto field = fieldOf(spec, rectangle(10, 10, 40, 7));
    std::mt19937 random(12);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int i = 0; i < 20000; ++i) {
        const Vec2 p{10 * share(random), 10 * share(random)};
        const double reach = i % 2 == 0 ? 10.0 : 0.2;
        const Vec2 q{std::clamp(p.x + reach * (share(random) - 0.5), 0.0, 10.0),
                     std::clamp(p.y + reach * (share(random) - 0.5), 0.0, 10.0)};
        const double a = field->at(p);
        const double b = field->at(q);
        REQUIRE_MESSAGE(std::fabs(a - b) <= 0.2 * distance(p, q) + 0.025 * std::max(a, b),
                        "(" << p.x << ", " << p.y << ") " << field->sample(p).describe << ", (" << q.x << ", " << q.y
                            << ") " << field->sample(q).describe);
        REQUIRE(a >= 0.04);
        REQUIRE(a <= 0.8);
    }
}

TEST_CASE("SpacingField: a minimum makes an expression that falls to zero valid, and a maximum makes an unbounded one "
          "valid") {
    SpacingSpec spec;
    spec.expression = "0.3*abs(x - 5)";
    const Domain domain = rectangle(10, 10, 1, 1);
    CHECK(!SpacingField::build(spec, domain).ok());
    spec.minimum = 0.05;
    CHECK(fieldOf(spec, domain)->at({5, 5}) == 0.05);
    spec.expression = "1/x";
    spec.maximum = 2.0;
    spec.gradation = 100.0; // or the slope would be limited before
    CHECK(fieldOf(spec, domain)->at({0, 5}) == 2.0);
    spec.expression = "sqrt(x - 1)";
    const auto refused = SpacingField::build(spec, domain);
    REQUIRE(!refused.ok());
    CHECK(refused.faults().front().code == "expression-value");
    CHECK(refused.faults().front().at->x < 1.0);
}

TEST_CASE("SpacingField: values between the probes are always valid") {
    SpacingSpec spec;
    spec.expression = "abs(x - 0.501234) + abs(y - 0.301234)"; // zero at one place only
    const auto field = fieldOf(spec, rectangle(1, 1, 1, 1));
    CHECK(field->at({0.501234, 0.301234}) > 0.0);
    spec.expression = "x == 0.501234 ? sqrt(-1) : 1";
    CHECK(std::isfinite(fieldOf(spec, rectangle(1, 1, 1, 1))->at({0.501234, 0.3})));
}

TEST_CASE("SpacingField: many sources give the same as few, within the tolerance of the tree") {
    std::mt19937 random(77);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int round = 0; round < 5; ++round) {
        SpacingSpec spec;
        spec.size = 2.0;
        for (int i = 0; i < 10 + 200 * round; ++i) {
            const Vec2 a{10 * share(random), 10 * share(random)};
            spec.sources.push_back({i % 3 == 0   ? SourceShape::Point
                                    : i % 3 == 1 ? SourceShape::Line
                                                 : SourceShape::Circle,
                                    a, a + Vec2{share(random), share(random)}, 0.3 * share(random),
                                    0.01 + 0.3 * share(random), share(random), ""});
        }
        const auto field = fieldOf(spec, rectangle(10, 10, 1, 1));
        for (int i = 0; i < 3000; ++i) {
            const Vec2 p{10 * share(random), 10 * share(random)};
            double expected = 2.0;
            for (const SizeSource &source : spec.sources) {
                double d = distance(p, source.a);
                if (source.shape == SourceShape::Line) {
                    const Vec2 ab = source.b - source.a;
                    d = distance(p, source.a + std::clamp(dot(p - source.a, ab) / lengthSquared(ab), 0.0, 1.0) * ab);
                }
                expected = std::min(expected, source.size + source.growth * std::max(0.0, d - source.radius));
            }
            REQUIRE(field->at(p) == doctest::Approx(expected).epsilon(0.011));
            REQUIRE(field->at(p) >= field->minimum() * (1.0 - 1e-6));
            REQUIRE(field->at(p) <= field->maximum() * (1.0 + 1e-6));
        }
    }
}

TEST_CASE("SpacingField: single, bulk, repeated and threaded evaluation give bitwise the same values") {
    SpacingSpec spec;
    spec.expression = "0.5 + 0.3*sin(x)*cos(y)";
    spec.fromBoundary = true;
    const Domain domain = rectangle(10, 6, 100, 30);
    const auto one = fieldOf(spec, domain);
    const auto other = fieldOf(spec, domain);
    std::vector<Vec2> points;
    for (int i = 0; i < 5000; ++i) {
        points.push_back({10.0 * (i % 97) / 97.0, 6.0 * (i % 89) / 89.0});
    }
    std::vector<double> bulk(points.size());
    std::vector<double> threaded(points.size());
    one->atMany(points, bulk);
    {
        std::vector<std::jthread> threads;
        for (std::size_t t = 0; t < 4; ++t) {
            threads.emplace_back([&, t] {
                for (std::size_t i = t; i < points.size(); i += 4) {
                    threaded[i] = one->at(points[i]);
                }
            });
        }
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        REQUIRE(bulk[i] == other->at(points[i]));
        REQUIRE(bulk[i] == threaded[i]);
        REQUIRE(one->sample(points[i]).rho == bulk[i]);
    }
}

TEST_CASE("SpacingField: boundary lengths alone give a spacing everywhere") {
    SpacingSpec spec;
    spec.fromBoundary = true;
    const auto field = fieldOf(spec, rectangle(10, 10, 50, 2));
    CHECK(field->at({5, 0}) == doctest::Approx(0.2).epsilon(0.01));
    CHECK(field->at({5, 2}) == doctest::Approx(0.7).epsilon(0.01));
    CHECK(field->sample({5, 2}).origin == SpacingOrigin::Boundary);
    spec.fromBoundary = true;
    CHECK(std::isfinite(fieldOf(spec, Domain{})->at({0, 0})));
}

TEST_CASE("SpacingField: refuses all invalid numbers at once, naming the sources") {
    SpacingSpec spec;
    spec.size = -1.0;
    spec.gradation = 0.0;
    spec.sources.push_back({SourceShape::Point, {1, 1}, {}, -1.0, 0.0, -0.1, "pier"});
    const auto refused = SpacingField::build(spec, rectangle(1, 1, 1, 1));
    REQUIRE(!refused.ok());
    CHECK(refused.faults().size() == 5);
    CHECK(refused.faults()[0].code == "bad-size");
    CHECK(refused.faults()[4].code == "bad-source");
    CHECK(refused.faults()[4].message.find("'pier'") != std::string::npos);
    CHECK(refused.faults()[4].at == Vec2{1, 1});
    spec = {};
    spec.minimum = 2.0;
    spec.maximum = 1.0;
    CHECK(SpacingField::build(spec, rectangle(1, 1, 1, 1)).faults().front().code == "bad-size");
    spec = {};
    spec.size = std::numeric_limits<double>::quiet_NaN();
    CHECK(!SpacingField::build(spec, rectangle(1, 1, 1, 1)).ok());
}

TEST_CASE("SpacingField: a cancelled build reports it") {
    std::stop_source stop;
    stop.request_stop();
    Progress progress;
    progress.stop = stop.get_token();
    const auto field = SpacingField::build({}, rectangle(10, 5, 200, 100), progress);
    REQUIRE(!field.ok());
    CHECK(field.faults().front().code == "cancelled");
}

TEST_CASE(
    "Sizes of boundary parts: the spacing equals the size at segments and points with the tag, and grows from there") {
    Domain domain = rectangle(8, 4, 1, 1);
    domain.segments[1].tag = 5;
    domain.boundaryNames[5] = "outlet";
    domain.nodes.push_back({2, 2});
    domain.points.push_back({4, 7});
    SpacingSpec spec;
    spec.size = 1.0;
    spec.partSizes = {{5, {0.125, 0.25}}, {7, {0.25, 0.5}}};
    const auto field = fieldOf(spec, domain);
    CHECK(field->at({8, 2}) == doctest::Approx(0.125));
    CHECK(field->at({7, 2}) == doctest::Approx(0.375));
    CHECK(field->at({0, 0}) == doctest::Approx(1.0));
    CHECK(field->at({2, 2}) == doctest::Approx(0.25));
    CHECK(field->sample({8, 2}).describe == "size of 'outlet'");
    spec.partSizes[5].size = 0.0;
    const auto refused = SpacingField::build(spec, domain);
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.faults().front().code == "bad-source");
}
