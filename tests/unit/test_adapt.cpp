#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/engine/adapt/adaptive_meshing.hpp"
#include "core/engine/adapt/gradient_recovery.hpp"
#include "core/engine/adapt/mesh_outline.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "core/teaching/tables/power_law.hpp"
#include "tests/support/poisson.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

using namespace forefront;

namespace {

std::vector<double> nodeValues(const TriMesh &mesh, double (*f)(Vec2)) {
    std::vector<double> values;
    for (const Vec2 p : mesh.nodes) {
        values.push_back(f(p));
    }
    return values;
}

Domain squareOf(double side) {
    Domain domain;
    addLoop(domain, std::vector<Vec2>{{0, 0}, {side, 0}, {side, side}, {0, side}});
    return domain;
}

TriMesh uniformMesh(const Domain &domain, double size) {
    MeshingJob job;
    job.domain = domain;
    job.spacing.size = size;
    Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE(outcome);
    return takeTriMesh(std::move(outcome->mesh));
}

} // namespace

TEST_CASE("recoverGradient: recovers the gradient of a linear field exactly, at the boundary as well") {
    const TriMesh mesh = samples::square(7, 5, 0.2);
    const std::vector<double> values = nodeValues(mesh, [](Vec2 p) { return 3.0 * p.x - 2.0 * p.y + 1.0; });
    const Result<CornerGradients> recovered = recoverGradient(mesh, *elementGradients(mesh, values));
    REQUIRE(recovered);
    for (const auto &corners : *recovered) {
        for (const Vec2 g : corners) {
            CHECK(distance(g, {3.0, -2.0}) < 1e-10);
        }
    }
    CHECK(estimateError(mesh, values)->relative() < 1e-10);
}

TEST_CASE("recoverGradient: a curved field is recovered better than by its elements") {
    const TriMesh mesh = samples::square(20, 20, 0.15);
    const std::vector<double> values = nodeValues(mesh, [](Vec2 p) { return std::sin(3.0 * p.x) * std::exp(p.y); });
    const CornerGradients recovered = *recoverGradient(mesh, *elementGradients(mesh, values));
    const std::vector<Vec2> constant = *elementGradients(mesh, values);
    double best = 0.0, plain = 0.0;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 p = mesh.nodes[index(mesh.elements[e][k])];
            const Vec2 exact{3.0 * std::cos(3.0 * p.x) * std::exp(p.y), std::sin(3.0 * p.x) * std::exp(p.y)};
            best += lengthSquared(recovered[e][k] - exact);
            plain += lengthSquared(constant[e] - exact);
        }
    }
    CHECK(best < 0.02 * plain);
}

TEST_CASE("estimateError: a gradient may jump only where regions meet") {
    TriMesh mesh = samples::square(8, 8);
    const std::vector<double> values = nodeValues(mesh, [](Vec2 p) { return std::abs(p.x - 0.5); });
    CHECK(estimateError(mesh, values)->relative() > 0.1);
    for (const Element &element : mesh.elements) {
        double x = 0.0;
        for (const NodeId node : element) {
            x += mesh.nodes[index(node)].x / 3.0;
        }
        mesh.regions.push_back(x < 0.5 ? 1 : 2);
    }
    CHECK(estimateError(mesh, values)->relative() < 1e-10);
}

TEST_CASE("estimateError: a constant field has no error and needs no refinement") {
    const TriMesh mesh = samples::square(6, 6, 0.1);
    const ErrorEstimate estimate = *estimateError(mesh, std::vector<double>(mesh.nodes.size(), 4.0));
    CHECK(estimate.relative() == 0.0);
    const std::vector<double> spacing = *elementSpacing(mesh, estimate, {0.05, 0.0, 1.0, 0.3});
    for (const double h : spacing) {
        CHECK(h > 0.15); // of cells of 1/6
        CHECK(std::isfinite(h));
    }
}

TEST_CASE("elementSpacing: equal errors get equal spacing, and the total meets the target") {
    const TriMesh mesh = samples::square(10, 10);
    ErrorEstimate estimate;
    estimate.elements.assign(mesh.elements.size(), 0.01);
    estimate.total = 0.01 * std::sqrt(static_cast<double>(mesh.elements.size()));
    estimate.norm = std::sqrt(1.0 - estimate.total * estimate.total); // relative error = total
    const double target = 0.5 * estimate.total;
    const std::vector<double> spacing = *elementSpacing(mesh, estimate, {target, 0.0, 1e9, 0.3});
    const double h = std::sqrt(4.0 / std::sqrt(3.0) * 0.5 * 0.01); // half of a cell of 0.1
    for (const double s : spacing) {
        CHECK(s == doctest::Approx(0.5 * h).epsilon(1e-6)); // the error is proportional to h
    }
    const std::vector<double> bounded = *elementSpacing(mesh, estimate, {target, 0.9 * h, 1e9, 0.3});
    for (const double s : bounded) {
        CHECK(s == doctest::Approx(0.9 * h)); // but not below the minimum size
    }
}

TEST_CASE("elementSpacing: elements at the minimum size do not make the rest ever finer") {
    const TriMesh mesh = samples::square(20, 20);
    ErrorEstimate estimate;
    estimate.elements.assign(mesh.elements.size(), 1e-4);
    estimate.elements[400] = 1.0; // requests far more than a factor of 6
    estimate.total = 1.0;
    estimate.norm = 10.0;
    const double h = std::sqrt(4.0 / std::sqrt(3.0) * 0.5 * 0.0025);
    for (const double minimum : {0.0, 0.5 * h}) {
        const std::vector<double> spacing = *elementSpacing(mesh, estimate, {0.01, minimum, 1e9, 0.3});
        CHECK(spacing[400] == doctest::Approx(std::max(h / 6.0, minimum)));
        CHECK(spacing[0] > 2.0 * h);
    }
}

TEST_CASE("outlineOf: drops nodes that only divide a straight side, and keeps tags and names") {
    const TriMesh mesh = samples::square(9, 4, 0.1, {3.0, 7.0});
    const Result<MeshDomain> domain = outlineOf(mesh);
    REQUIRE(domain);
    CHECK(domain->domain.nodes.size() == 4);
    CHECK(domain->domain.segments.size() == 4);
    std::set<std::int32_t> tags;
    for (const DomainSegment &segment : domain->domain.segments) {
        tags.insert(segment.tag);
    }
    CHECK(tags == std::set<std::int32_t>{1, 2, 3, 4});
    CHECK(domain->domain.boundaryNames == mesh.boundaryNames);
    TriMesh pinned = mesh;
    pinned.points.push_back({samples::node(4), 7}); // in the middle of the bottom
    CHECK(outlineOf(pinned)->domain.nodes.size() == 5);
}

TEST_CASE("outlineOf: can be cancelled at each of its reports") {
    TriMesh mesh = samples::square(90, 90, 0.2);
    mesh.regions.assign(mesh.elements.size(), 1);
    mesh.regions.front() = 2; // so that faces are marked
    std::size_t reports = 0, limit = 0;
    std::stop_source stop;
    Progress progress;
    progress.report = [&](std::string_view, double) {
        if (++reports == limit) {
            stop.request_stop();
        }
    };
    REQUIRE(outlineOf(mesh, progress));
    const std::size_t all = reports;
    CHECK(all >= 2 * mesh.elements.size() / 4096);
    for (limit = 1; limit < all; ++limit) { // nothing is left to cancel at the last one
        CAPTURE(limit);
        stop = std::stop_source();
        progress.stop = stop.get_token();
        reports = 0;
        const Result<MeshDomain> outline = outlineOf(mesh, progress);
        REQUIRE(!outline);
        CHECK(outline.faults().front().code == "cancelled");
        CHECK(reports == limit);
    }
}

TEST_CASE("outlineOf: a mesh along curves gives them back, so that a finer mesh follows them") {
    Document document;
    Shape disc;
    disc.form = CircleForm{};
    disc.nodes = {{2, 1}, {3, 1}};
    document = *addShape(document, disc);
    MeshingJob job;
    job.domain = toDomain(document);
    job.spacing.size = 0.4;
    const Result<MeshingOutcome> coarse = meshDomain(job);
    REQUIRE(coarse);
    const Result<MeshDomain> outline = outlineOf(takeTriMesh(coarse->mesh));
    REQUIRE(outline);
    CHECK(outline->domain.curves == job.domain.curves);
    CHECK(validate(outline->domain).empty());
    job.domain = outline->domain;
    job.spacing.size = 0.05;
    const Result<MeshingOutcome> fine = meshDomain(job);
    REQUIRE(fine);
    std::size_t onCircle = 0;
    for (const TaggedEdge &edge : fine->mesh.edges) {
        onCircle += std::abs(distance(fine->mesh.nodes[index(edge.a)], {2, 1}) - 1.0) <= 1e-12 ? 1U : 0U;
    }
    CHECK(onCircle == fine->mesh.edges.size());
    CHECK(onCircle > 2 * coarse->mesh.edges.size());
}

TEST_CASE("adapt: rounds approach the target for an expression, within the limits") {
    const Result<NodalField> field = expressionField("atan(30*(hypot(x,y)-1))");
    REQUIRE(field);
    const Domain square = squareOf(2.0);
    const AdaptTarget target{0.06, 0.0, 0.5, 0.3};
    const Result<AdaptOutcome> outcome = adaptMesh({square, {}, {}}, uniformMesh(square, 0.2), *field, target, 8);
    REQUIRE(outcome);
    CHECK(outcome->met);
    CHECK(outcome->rounds.back().error <= 0.06);
    CHECK(outcome->rounds.back().error > 0.04); // not much finer than needed
    CHECK(verify(outcome->mesh).empty());
    const Result<AdaptOutcome> again = adaptMesh({square, {}, {}}, uniformMesh(square, 0.2), *field, target, 8);
    CHECK(meshHash(again->mesh) == meshHash(outcome->mesh));
    CHECK(!expressionField("1+*x"));
    const Result<AdaptOutcome> infinite =
        adaptMesh({square, {}, {}}, uniformMesh(square, 0.5), *expressionField("1/x"), target, 2);
    REQUIRE(!infinite);
    CHECK(infinite.faults().front().code == "expression-value");
}

TEST_CASE("adaptOnce: one new mesh from nodal values, finer where they need it") {
    const auto field = expressionField("atan(30*(hypot(x,y)-1))");
    REQUIRE(field);
    const Domain square = squareOf(2.0);
    const TriMesh first = uniformMesh(square, 0.2);
    const Result<std::vector<double>> values = (*field)(first, {});
    REQUIRE(values);
    const AdaptTarget target{0.06, 0.0, 0.5, 0.3};
    std::size_t reports = 0;
    const auto tell = [&](std::size_t round, const AdaptRound &of, const AdaptState &state) {
        ++reports;
        CHECK(round == 0);
        CHECK(of.elements == first.elements.size());
        CHECK(state.estimate.relative() == of.error);
    };
    const Result<AdaptOutcome> outcome = adaptMeshOnce({square, {}, {}}, first, *values, target, {}, tell);
    REQUIRE(outcome);
    CHECK(reports == 1);
    CHECK(outcome->rounds.size() == 1);
    CHECK(outcome->mesh.elements.size() > first.elements.size());
    CHECK(verify(outcome->mesh).empty());
    const Result<AdaptOutcome> rounds = adaptMesh({square, {}, {}}, first, *field, target, 1);
    REQUIRE(rounds);
    CHECK(meshHash(rounds->mesh) == meshHash(outcome->mesh)); // that of the first round
}

TEST_CASE("adapt: reports each round and stops when finer meshes do not lower the error") {
    const auto field = expressionField("atan(1e9*(x-0.5-0.1*y))"); // practically a jump
    REQUIRE(field);
    const Domain square = squareOf(1.0);
    std::vector<double> reported;
    const auto tell = [&](std::size_t round, const AdaptRound &of, const AdaptState &state) {
        CHECK(round == reported.size());
        CHECK(state.mesh.elements.size() == of.elements);
        CHECK(state.values.size() == of.nodes);
        CHECK(state.estimate.elements.size() == of.elements);
        CHECK((state.spacing.background != nullptr) == (round > 0));
        reported.push_back(of.error);
    };
    const Result<AdaptOutcome> outcome =
        adaptMesh({square, {}, {}}, uniformMesh(square, 0.2), *field, {0.02, 0.0, 0.5, 0.3}, 8, {}, tell);
    REQUIRE(outcome);
    CHECK(outcome->stalled);
    CHECK_FALSE(outcome->met);
    CHECK(outcome->rounds.size() < 8);
    REQUIRE(reported.size() == outcome->rounds.size());
    for (std::size_t i = 0; i < reported.size(); ++i) {
        CHECK(reported[i] == outcome->rounds[i].error);
    }
}

TEST_CASE("adapt: every stage of a round can be cancelled at each of its reports") {
    const TriMesh mesh = samples::square(90, 90, 0.2); // 16,200 elements: several reports per stage
    const std::vector<double> values = nodeValues(mesh, [](Vec2 p) { return std::atan(20.0 * (length(p) - 0.7)); });
    const AdaptTarget target{0.02, 0.0, 0.2, 0.3};
    std::vector<std::string> reports;
    std::stop_source stop;
    std::size_t limit = 0;
    Progress progress;
    progress.stop = stop.get_token();
    progress.report = [&](std::string_view stage, double part) {
        CHECK(part >= 0.0);
        CHECK(part <= 1.0);
        reports.emplace_back(stage);
        if (reports.size() == limit) {
            stop.request_stop();
        }
    };
    // Estimation, node spacing, and the spacing field on the mesh as background.
    const auto run = [&]() -> Diagnostics {
        const Result<ErrorEstimate> estimate = estimateError(mesh, values, progress);
        if (!estimate) {
            return estimate.faults();
        }
        const Result<SpacingSpec> spacing = adaptedSpacing(mesh, *estimate, target, progress);
        if (!spacing) {
            return spacing.faults();
        }
        const Domain square = squareOf(1.0);
        const auto field = SpacingField::build(*spacing, square, progress);
        return field ? Diagnostics{} : field.faults();
    };
    REQUIRE(run().empty());
    const std::vector<std::string> all = reports;
    for (const auto &[stage, minimum] : std::map<std::string, std::ptrdiff_t>{
             {"computing the gradient", 4},
             {"finding the elements around nodes", 8},
             {"recovering the gradient", 3},
             {"estimating the error", 4},
             {"choosing the node spacing", 60},
             {"limiting the gradation", 3},
             {"checking the background mesh", 4},
             {"preparing the background mesh", 4},
             {"indexing the background mesh", 8},
             {"dividing the background mesh", 2},
             {"finding the border of the background mesh", 3},
         }) {
        const std::string &name = stage; // clang 14 cannot capture a structured binding
        CAPTURE(name);
        CHECK(std::count(all.begin(), all.end(), name) >= minimum);
    }
    for (limit = 1; limit <= all.size(); ++limit) {
        stop = std::stop_source();
        progress.stop = stop.get_token();
        reports.clear();
        const Diagnostics faults = run();
        CAPTURE(all[limit - 1]);
        REQUIRE(faults.size() == 1);
        CHECK(faults.front().code == "cancelled");
        CHECK(reports.size() == limit); // nothing begins after it
    }
}

TEST_CASE("adapt: can be cancelled in any round, and names the round in each stage") {
    const Result<NodalField> field = expressionField("atan(30*(hypot(x,y)-1))");
    REQUIRE(field);
    const Domain square = squareOf(2.0);
    for (const char *stage :
         {"mesh 0: evaluating the field", "mesh 0: recovering the gradient", "mesh 1: limiting the gradation",
          "mesh 1: advancing the front", "mesh 2: estimating the error"}) {
        CAPTURE(stage);
        std::stop_source stop;
        Progress progress;
        progress.stop = stop.get_token();
        progress.report = [&](std::string_view now, double) {
            if (now == stage) {
                stop.request_stop();
            }
        };
        const Result<AdaptOutcome> outcome =
            adaptMesh({square, {}, {}}, uniformMesh(square, 0.2), *field, {0.06, 0.0, 0.5, 0.3}, 8, progress);
        REQUIRE(stop.stop_requested());
        REQUIRE(!outcome);
        CHECK(outcome.faults().front().code == "cancelled");
    }
}

TEST_CASE(
    "adapt: at a re-entrant corner the energy error falls at the optimal rate, while uniform refinement is slower") {
    using namespace forefront::testing;
    const Domain domain = lShape();
    std::vector<Vec2> uniform, adapted; // energy error against degrees of freedom
    for (const double size : {0.2, 0.1, 0.05, 0.025}) {
        const TriMesh mesh = uniformMesh(domain, size);
        uniform.push_back({static_cast<double>(mesh.nodes.size()), cornerEnergyError(mesh, solveCornerProblem(mesh))});
    }
    const NodalField solver = [](const TriMesh &mesh, const Progress &) -> Result<std::vector<double>> {
        return solveCornerProblem(mesh);
    };
    TriMesh mesh = uniformMesh(domain, 0.2);
    for (const double target : {0.06, 0.03, 0.015, 0.0075}) {
        Result<AdaptOutcome> outcome = adaptMesh({domain, {}, {}}, std::move(mesh), solver, {target, 0.0, 0.5, 0.3}, 5);
        REQUIRE(outcome);
        CHECK(outcome->met);
        mesh = std::move(outcome->mesh);
        const std::vector<double> values = solveCornerProblem(mesh);
        const double exact = cornerEnergyError(mesh, values);
        adapted.push_back({static_cast<double>(mesh.nodes.size()), exact});
        // The estimate agrees with the error.
        CHECK(std::abs(estimateError(mesh, values)->total / exact - 1.0) < 0.15);
    }
    const auto slow = fitPowerLaw(uniform), fast = fitPowerLaw(adapted);
    REQUIRE((slow && fast));
    MESSAGE("slopes: uniform " << slow->exponent << ", adapted " << fast->exponent);
    CHECK(std::abs(slow->exponent + 1.0 / 3.0) < 0.03);
    CHECK(fast->exponent < -0.46);
    CHECK(fast->exponent > -0.6);
    CHECK(adapted.back().y < 0.3 * uniform.back().y);
}
