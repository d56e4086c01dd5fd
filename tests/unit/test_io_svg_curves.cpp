#include "core/drawing_files/svg/svg.hpp"
#include "core/engine/domain/curve_chains.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/support/curved_area.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

using std::numbers::pi;

Domain iconDomain(const std::string &content, double tolerance = 0.0) {
    const std::string text = "<svg viewBox=\"0 0 24 24\">" + content + "</svg>";
    SourceText source = sourceOf(text);
    source.options.curveTolerance = tolerance;
    const auto domain = readSvg(source);
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    return *domain;
}

MeshingOutcome meshOf(const Domain &domain) {
    MeshingJob job;
    job.domain = domain;
    auto outcome = meshDomain(job);
    REQUIRE_MESSAGE(outcome.ok(), messages(outcome.faults()));
    const Diagnostics faults = verifyAgainst(outcome->mesh, domain);
    CHECK_MESSAGE(faults.empty(), messages(faults));
    return std::move(*outcome);
}

struct Logo {
    const char *what;
    const char *path;
    double area; ///< of the exact curves; 0: not checked
};

// Drawn for this test, in the manner of icon sets: rings, rounded corners, relative commands, short fillets.
const Logo kLogos[] = {
    {"disc", "M12 0a12 12 0 1 0 0 24 12 12 0 0 0 0-24z", 144.0 * pi},
    {"ring", "M12 1a11 11 0 1 1 0 22 11 11 0 0 1 0-22zm0 2a9 9 0 1 0 0 18 9 9 0 0 0 0-18z", 40.0 * pi},
    {"rounded square", "M5 2h14a3 3 0 0 1 3 3v14a3 3 0 0 1-3 3H5a3 3 0 0 1-3-3V5a3 3 0 0 1 3-3z",
     400.0 - 36.0 + 9.0 * pi},
    {"short fillets",
     "M2.05 2h19.9a.05.05 0 0 1 .05.05v19.9a.05.05 0 0 1-.05.05H2.05A.05.05 0 0 1 2 21.95V2.05A.05.05 0 "
     "0 1 2.05 2z",
     400.0 - 0.01 + 0.0025 * pi},
    {"bubble",
     "M12 3C6.5 3 2 6.6 2 11c0 2.1 1 4 2.700 5.400L4 21l4.500-2.300C9.600 18.900 10.800 19 12 19c5.500 0 "
     "10-3.600 10-8s-4.500-8-10-8z",
     0.0},
    {"dots", "M3 12a2 2 0 1 0 4 0 2 2 0 0 0-4 0zm7 0a2 2 0 1 0 4 0 2 2 0 0 0-4 0zm7 0a2 2 0 1 0 4 0 2 2 0 0 0-4 0z",
     12.0 * pi},
    {"wave", "M0 12c4-8 8-8 12 0s8 8 12 0v2c-4 8-8 8-12 0s-8-8-12 0z", 48.0},
};

} // namespace

TEST_CASE("SVG curves: logos get a few hundred to a few thousand triangles and the right area") {
    for (const Logo &logo : kLogos) {
        CAPTURE(std::string(logo.what));
        const Domain domain = iconDomain(std::string("<path d=\"") + logo.path + "\"/>");
        CHECK(!domain.curves.empty());
        const MeshingOutcome outcome = meshOf(domain);
        CHECK(outcome.mesh.triangles().size() >= 300);
        CHECK(outcome.mesh.triangles().size() <= 6000);
        if (logo.area > 0.0) {
            CHECK(outcome.boundary->area() == doctest::Approx(logo.area).epsilon(0.005));
        }
    }
}

TEST_CASE("SVG curves: a path ends where it begins within the rounding of its digits") {
    const auto domainOf = [](const char *path) { return iconDomain(std::string("<path d='") + path + "'/>"); };
    // The end is 0.0022 beside the beginning: the straight side takes that up.
    const Domain rounded = domainOf("M12 2c3 0 5 2 5 5.001s-2 5-4.999 5h-4c-3 0-5-2-5-5s2.001-5.001 5-5.001h4.0002z");
    CHECK(rounded.curves.size() == 4);
    for (const DomainSegment &segment : rounded.segments) {
        if (segment.stretch.follows()) {
            const Curve &curve = rounded.curves[segment.stretch.curve];
            CHECK(distance(curve.point(segment.stretch.t0), rounded.nodes[segment.a]) < 1e-9);
            CHECK(distance(curve.point(segment.stretch.t1), rounded.nodes[segment.b]) < 1e-9);
        }
    }
    const auto sizeOfPath = [&](const char *path) { return domainOf(path).bounds().size(); };
    // The last part may be a whole loop, or as short as the gap itself: then it stays as it is.
    CHECK(sizeOfPath("M12 2v.001a10 10 0 1 0 .001 0z").x == doctest::Approx(20.0).epsilon(0.01));
    CHECK(sizeOfPath("M12 2a10 10 0 1 1-.001 0z").y == doctest::Approx(20.0).epsilon(0.01));
    CHECK(sizeOfPath("M12 2v.001C-6 2 30 34 12.001 2.001z").y > 9.0);
    const auto areaOfPath = [](const std::string &path) {
        const std::string text = "<svg viewBox='0 0 30000 30000'><path d='" + path + "'/></svg>";
        const auto domain = readSvg(sourceOf(text));
        REQUIRE(domain.ok());
        return std::fabs(forefront::testing::curvedAreas(*domain).at(1));
    };
    CHECK(areaOfPath("M500 500h2v2h-2z") == doctest::Approx(4.0));
    CHECK(areaOfPath("M500 500h1v1h-1z") == doctest::Approx(1.0));
    const auto shortest = [](const Domain &domain) {
        double length = 1e9;
        for (const DomainSegment &segment : domain.segments) {
            length = std::min(length, distance(domain.nodes[segment.a], domain.nodes[segment.b]));
        }
        return length;
    };
    CHECK(shortest(domainOf("M2 2h20v20h-20.001v-19.999z")) > 19.0);
    CHECK(shortest(domainOf("M2 2h20v20h-20c0-9 0-10 .001-19.999z")) > 0.1);
    CHECK(shortest(domainOf("M2 2h20v20h-20.1v-19.9z")) < 0.2); // too far apart to join
    CHECK(shortest(domainOf("M2.00000 2h20v20h-20.002v-19.999z")) < 0.003);
    CHECK(shortest(domainOf("M2 2H22V22L2.002 22L2 2.002z")) < 0.003); // absolute places are not rounded again
    CHECK(domainOf("M2 2h20v20h-20v-1.5e-2147483647z").nodes.size() == 4);
    CHECK(shortest(domainOf("M2.00000 2h20v20h-20.00200v-19.99900z")) < 0.003); // with five digits it is no rounding
}

TEST_CASE("SVG curves: the number of triangles does not depend on the flattening") {
    const std::string ring = std::string("<path d=\"") + kLogos[1].path + "\"/>";
    Domain coarse = iconDomain(ring, 0.1), fine = iconDomain(ring, 1e-4);
    CHECK(fine.segments.size() > 20 * coarse.segments.size());
    coarse.curveTolerance = fine.curveTolerance = 0.02;
    const auto elements = [](const Domain &domain) {
        return static_cast<double>(meshOf(domain).mesh.triangles().size());
    };
    CHECK(elements(coarse) == doctest::Approx(elements(fine)).epsilon(0.05));
}

TEST_CASE("SVG curves: a transformed circle is an exact ellipse, with every node of the mesh's boundary on it") {
    const Domain domain =
        iconDomain("<circle r=\"3\" transform=\"translate(12 12) rotate(30) scale(3 1) skewX(20)\"/>");
    REQUIRE(domain.curves.size() == 1);
    const MeshingOutcome outcome = meshOf(domain);
    const Curve &ellipse = domain.curves.front();
    REQUIRE(outcome.mesh.edgeStretches.size() == outcome.mesh.edges.size());
    for (std::size_t e = 0; e < outcome.mesh.edges.size(); ++e) {
        const CurveStretch &stretch = outcome.mesh.edgeStretches[e];
        REQUIRE(stretch.follows());
        CHECK(distance(ellipse.point(stretch.t0), outcome.mesh.nodes[index(outcome.mesh.edges[e].a)]) < 1e-12);
        CHECK(distance(ellipse.point(stretch.t1), outcome.mesh.nodes[index(outcome.mesh.edges[e].b)]) < 1e-12);
    }
    CHECK(outcome.boundary->area() == doctest::Approx(27.0 * pi).epsilon(0.005));
}

TEST_CASE("SVG curves: all kinds of curves are kept, and drawings without curves have none") {
    const Domain domain = iconDomain("<path d=\"M2 12C2 2 8 2 8 12Q10 20 14 12A4 3 20 0 1 22 12L22 22 2 22z\"/>");
    REQUIRE(domain.curves.size() == 3);
    CHECK(domain.curves[0] == Curve::cubic({2, 12}, {2, 22}, {8, 22}, {8, 12}));
    CHECK(domain.curves[1].kind() == CurveKind::Cubic);
    CHECK(domain.curves[2].kind() == CurveKind::Arc);
    CHECK(curveChains(domain).list.size() == 3);
    CHECK(iconDomain("<path d=\"M2 2L8 2 8 8z\"/>").curves.empty());
}

TEST_CASE("SVG curves: where outlines cross, their curves end at the crossing") {
    const Domain domain = iconDomain("<circle cx=\"9\" cy=\"12\" r=\"5\"/><circle cx=\"15\" cy=\"12\" r=\"5\"/>");
    CHECK(domain.curves.size() == 2);
    const MeshingOutcome outcome = meshOf(domain);
    const double lens = 2.0 * 25.0 * std::acos(3.0 / 5.0) - 0.5 * 6.0 * std::sqrt(4.0 * 25.0 - 36.0);
    CHECK(outcome.boundary->area() == doctest::Approx(50.0 * pi - lens).epsilon(0.005));
}

TEST_CASE("SVG curves: a check notices a node that is off its curve") {
    const Domain domain = iconDomain("<circle cx=\"12\" cy=\"12\" r=\"9\"/>");
    MeshingOutcome outcome = meshOf(domain);
    outcome.mesh.nodes[index(outcome.mesh.edges[5].b)] += Vec2{1e-4, 1e-4};
    CHECK_FALSE(verifyAgainst(outcome.mesh, domain).empty());
}
