#include "core/drawing/commands/scale_document.hpp"
#include "core/drawing/document/document.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "core/engine/spacing/parts/expression/expression.hpp"
#include "core/engine/spacing/parts/expression/spacing_functions.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "core/engine/spacing/spec/size_presets.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

using namespace forefront;

namespace raster_tests {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// Depth 1 + 2·x + y on cells of 1 x 1 whose centres begin at (0, 0).
Raster plane(std::size_t columns, std::size_t rows) {
    Raster raster{{0.0, 0.0}, {1.0, 1.0}, columns, rows, {}};
    for (std::size_t k = 0; k < rows; ++k) {
        for (std::size_t i = 0; i < columns; ++i) {
            raster.values.push_back(1.0 + 2.0 * static_cast<double>(i) + static_cast<double>(k));
        }
    }
    return raster;
}

/// A rectangle whose lower side is the part "coast" and the others "sea".
Domain rectangle(Vec2 low, Vec2 high) {
    Domain domain;
    domain.nodes = {low, {high.x, low.y}, high, {low.x, high.y}};
    for (std::uint32_t k = 0; k < 4; ++k) {
        domain.segments.push_back({k, (k + 1) % 4, k == 0 ? 1 : 2, SegmentRole::Boundary, {}});
    }
    domain.boundaryNames = {{1, "coast"}, {2, "sea"}};
    return domain;
}

SpacingSpec specOf(const std::string &expression, Raster raster) {
    SpacingSpec spec;
    spec.expression = expression;
    spec.rasters["depth"] = std::make_shared<const Raster>(std::move(raster));
    return spec;
}

double valueOf(const std::string &expression, const SpacingSpec &spec, const Domain &domain, Vec2 p) {
    const Result<ExpressionProgram> program = compileSpacingExpression(expression, spec, &domain);
    REQUIRE_MESSAGE(program.ok(), (program.ok() ? "" : toString(program.faults().front())));
    double many = 0.0;
    program->evaluateMany(std::span(&p, 1), std::span(&many, 1));
    CHECK(many == program->evaluate(p));
    return many;
}

std::string faultOf(const SpacingSpec &spec, const Domain &domain) {
    const auto field = SpacingField::build(spec, domain);
    return field ? "" : field.faults().front().code + ": " + field.faults().front().message;
}

} // namespace raster_tests
using namespace raster_tests;

TEST_CASE("Raster functions: value, slopes and arguments that are expressions") {
    const Domain domain = rectangle({1.0, 1.0}, {8.0, 6.0});
    const SpacingSpec spec = specOf("depth(x,y)", plane(10, 8));
    CHECK(valueOf("depth(x,y)", spec, domain, {2.5, 3.25}) == doctest::Approx(9.25));
    CHECK(valueOf("depth(y+1, 2)*2", spec, domain, {2.5, 3.0}) == doctest::Approx(22.0));
    CHECK(valueOf("depth(3, 2)", spec, domain, {7.0, 7.0}) == doctest::Approx(9.0)); // constant arguments
    CHECK(valueOf("depth_x(x,y)", spec, domain, {2.5, 3.25}) == doctest::Approx(2.0));
    CHECK(valueOf("hypot(depth_x(x,y), depth_y(x,y))", spec, domain, {2.5, 3.25}) == doctest::Approx(std::sqrt(5.0)));
    CHECK(valueOf("depth(x,y)", spec, domain, {-50.0, 3.0}) == doctest::Approx(4.0)); // as at the nearest place
    CHECK(valueOf("depth_x(x,y)", spec, domain, {-50.0, 3.0}) == 0.0);
}

TEST_CASE("Raster functions: bounds over boxes hold all values") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-3.0, 14.0), value(-5.0, 5.0);
    Raster raster = plane(12, 9);
    for (double &each : raster.values) {
        each = value(random);
    }
    const Domain domain = rectangle({1.0, 1.0}, {8.0, 6.0});
    const SpacingSpec spec = specOf("1", raster);
    for (const char *const text : {"depth(x,y)", "depth_x(x,y)", "depth_y(x,y)", "shore(x,y)", "shore(x,y,'coast')"}) {
        const Result<ExpressionProgram> program = compileSpacingExpression(text, spec, &domain);
        REQUIRE(program);
        for (int k = 0; k < 40; ++k) {
            const Vec2 a{place(random), place(random)}, b{place(random), place(random)};
            const Box2 box{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
            const ValueRange range = program->range(box);
            CHECK_FALSE(range.undefined);
            for (int i = 0; i <= 16; ++i) {
                const double v = program->evaluate(
                    {box.min.x + box.size().x * (i % 4) / 4.0, box.min.y + box.size().y * (i / 4) / 4.0});
                CHECK(v >= range.low);
                CHECK(v <= range.high);
            }
        }
    }
}

TEST_CASE("Raster functions: gaps near the domain are filled, those in it are refused with a place") {
    Raster raster = plane(30, 20);
    const Domain domain = rectangle({2.0, 2.0}, {27.0, 17.0});
    for (std::size_t i = 0; i < 30; ++i) { // the two lowest rows of the domain, as beside a shore
        for (std::size_t k = 0; k < 4; ++k) {
            raster.values[k * 30 + i] = kMissing;
        }
    }
    const SpacingSpec spec = specOf("0.2*depth(x,y)", raster);
    CHECK(faultOf(spec, domain) == "");
    CHECK(valueOf("depth(x,y)", spec, domain, {10.0, 2.0}) == doctest::Approx(25.0)); // of the lowest row with values
    for (std::size_t k = 8; k < 15; ++k) {
        for (std::size_t i = 8; i < 15; ++i) {
            raster.values[k * 30 + i] = kMissing;
        }
    }
    // max(1, nothing) is 1: without the check this would pass.
    const auto refused = SpacingField::build(specOf("max(1, depth(x,y))", raster), domain);
    REQUIRE_FALSE(refused);
    CHECK(refused.faults().front().code == "raster-gap");
    CHECK(refused.faults().front().at == Vec2{10.0, 10.0});
    CHECK(faultOf(specOf("1 + 0*x", raster), domain) == ""); // it is not called
    CHECK(faultOf(specOf("depth(x,y)", plane(12, 8)), domain).starts_with("raster-gap"));
    CHECK(faultOf(specOf("depth(x,y)", {{0.0, 0.0}, {1.0, 1.0}, 1, 1, {kMissing}}), domain).starts_with("bad-raster"));
}

TEST_CASE("Shore: the distance to the boundary or to named parts, as by checking every segment") {
    Domain domain;
    constexpr std::uint32_t kNodes = 2000;
    for (std::uint32_t k = 0; k < kNodes; ++k) {
        const double angle = 2.0 * 3.14159265358979 * k / kNodes;
        const double radius = 10.0 + std::sin(9.0 * angle);
        domain.nodes.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        domain.segments.push_back({k, (k + 1) % kNodes, k < 500 ? 1 : 2, SegmentRole::Boundary, {}});
    }
    domain.boundaryNames = {{1, "coast"}, {2, "open sea"}};
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-11.0, 11.0);
    const SpacingSpec spec = specOf("1", plane(2, 2));
    for (int k = 0; k < 50; ++k) {
        const Vec2 p{place(random), place(random)};
        double all = 1e9, coast = 1e9;
        for (const DomainSegment &segment : domain.segments) {
            const double d = distanceToSegment(domain.nodes[segment.a], domain.nodes[segment.b], p);
            all = std::min(all, d);
            coast = segment.tag == 1 ? std::min(coast, d) : coast;
        }
        CHECK(valueOf("shore(x,y)", spec, domain, p) == all);
        CHECK(valueOf("shore(x, y, 'coast')", spec, domain, p) == coast);
        CHECK(valueOf("shore(x,y,'coast', 'open sea')", spec, domain, p) == all);
    }
}

TEST_CASE("Raster functions: faults of expressions name what is wrong") {
    const Domain domain = rectangle({1.0, 1.0}, {8.0, 6.0});
    const SpacingSpec spec = specOf("1", plane(10, 8));
    const auto fault = [&](const char *text) {
        const auto program = compileSpacingExpression(text, spec, &domain);
        return program ? std::string() : program.faults().front().message;
    };
    CHECK(fault("deep(x,y)").find("unknown name 'deep'; expected x, y, pi, e or a function, also depth, shore") !=
          std::string::npos);
    CHECK(fault("depth(x)").find("'depth' takes a place, such as depth(x, y)") != std::string::npos);
    CHECK(fault("depth(x,y,1)").find("missing ')'") != std::string::npos);
    CHECK(fault("shore(x,y,'cost')").find("unknown boundary part 'cost'; expected 'coast', 'sea'") !=
          std::string::npos);
    CHECK(fault("shore(x,y,coast)").find("in single quotes") != std::string::npos);
    CHECK(fault("shore(x,y,'coast)").find("in single quotes") != std::string::npos);
    CHECK(compileSpacingExpression("shore(x,y,'any')", spec, nullptr)); // only checked
    CHECK_FALSE(compileExpression("shore(x,y)"));
    CHECK(checkRasterName("depth") == "");
    for (const char *const name : {"", "2d", "a b", "sin", "x", "pi", "shore", "depth_x", "d-1"}) {
        CHECK_FALSE(checkRasterName(name).empty());
    }
}

TEST_CASE("Rasters: kept in projects with missing values, and moved with the drawing when it is scaled") {
    Document document;
    Raster raster = plane(3, 2);
    raster.values[4] = kMissing;
    document.spacing = specOf("depth(x,y)", raster);
    const Result<Document> back = parseProject(projectText(document), "bay.json");
    REQUIRE(back);
    CHECK(sameRasters(back->spacing.rasters, document.spacing.rasters));
    raster.values[0] = 7.0;
    CHECK_FALSE(sameRasters(back->spacing.rasters, specOf("", raster).rasters));
    const Result<Document> scaled = scaleDocument(document, {1.0, 0.0}, 2.0);
    REQUIRE(scaled);
    CHECK(scaled->spacing.rasters.at("depth")->origin == Vec2{-1.0, 0.0});
    CHECK(scaled->spacing.rasters.at("depth")->pitch == Vec2{2.0, 2.0});
    CHECK(scaled->spacing.rasters.at("depth")->values[1] == 3.0);

    std::string text = projectText(document);
    text.replace(text.find("\"columns\": 3"), 12, "\"columns\": 4");
    const Result<Document> refused = parseProject(text, "bay.json");
    REQUIRE_FALSE(refused);
    CHECK(refused.faults().front().code == "bad-count");
}

TEST_CASE("Size presets: expressions with the sizes of their formulas, and faults") {
    const Domain domain = rectangle({1.0, 1.0}, {8.0, 6.0});
    const SpacingSpec spec = specOf("1", plane(10, 8));
    const auto at = [&](std::vector<std::string> rules, Vec2 p) {
        const Result<std::string> text = presetExpression(rules);
        REQUIRE(text);
        return valueOf(*text, spec, domain, p);
    };
    CHECK(at({"wavelength:depth=depth,period=60,elements=20"}, {2.0, 3.0}) ==
          doctest::Approx(60.0 * std::sqrt(9.81 * 8.0) / 20.0));
    CHECK(at({"wavelength:elevation=depth,period=60,elements=20,least=2"}, {2.0, 3.0}) ==
          doctest::Approx(60.0 * std::sqrt(9.81 * 2.0) / 20.0));
    CHECK(at({"slope:depth=depth,elements=10,max=100"}, {2.0, 3.0}) ==
          doctest::Approx(2.0 * 3.14159265358979 / 10.0 * 8.0 / std::sqrt(5.0)));
    CHECK(at({"slope:depth=depth,elements=10,max=1.5"}, {2.0, 3.0}) == 1.5);
    CHECK(at({"shore:size=0.5,growth=0.2,part=coast"}, {2.0, 3.0}) == doctest::Approx(0.9));
    CHECK(at({"shore:size=0.5,growth=0.2", "slope:depth=depth,elements=10,max=100"}, {2.0, 3.0}) ==
          doctest::Approx(0.7));
    const auto fault = [](const char *rule) {
        const auto text = presetExpression(std::vector<std::string>{rule});
        return text ? std::string() : text.faults().front().message;
    };
    CHECK(fault("tide:period=3") == "'tide:period=3': unknown rule; expected wavelength, slope or shore");
    CHECK(fault("shore:size=1").ends_with("missing key 'growth'"));
    CHECK(fault("shore:size=1,growth=-1").ends_with("growth: expected a positive number, got '-1'"));
    CHECK(fault("shore:size=1,growth=1,depth=d").find("unknown key 'depth'; expected part size") != std::string::npos);
    CHECK(fault("slope:elements=3,max=4").ends_with("expected a raster: depth=NAME, or elevation=NAME"));
    CHECK(fault("slope:elements=3,elements=4").ends_with("duplicate key 'elements'"));
}
