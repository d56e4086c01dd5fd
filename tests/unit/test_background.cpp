#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/parts/background/limit_gradation.hpp"
#include "core/engine/spacing/scaled_field.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/support/domain_builder.hpp"
#include "tests/support/spacing_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// A lattice of n x n squares, each cut in two, over [low, high]², nodes graded by `power`, values from f.
template <class F>
std::shared_ptr<const BackgroundMesh> lattice(double low, double high, std::uint32_t n, double power, F f) {
    auto mesh = std::make_shared<BackgroundMesh>();
    const auto place = [&](std::uint32_t i) {
        return low + (high - low) * std::pow(static_cast<double>(i) / n, power);
    };
    for (std::uint32_t j = 0; j <= n; ++j) {
        for (std::uint32_t i = 0; i <= n; ++i) {
            mesh->nodes.push_back({place(i), place(j)});
            mesh->values.push_back(f(mesh->nodes.back()));
        }
    }
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i;
            mesh->elements.push_back({a, a + 1, a + n + 2});
            mesh->elements.push_back({a, a + n + 2, a + n + 1});
        }
    }
    return mesh;
}

std::string refusal(const BackgroundMesh &mesh) {
    SpacingSpec spec;
    spec.background = std::make_shared<BackgroundMesh>(mesh);
    const auto field = SpacingField::build(spec, squareDomain(1));
    return field.ok() ? std::string() : field.faults().front().code + ": " + field.faults().front().message;
}

} // namespace

TEST_CASE("Background mesh: a linear field is reproduced everywhere, graded meshes too") {
    const auto linear = [](Vec2 p) { return 0.2 + 0.03 * p.x + 0.01 * p.y; };
    for (const double power : {1.0, 4.0}) {
        SpacingSpec spec;
        spec.background = lattice(0.0, 10.0, 60, power, linear);
        const auto field = fieldOf(spec, squareDomain(10));
        std::mt19937 random(1);
        std::uniform_real_distribution<double> place(0.0, 10.0);
        for (int i = 0; i < 5000; ++i) {
            const Vec2 p =
                i < 3721 ? spec.background->nodes[static_cast<std::size_t>(i)] : Vec2{place(random), place(random)};
            REQUIRE(field->at(p) == doctest::Approx(linear(p)).epsilon(1e-9));
        }
        CHECK(field->minimum() <= 0.2);
        CHECK(field->maximum() >= 0.6);
        CHECK(field->sample({3, 3}).origin == SpacingOrigin::Background);
    }
}

TEST_CASE("Background mesh: outside of it, the other parts apply") {
    SpacingSpec spec;
    spec.background = lattice(2.0, 4.0, 8, 1.0, [](Vec2) { return 0.1; });
    spec.size = 0.7;
    CHECK(fieldOf(spec, squareDomain(10))->at({3, 3}) == doctest::Approx(0.1));
    CHECK(fieldOf(spec, squareDomain(10))->at({5, 3}) == 0.7);
    spec.gradation = 0.2;
    CHECK(fieldOf(spec, squareDomain(10))->at({5, 3}) == doctest::Approx(0.3).epsilon(0.01));
}

TEST_CASE("Background mesh: automatic spacing continues it outside, without a step") {
    SpacingSpec spec;
    spec.background = lattice(0.0, 5.0, 10, 1.0, [](Vec2) { return 1.0; });
    const auto coarse = fieldOf(spec, squareDomain(10));
    CHECK(coarse->at({3, 3}) == doctest::Approx(1.0)); // coarser than automatic spacing, as intended
    CHECK(coarse->at({9, 9}) == doctest::Approx(std::sqrt(200.0) / 45.0));
    spec.background = lattice(0.0, 5.0, 10, 1.0, [](Vec2) { return 0.05; });
    const auto fine = fieldOf(spec, squareDomain(10));
    CHECK(fine->at({3, 5.2}) == doctest::Approx(0.1).epsilon(0.01));
    CHECK(fine->sample({3, 5.2}).describe.find("limited by gradation 0.25 from the background mesh") == 0);
}

TEST_CASE("Background mesh: a steep field is limited by the gradation formula within 2 %") {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    SpacingSpec spec;
    spec.background = lattice(0.0, 10.0, 12, 1.0, [&](Vec2) { return 0.2 + 3.0 * std::pow(share(random), 3.0); });
    const auto plain = fieldOf(spec, squareDomain(10));
    spec.gradation = 0.15;
    const auto limited = fieldOf(spec, squareDomain(10));
    for (int n = 0; n < 60; ++n) {
        const Vec2 p{10 * share(random), 10 * share(random)};
        double expected = plain->at(p);
        for (int j = 0; j <= 500; ++j) {
            for (int i = 0; i <= 500; ++i) {
                const Vec2 q{0.02 * i, 0.02 * j};
                expected = std::min(expected, plain->at(q) + 0.15 * distance(p, q));
            }
        }
        CHECK(limited->at(p) == doctest::Approx(expected).epsilon(0.02));
    }
}

TEST_CASE("Background mesh: a node with many triangles, and needles, are located") {
    auto mesh = std::make_shared<BackgroundMesh>();
    mesh->nodes.push_back({5, 5});
    mesh->values.push_back(1.0);
    const std::uint32_t spokes = 400;
    for (std::uint32_t i = 0; i < spokes; ++i) {
        const double angle = 6.283185307179586 * i / spokes;
        mesh->nodes.push_back(Vec2{5, 5} + 4.0 * Vec2{std::cos(angle), std::sin(angle)});
        mesh->values.push_back(2.0);
        mesh->elements.push_back({0, 1 + i, 1 + (i + 1) % spokes});
    }
    SpacingSpec spec;
    spec.size = 50.0;
    spec.background = mesh;
    const auto field = fieldOf(spec, squareDomain(10));
    for (double r = 0.0; r < 3.99; r += 0.01) {
        const Vec2 p = Vec2{5, 5} + r * Vec2{std::cos(7 * r), std::sin(7 * r)};
        CHECK(field->at(p) == doctest::Approx(1.0 + r / 4.0).epsilon(1e-3));
    }
    CHECK(field->at({5, 9.5}) == 50.0);
}

TEST_CASE("Background mesh: refuses invalid meshes with the place of the fault") {
    const BackgroundMesh good{{{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}}, {1, 1, 1}};
    CHECK(refusal(good).empty());
    BackgroundMesh bad = good;
    bad.elements[0] = {0, 2, 1};
    CHECK(refusal(bad).find("bad-background: the background mesh has an inverted triangle") == 0);
    bad = good;
    bad.nodes[2] = {2, 0};
    CHECK(refusal(bad).find("degenerate") != std::string::npos);
    bad = good;
    bad.elements[0] = {0, 1, 7};
    CHECK(refusal(bad).find("index out of range") != std::string::npos);
    bad = good;
    bad.values = {1, 1};
    CHECK(refusal(bad).find("2 values for 3 nodes") != std::string::npos);
    bad = good;
    bad.values[1] = -1;
    CHECK(refusal(bad).find("at node 1") != std::string::npos);
    bad = good;
    bad.nodes[1].x = std::numeric_limits<double>::quiet_NaN();
    CHECK(refusal(bad).find("not finite") != std::string::npos);
    CHECK(refusal(BackgroundMesh{}).find("no triangles") != std::string::npos);
}

TEST_CASE("Background mesh: one that does not meet the domain is refused with both boxes") {
    const auto even = [](Vec2) { return 0.2; };
    SpacingSpec spec;
    spec.background = lattice(200.0, 202.0, 2, 1.0, even);
    const auto field = SpacingField::build(spec, squareDomain(10));
    REQUIRE_FALSE(field.ok());
    CHECK(field.faults().front().code == "bad-background");
    CHECK(field.faults().front().message ==
          "the background mesh does not meet the domain: the mesh lies from (200, 200) to (202, 202), the domain from "
          "(0, 0) to (10, 10)");
    spec.size = 0.5; // other sizes do not excuse it
    CHECK_FALSE(SpacingField::build(spec, squareDomain(10)).ok());
    CHECK(SpacingField::build(spec, Domain{}).ok()); // nothing is drawn yet
}

TEST_CASE("Background mesh: one within the box of the domain, but in its hole, does not meet it") {
    DomainBuilder builder;
    builder.loop({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 1);
    builder.loop({{2, 2}, {2, 8}, {8, 8}, {8, 2}}, 2);
    SpacingSpec spec;
    spec.background = lattice(3.0, 7.0, 4, 1.0, [](Vec2) { return 0.2; });
    CHECK_FALSE(SpacingField::build(spec, builder.domain).ok());
    spec.background = lattice(1.0, 9.0, 1, 1.0, [](Vec2) { return 0.2; }); // its sides are inside, the middle is not
    CHECK(SpacingField::build(spec, builder.domain).ok());
    auto crossing = std::make_shared<BackgroundMesh>(); // neither has a node in the other
    *crossing = {{{-5, 1}, {15, 0.8}, {15, 1.2}}, {{0, 1, 2}}, {0.2, 0.2, 0.2}};
    spec.background = crossing;
    CHECK(SpacingField::build(spec, builder.domain).ok());
}

TEST_CASE("Background mesh: a note tells how much of the domain it covers, if that is not all") {
    const auto even = [](Vec2) { return 0.5; };
    SpacingSpec spec;
    spec.background = lattice(0.0, 10.0, 4, 1.0, even);
    CHECK(fieldOf(spec, squareDomain(10))->notes().empty());
    spec.background = lattice(0.0, 5.0, 4, 1.0, even);
    const auto field = fieldOf(spec, squareDomain(10));
    REQUIRE(field->notes().size() == 1);
    const Diagnostic &note = field->notes().front();
    CHECK(note.severity == Severity::Note);
    CHECK(note.message == "the background mesh covers about 25 % of the domain: the mesh lies from (0, 0) to (5, 5), "
                          "the domain from (0, 0) to (10, 10)");
    CHECK(note.advice == "the rest gets automatic sizes");
    CHECK(scaledField(field, 2.0)->notes().size() == 1);
}

TEST_CASE("limitGradation: gives the largest spacing, not above the given one, within the gradation along every edge") {
    RandomSource random(5);
    BackgroundMesh mesh = *lattice(0.0, 12.0, 12, 1.3, [&](Vec2) { return random.between(0.01, 2.0); });
    const std::vector<double> given = mesh.values;
    CHECK(limitGradation(mesh, 0.4));
    // Relaxation until nothing changes gives the same.
    std::vector<double> relaxed = given;
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto &element : mesh.elements) {
            for (const std::uint32_t a : element) {
                for (const std::uint32_t b : element) {
                    const double limit = relaxed[a] + 0.4 * distance(mesh.nodes[a], mesh.nodes[b]);
                    changed = changed || limit < relaxed[b];
                    relaxed[b] = std::fmin(relaxed[b], limit);
                }
            }
        }
    }
    CHECK(mesh.values == relaxed);
    CHECK(mesh.values != given);
}

TEST_CASE("Background mesh: a step that elements cannot follow is limited, with a note, unless a gradation is given") {
    const auto step = [](Vec2 p) { return p.x < 5.0 ? 0.1 : 3.0; };
    SpacingSpec spec;
    spec.background = lattice(0.0, 10.0, 40, 1.0, step);
    const auto field = fieldOf(spec, squareDomain(10));
    CHECK(field->at({4.0, 5.0}) == 0.1);
    CHECK(field->at({6.75, 5.0}) == doctest::Approx(0.1 + 0.5 * 2.0));
    CHECK(field->at({10.0, 5.0}) == doctest::Approx(0.1 + 0.5 * 5.25));
    REQUIRE(field->notes().size() == 1);
    CHECK(field->notes().front().message ==
          "the background mesh changes by more than 0.5 per unit of distance, which elements cannot follow; limited to "
          "0.5");
    CHECK(field->notes().front().at);
    Domain left = squareDomain(4); // the step is outside
    CHECK(fieldOf(spec, left)->notes().empty());
    spec.gradation = 20.0;
    CHECK(fieldOf(spec, squareDomain(10))->at({6.75, 5.0}) == doctest::Approx(3.0));
    CHECK(fieldOf(spec, squareDomain(10))->notes().empty());
}
