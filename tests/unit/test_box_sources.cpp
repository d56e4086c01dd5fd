#include "core/drawing/commands/insert_document.hpp"
#include "core/drawing/commands/scale_document.hpp"
#include "core/drawing/commands/transform.hpp"
#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/picking/pick_index.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/geometry/unit_vector.hpp"
#include "core/engine/grid/grid_kind.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "core/engine/spacing/spec/source_box.hpp"
#include "tests/support/domain_builder.hpp"
#include "tests/support/number_literal.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

using namespace forefront;
using forefront::testing::DomainBuilder;
using forefront::testing::RandomSource;

namespace {

SizeSource boxSource(Vec2 a, Vec2 b, double size = 0.1, double growth = 0.2, double angle = 0.0) {
    return {SourceShape::Box, a, b, 0.0, size, growth, "wake", {}, angle};
}

Domain tenSquare() {
    DomainBuilder builder;
    builder.loop({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 1);
    return builder.domain;
}

std::shared_ptr<const SpacingField> fieldFor(const SpacingSpec &spec) {
    const auto field = SpacingField::build(spec, tenSquare());
    REQUIRE(field.ok());
    return *field;
}

/// Returns true if two boxes cover the same points, up to rounding.
bool sameBox(const SizeSource &first, const SizeSource &second) {
    const std::array<Vec2, 4> a = SourceBox(first).corners(), b = SourceBox(second).corners();
    return std::all_of(a.begin(), a.end(), [&](Vec2 p) {
        return std::any_of(b.begin(), b.end(), [&](Vec2 q) { return distance(p, q) < 1e-9; });
    });
}

} // namespace

TEST_CASE("Box sources: the size applies inside and grows with the distance outside") {
    SpacingSpec spec;
    spec.sources = {boxSource({6, 4}, {2, 2})};
    const auto field = fieldFor(spec);
    for (const Vec2 p : {Vec2{2, 2}, Vec2{4, 3}, Vec2{6, 4}, Vec2{2, 4}, Vec2{5.9, 2.1}}) {
        CHECK(field->at(p) == doctest::Approx(0.1));
    }
    CHECK(field->at({7, 3}) == doctest::Approx(0.3));
    CHECK(field->at({4, 1}) == doctest::Approx(0.3));
    CHECK(field->at({9, 8}) == doctest::Approx(0.1 + 0.2 * 5.0)); // 3 and 4 from a corner
    CHECK(field->sample({4, 3}).describe == "source 'wake'");
    CHECK(field->sample({4, 3}).origin == SpacingOrigin::Source);
    spec.sources.push_back(boxSource({7, 7}, {8, 8}, 0.15));
    CHECK(fieldFor(spec)->sample({4, 3}).runnerUp->describe == "source 'wake'");
    spec.minimum = 0.2;
    spec.gradation = 0.1;
    CHECK(fieldFor(spec)->at({7, 3}) == doctest::Approx(0.2 + 0.1 * 0.5)); // the minimum reaches 0.5 beyond the box
}

TEST_CASE("Box sources: a box without extent is a line or a point") {
    SpacingSpec box, line;
    box.sources = {boxSource({2, 3}, {8, 3}), boxSource({4, 8}, {4, 8})};
    line.sources = {{SourceShape::Line, {2, 3}, {8, 3}, 0.0, 0.1, 0.2, ""},
                    {SourceShape::Point, {4, 8}, {}, 0.0, 0.1, 0.2, ""}};
    const auto first = fieldFor(box), second = fieldFor(line);
    RandomSource random(4);
    for (int k = 0; k < 300; ++k) {
        const Vec2 p{random.between(0, 10), random.between(0, 10)};
        REQUIRE(first->at(p) == doctest::Approx(second->at(p)));
    }
}

TEST_CASE("Box sources: the bounds of a field hold, and meshes are the same with every grid and number of threads") {
    SpacingSpec spec;
    spec.sources = {boxSource({6, 4}, {2, 2}, 0.15, 0.3, 25.0)};
    const auto field = fieldFor(spec);
    RandomSource random(7);
    for (int k = 0; k < 500; ++k) {
        const double rho = field->at({random.between(0, 10), random.between(0, 10)});
        REQUIRE(rho >= field->minimum());
        REQUIRE(rho <= field->maximum());
    }
    MeshingJob job{tenSquare(), spec, {}};
    const auto mesh = meshDomain(job);
    REQUIRE(mesh.ok());
    CHECK(mesh->mesh.triangles().size() > 500);
    for (const GridKind grid : valuesOf<GridKind>()) {
        for (const int threads : {1, 2, 3}) {
            job.options.grid = grid;
            job.options.threads = threads;
            const auto other = meshDomain(job);
            REQUIRE(other.ok());
            REQUIRE(other->mesh.nodes == mesh->mesh.nodes);
            REQUIRE(std::ranges::equal(other->mesh.triangles(), mesh->mesh.triangles()));
        }
    }
}

TEST_CASE("Box sources: rotations, mirror images and even scaling keep the box exactly") {
    RandomSource random(9);
    for (int k = 0; k < 200; ++k) {
        const SizeSource box =
            boxSource({random.between(0, 4), random.between(0, 4)}, {random.between(5, 9), random.between(5, 9)}, 0.1,
                      0.2, k % 3 == 0 ? 0.0 : random.between(-200, 200));
        const Document document = *addSource({}, box);
        Selection all;
        all.sources = {0};
        const double angle = k % 2 == 0 ? 90.0 * random.integer(-3, 3) : random.between(-180, 180);
        const PlaneMap map = k % 5 == 0   ? PlaneMap::reflection(angle, {1, 2})
                             : k % 5 == 1 ? PlaneMap::scaling({2.5, 2.5}, {3, 1})
                                          : PlaneMap::rotation(angle, {4, 1});
        const SizeSource moved = transformSelection(document, all, map)->spacing.sources[0];
        const std::array<Vec2, 4> before = SourceBox(box).corners(), after = SourceBox(moved).corners();
        for (const Vec2 corner : before) {
            REQUIRE(std::any_of(after.begin(), after.end(),
                                [&](Vec2 other) { return distance(map(corner), other) < 1e-9; }));
        }
        if (k % 3 == 0 && k % 2 == 0 && k % 5 > 1) {
            CHECK(moved.angle == 0.0);
        }
    }
    // A sheared box keeps its two corners.
    const Document document = *addSource({}, boxSource({0, 0}, {1, 2}, 0.1, 0.2, 30.0));
    Selection all;
    all.sources = {0};
    const PlaneMap wide = PlaneMap::scaling({3.0, 1.0}, {0, 0});
    const SizeSource sheared = transformSelection(document, all, wide)->spacing.sources[0];
    CHECK(sheared.b == Vec2{3, 2});
}

TEST_CASE("Box sources: a corner moves, and the opposite one and the angle stay") {
    for (const double angle : {0.0, 20.0, -130.0}) {
        for (std::size_t corner = 0; corner < 4; ++corner) {
            SizeSource box = boxSource({1, 2}, {4, 6}, 0.1, 0.2, angle);
            const Vec2 opposite = SourceBox(box).corners()[(corner + 2) % 4];
            moveCorner(box, corner, {7, 9});
            CHECK(distance(SourceBox(box).corners()[corner], {7, 9}) < 1e-12);
            CHECK(distance(SourceBox(box).corners()[(corner + 2) % 4], opposite) < 1e-12);
            CHECK(box.angle == angle);
        }
    }
}

TEST_CASE("Box sources: corners and sides are picked, and boxes enclose them") {
    auto document = std::make_shared<Document>(*addSource({}, boxSource({1, 1}, {5, 3})));
    const PickIndex index(document);
    using Part = PickIndex::SourceHit::Part;
    const auto partAt = [&](Vec2 p) {
        const auto hit = index.source(p, 0.2);
        REQUIRE(hit.has_value());
        return hit->part;
    };
    CHECK(partAt({1, 1.1}) == Part::A);
    CHECK(partAt({5.1, 1}) == Part::AfterA);
    CHECK(partAt({5, 3}) == Part::B);
    CHECK(partAt({1, 3}) == Part::AfterB);
    CHECK(partAt({3, 2}) == Part::Whole); // centre
    CHECK(partAt({2, 1.1}) == Part::Whole);
    CHECK_FALSE(index.source({2, 2.5}, 0.2).has_value());
    CHECK(index.inBox({{0, 0}, {6, 4}}, false).sources.size() == 1);
    CHECK(index.inBox({{0, 0}, {6, 2}}, false).sources.empty());
    Selection all;
    all.sources = {0};
    CHECK(boundsOf(*document, all) == Box2{{1, 1}, {5, 3}});
}

TEST_CASE("Box sources: are numbers of the document, and survive projects, copies and changes of scale") {
    Document document = *addSource({}, boxSource({1, 1}, {5, 3}, 0.1, 0.2, 30.0));
    CHECK(readNumber(document, "source/0/x2"_number) == 5.0);
    CHECK(readNumber(document, "source/0/angle"_number) == 30.0);
    const auto read = parseProject(projectText(document), "test");
    REQUIRE(read.ok());
    CHECK(read->spacing.sources == document.spacing.sources);
    const Document pasted = *insertCopied(document, document, {1, 0}, nullptr);
    REQUIRE(pasted.spacing.sources.size() == 2);
    CHECK(pasted.spacing.sources[1].b == Vec2{6, 3});
    CHECK(pasted.spacing.sources[1].angle == 30.0);
    const Document scaled = *scaleDocument(document, {1, 1}, 2.0);
    CHECK(sameBox(scaled.spacing.sources[0], boxSource({1, 1}, {9, 5}, 0.2, 0.2, 30.0)));
    CHECK(scaled.spacing.sources[0].size == 0.2);
    const auto refused = addSource({}, boxSource({0, 0}, {1, std::nan("")}));
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.faults().front().code == "bad-source");
    CHECK_FALSE(addSource({}, boxSource({0, 0}, {1, 1}, 0.1, 0.2, std::nan(""))).ok());
    const auto missing = parseProject("{\"format\": \"forefront\", \"version\": 2, \"shapes\": [], \"spacing\":\n"
                                      "{\"sources\": [{\"shape\": \"box\", \"a\": [0, 0], \"size\": 1}]}}",
                                      "test");
    REQUIRE_FALSE(missing.ok());
    CHECK(missing.faults().front().line == 2);
}

TEST_CASE("Box sources: an angle that a map leaves alone keeps its value, and its formula") {
    Selection all;
    all.sources = {0};
    for (const double angle : {60.0, -100.0, 30.0, 0.0}) {
        const Document document = *addSource({}, boxSource({1, 1}, {5, 3}, 0.1, 0.2, angle));
        CHECK(scaleDocument(document, {0, 0}, 1.7)->spacing.sources[0].angle == angle);
        for (const PlaneMap &map : {PlaneMap::rotation(180, {2, 1}), PlaneMap::rotation(90, {2, 1})}) {
            CHECK(transformSelection(document, all, map)->spacing.sources[0].angle == angle);
        }
    }
    Document named = *addSource({}, boxSource({1, 1}, {5, 3}, 0.1, 0.2, 60.0));
    named.formulas = {{"source/0/angle"_number, "alpha"}};
    named = *setParameters(named, {{"alpha", "60"}});
    CHECK(scaleDocument(named, {0, 0}, 2.0)->formulas.size() == 1);
}

TEST_CASE("Box sources: width and height are numbers, along the angle and across it") {
    for (const double angle : {0.0, 30.0, 60.0, -135.0}) {
        Document document = *addSource({}, boxSource({1000, 1}, {990, 30}, 0.1, 0.2, angle));
        const Vec2 extent = boxExtent(document.spacing.sources[0]);
        CHECK(readNumber(document, "source/0/width"_number) == extent.x);
        document.formulas = {{"source/0/width"_number, "w"}, {"source/0/height"_number, "w/2"}};
        const Result<Document> sized = setParameters(document, {{"w", "0.01"}});
        REQUIRE(sized.ok());
        const SizeSource &box = sized->spacing.sources[0];
        CHECK(box.a == Vec2{1000, 1});
        CHECK(box.angle == angle);
        CHECK(boxExtent(box).x == doctest::Approx(0.01));
        CHECK(boxExtent(box).y == doctest::Approx(0.005));
        const Vec2 before = document.spacing.sources[0].b - box.a, after = box.b - box.a;
        const Vec2 along = unitVector(angle);
        CHECK(dot(before, along) * dot(after, along) > 0.0); // on the same side of its corner
        CHECK(cross(along, before) * cross(along, after) > 0.0);
        const Result<Document> refused = setParameters(*sized, {{"w", "-1"}});
        REQUIRE_FALSE(refused.ok());
        CHECK(refused.faults().front().message == "invalid height -0.5 of a size source; expected a number above 0");
    }
    const Document document = *addSource({}, boxSource({0, 0}, {4, 2}));
    CHECK_FALSE(readNumber(*addSource({}, SizeSource()), "source/0/width"_number));
    SizeSource wide = document.spacing.sources[0];
    resizeBox(wide, {6, 2});
    CHECK(wide.b == Vec2{6, 2});
}

TEST_CASE("Box sources: a new angle turns the box about its centre, and its sides stay") {
    Document document;
    document.spacing.sources = {boxSource({1, 2}, {4, 3}, 0.1, 0.2, 0.0)};
    const Vec2 centre{2.5, 2.5};
    for (const double angle : {30.0, 60.0, 90.0, -135.0, 0.0}) {
        CAPTURE(angle);
        REQUIRE(setNumber(document, "source/0/angle"_number, angle).empty());
        const SizeSource &box = document.spacing.sources[0];
        CHECK(box.angle == angle);
        CHECK(distance(SourceBox(box).centre(), centre) < 1e-12);
        CHECK(boxExtent(box).x == doctest::Approx(3.0));
        CHECK(boxExtent(box).y == doctest::Approx(1.0));
        const Vec2 along = unitVector(angle);
        CHECK(SourceBox(box).distanceTo(centre + 2.5 * along) == doctest::Approx(1.0));
    }
    CHECK(distance(document.spacing.sources[0].a, {1, 2}) < 1e-12);
}

TEST_CASE("Box sources: the box of a selected one holds its radius") {
    SizeSource box = boxSource({0, 0}, {4, 2});
    box.radius = 1.0;
    Selection all;
    all.sources = {0};
    CHECK(boundsOf(*addSource({}, box), all) == Box2{{-1, -1}, {5, 3}});
}
