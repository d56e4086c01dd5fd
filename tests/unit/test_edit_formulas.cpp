#include "core/drawing/commands/transform.hpp"
#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/place_formulas.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/shapes/slot.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "core/engine/spacing/part_list.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/unit/edit_support.hpp"
#include "tests/unit/plate_sample.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

template <class T>
std::string codeOf(const Result<T> &result) {
    return result ? "" : result.faults().front().code;
}

std::string faultOf(const std::vector<Parameter> &parameters, std::size_t index) {
    return parameterStates(parameters)[index].fault;
}

} // namespace

TEST_CASE("parameterStates: values in any order; bad names, invalid expressions and cycles have faults") {
    const std::vector<ParameterState> states = parameterStates({{"gap", "2*r"}, {"r", "0.4"}, {"f2e3", "2e3 + gap"}});
    CHECK(*states[0].value == doctest::Approx(0.8));
    CHECK(*states[2].value == doctest::Approx(2000.8));
    CHECK(faultOf({{"a", "b"}, {"b", "c"}, {"c", "a"}}, 1).find("depends on itself: a \xe2\x86\x92 b") !=
          std::string::npos);
    CHECK_FALSE(faultOf({{"a", "a + 1"}}, 0).empty());
    CHECK(faultOf({{"a", "b"}, {"b", "1"}, {"c", "d"}, {"d", "d"}}, 0).empty());
    CHECK(faultOf({{"a", "b"}}, 0).find("unknown name 'b'; expected a parameter") != std::string::npos);
    CHECK(faultOf({{"a", "x"}}, 0).find("unknown name 'x'") != std::string::npos);
    CHECK(faultOf({{"a", "1/0"}}, 0).find("not a finite number") != std::string::npos);
    CHECK_FALSE(faultOf({{"2a", "1"}}, 0).empty());
    CHECK_FALSE(faultOf({{"sin", "1"}}, 0).empty());
    CHECK_FALSE(faultOf({{"e", "1"}}, 0).empty());
    CHECK_FALSE(faultOf({{"a", "1"}, {"a", "2"}}, 1).empty());
}

TEST_CASE("overrideParameters: every number with a formula follows; invalid overrides are refused") {
    const Document before = plate();
    const Result<Document> after = overrideParameters(before, {{"r", "0.75"}});
    REQUIRE(after.ok());
    CHECK(boundsOf(*after->shapes[0]) == Box2{{0, 0}, {3, 3}});
    CHECK(circleRadius(*after->shapes[1]) == doctest::Approx(0.75));
    CHECK(after->spacing.sources[0].size == doctest::Approx(0.375));
    CHECK(after->spacing.sources[0].radius == doctest::Approx(1.5));
    CHECK(after->formulas == before.formulas);
    CHECK(codeOf(overrideParameters(before, {{"q", "1"}})) == "unknown-parameter");
    CHECK(codeOf(overrideParameters(before, {{"r", "gap"}})) == "bad-parameter");
    CHECK(codeOf(overrideParameters(before, {{"r", "-1"}})) == "bad-number");                        // of a radius
    CHECK(codeOf(setParameters(before, std::vector<Parameter>{{"r", "1"}})) == "expression-syntax"); // gap is in use
}

TEST_CASE("pruneFormulas: an edited or deleted number loses its formula; the others keep theirs") {
    const Document before = plate();
    Result<Document> moved = setRadius(before, 2, 0.6);
    REQUIRE(moved.ok());
    pruneFormulas(*moved);
    CHECK_FALSE(moved->formulas.contains("shape/2/radius"_number));
    CHECK(moved->formulas.size() == 3);
    Document removed = removeShapes(before, {1});
    pruneFormulas(removed);
    CHECK_FALSE(removed.formulas.contains("shape/1/width"_number));
    CHECK(removed.formulas.size() == 3);
}

TEST_CASE("readNumber: finds every kind of number, and none for missing ones") {
    Document document = plate();
    document.spacing.minimum = 0.125;
    document = *addRegionMarker(document, {{0.5, 0.25}, 1, 0.75});
    CHECK(*readNumber(document, "shape/2/x/1"_number) == 1.5);
    CHECK(*readNumber(document, "shape/1/left"_number) == 0.0);
    CHECK(*readNumber(document, "shape/1/height"_number) == 3.0);
    CHECK(*readNumber(document, "source/0/y"_number) == 1.0);
    CHECK(*readNumber(document, "region/0/area"_number) == 0.75);
    CHECK(*readNumber(document, "spacing/minimum"_number) == 0.125);
    for (const char *address : {"shape/9/x/0", "shape/2/x/7", "shape/2/x", "shape/2/width", "source/1/x", "region/1/x",
                                "region/0/size", "part/4/size", "spacing/maximum", "spacing/foo", "", "shape",
                                "shape/2/radius/1", "foo/1/x", "shape/-1/x/0", "shape/2/x/1/"}) {
        CAPTURE(address);
        const std::optional<NumberAddress> number = parseAddress(address);
        CHECK_FALSE((number && readNumber(document, *number)));
    }
}

TEST_CASE("setNumber: every kind of number can be set and is read back") {
    Document document = plate();
    document = *addShape(document, makeShape(ShapeKind::Ellipse, {{5, 5}, {7, 5}, {5, 6}}));
    document = *addShape(document, makeShape(ShapeKind::Polygon, {{8, 0}, {9, 0}, {9, 1}}));
    document = *addRegionMarker(document, {{0.5, 0.25}, 1, 0.0, 0.5, 0.1});
    document.spacing.size = document.spacing.gradation = document.spacing.segmentsPerTurn = 1.0;
    document.spacing.elementsAcross = document.curveTolerance = 1.0;
    document.spacing.partSizes[3] = {0.5, 0.1};
    document.spacing.sources[0].shape = SourceShape::Line;
    document.spacing.sources[0].endSize = 0.5;
    for (const char *text : {"shape/1/left",
                             "shape/1/bottom",
                             "shape/1/width",
                             "shape/1/height",
                             "shape/1/radius",
                             "shape/2/radius",
                             "shape/2/x/0",
                             "shape/3/rx",
                             "shape/3/ry",
                             "shape/4/y/2",
                             "source/0/x",
                             "source/0/y",
                             "source/0/radius",
                             "source/0/size",
                             "source/0/endSize",
                             "source/0/growth",
                             "region/0/x",
                             "region/0/y",
                             "region/0/area",
                             "region/0/size",
                             "region/0/growth",
                             "source/0/angle",
                             "part/3/size",
                             "part/3/growth",
                             "spacing/size",
                             "spacing/gradation",
                             "spacing/segmentsPerTurn",
                             "spacing/elementsAcross",
                             "spacing/curveTolerance"}) {
        CAPTURE(text);
        const std::optional<NumberAddress> address = parseAddress(text);
        REQUIRE(address.has_value());
        CHECK(toString(*address) == text);
        Document changed = document;
        CHECK(setNumber(changed, *address, 0.625).empty());
        CHECK(checkedOwner(changed, *address).ok());
        CHECK(*readNumber(changed, *address) == doctest::Approx(0.625).epsilon(1e-12));
    }
    const NumberAddress axis = "shape/3/rx"_number, size = "spacing/size"_number;
    Document changed = document;
    CHECK(setNumber(changed, axis, 0.0).front().code == "bad-number");
    changed = document;
    CHECK(setNumber(changed, size, -1.0).empty());
    CHECK(codeOf(checkedOwner(changed, size)) == "bad-size");
}

TEST_CASE("setParameters: numbers that are only valid together change together") {
    Document document = *setParameters({}, {{"r", "10"}});
    document.spacing.minimum = 10.0;
    document.spacing.maximum = 20.0;
    document.formulas = {{"spacing/maximum"_number, "2*r"}, {"spacing/minimum"_number, "r"}};
    for (const char *r : {"1", "100"}) {
        const Result<Document> changed = overrideParameters(document, {{"r", r}});
        REQUIRE(changed.ok());
        CHECK(*changed->spacing.maximum == 2.0 * *changed->spacing.minimum);
        CHECK(changed->formulas == document.formulas);
    }
    Document box = *setParameters({}, {{"a", "1"}, {"b", "2*a"}});
    box = *addShape(box, makeShape(ShapeKind::Rectangle, {{1, 0}, {2, 3}}));
    box.formulas = {{"shape/1/x/0"_number, "a"}, {"shape/1/x/2"_number, "b"}};
    const Result<Document> moved = overrideParameters(box, {{"a", "2"}});
    REQUIRE(moved.ok());
    CHECK(boundsOf(*moved->shapes[0]) == Box2{{2, 0}, {4, 3}});
    const Result<Document> exchanged = overrideParameters(box, {{"a", "2"}, {"b", "1"}});
    REQUIRE(exchanged.ok());
    CHECK(exchanged->shapes[0]->nodes == std::vector<Vec2>{{2, 0}, {1, 3}});
    CHECK(codeOf(overrideParameters(box, {{"b", "a"}})) == "bad-shape");
    document.formulas["spacing/maximum"_number] = "r/2";
    CHECK(codeOf(overrideParameters(document, {{"r", "1"}})) == "bad-size");
}

TEST_CASE("applyFormulas: a corner and the width of one rectangle agree; contradictions are refused") {
    Document document = plate();
    document.formulas = {{"shape/1/x/0"_number, "r"}, {"shape/1/width"_number, "gap"}};
    const Result<Document> moved = applyFormulas(document);
    REQUIRE(moved.ok());
    CHECK(boundsOf(*moved->shapes[0]) == Box2{{0.5, 0}, {1.5, 3}});
    document.formulas = {{"shape/1/x/0"_number, "r"}, {"shape/1/left"_number, "gap"}};
    NumberAddress failed;
    CHECK(codeOf(applyFormulas(document, &failed)) == "bad-formula");
    CHECK((failed.owner == NumberOwner::ofShape(1)));
}

TEST_CASE("carryFormulas: formulas move with nodes, sources and markers whose indices change") {
    Document before = *addShape(plate(), makeShape(ShapeKind::Polygon, {{0, 5}, {1, 5}, {1, 6}, {0, 6}}));
    SizeSource second;
    second.size = 0.125;
    before = *addSource(before, second);
    before.formulas["shape/3/x/2"_number] = "gap";
    before.formulas["source/1/size"_number] = "r/4";
    pruneFormulas(before);
    REQUIRE(before.formulas.size() == 6);

    Document inserted = *insertNode(before, {3, 0}, {0.5, 5});
    carryFormulas(before, inserted);
    CHECK_FALSE(inserted.formulas.contains("shape/3/x/2"_number));
    CHECK(inserted.formulas.at("shape/3/x/3"_number) == "gap");
    Selection corner;
    corner.nodes = {{3, 0}};
    Document deleted = deleteSelection(before, corner);
    carryFormulas(before, deleted);
    CHECK(deleted.formulas.at("shape/3/x/1"_number) == "gap");
    Document fewer = *removeSource(before, 0);
    carryFormulas(before, fewer);
    CHECK(fewer.formulas.at("source/0/size"_number) == "r/4");
    CHECK_FALSE(fewer.formulas.contains("source/0/radius"_number));
    CHECK_FALSE(fewer.formulas.contains("source/1/size"_number));
}

TEST_CASE("carryFormulas: only formulas of changed things are evaluated again") {
    Document before = plate();
    // These no longer hold, so evaluating them would remove them.
    before.formulas["shape/1/height"_number] = "r";
    before.formulas["source/0/growth"_number] = "r";
    before.formulas["shape/2/x/0"_number] = "r";
    Document next = *setRadius(before, 2, 0.75);
    carryFormulas(before, next);
    CHECK(next.formulas.contains("shape/1/height"_number));
    CHECK(next.formulas.contains("source/0/growth"_number));
    CHECK_FALSE(next.formulas.contains("shape/2/radius"_number));
    CHECK_FALSE(next.formulas.contains("shape/2/x/0"_number));
    Document renewed = *setParameters(next, {{"gap", "2*r"}, {"r", "0.5"}, {"new", "1"}});
    carryFormulas(next, renewed);
    CHECK(renewed.spacing.sources[0].growth == 0.5); // set with the parameters
    CHECK(renewed.formulas.contains("source/0/size"_number));
}

TEST_CASE("findShape: finds shapes in any order of their ids") {
    Document document;
    for (const std::uint32_t id : {7U, 3U, 9U, 1U, 12U, 5U}) {
        Shape shape = square({0, 0}, 1);
        shape.id = id;
        document.shapes.push_back(std::make_shared<const Shape>(shape));
    }
    for (std::uint32_t id = 0; id < 14; ++id) {
        CAPTURE(id);
        const Shape *const found = findShape(document, id);
        const std::size_t position = positionOf(document, id);
        CHECK((found != nullptr) == (position < document.shapes.size()));
        CHECK((found == nullptr || found->id == id));
    }
    CHECK(positionOf(document, 9) == 2);
}

TEST_CASE("renameParameter: expressions, formulas and the spacing expression follow") {
    Document document = *setParameters(plate(), {{"gap", "2*r"}, {"r", "0.5"}, {"r2", "r + 1.e2*r"}});
    document = setExpression(document, "r*(1 + x) + r2");
    const Result<Document> renamed = renameParameter(document, 1, "radius");
    REQUIRE(renamed.ok());
    CHECK(renamed->parameters ==
          std::vector<Parameter>{{"gap", "2*radius"}, {"radius", "0.5"}, {"r2", "radius + 1.e2*radius"}});
    CHECK(renamed->formulas.at("shape/2/radius"_number) == "radius");
    CHECK(*renamed->spacing.expression == "radius*(1 + x) + r2");
    for (const char *name : {"gap", "x", "sin", "", "2r", "r s"}) {
        CAPTURE(name);
        CHECK(codeOf(renameParameter(document, 1, name)) == "bad-parameter");
    }
}

TEST_CASE("Parameters: the spacing expression uses their values") {
    Document document = *setParameters({}, {{"h", "0.25"}});
    document = *addShape(document, makeShape(ShapeKind::Rectangle, {{0, 0}, {1, 1}}));
    document = setExpression(document, "h*(1 + x)");
    const auto field = SpacingField::build(document.spacing, toDomain(document));
    REQUIRE(field.ok());
    CHECK((*field)->at({1, 0.5}) == doctest::Approx(0.5));
    const Document changed = *setParameters(document, {{"h", "0.125"}});
    CHECK_FALSE(sameContent(document.spacing, changed.spacing));
    CHECK((*SpacingField::build(changed.spacing, toDomain(changed)))->at({1, 0.5}) == doctest::Approx(0.25));
    const Document without = *setParameters(document, {});
    CHECK(codeOf(SpacingField::build(without.spacing, toDomain(without))) == "expression-syntax");
}

TEST_CASE("parameterStates: long chains, and more parameters than allowed") {
    std::vector<Parameter> chain{{"p0", "1"}};
    for (std::size_t k = 1; k <= kMaxParameters; ++k) {
        chain.insert(chain.begin(), {"p" + std::to_string(k), "p" + std::to_string(k - 1) + " + 1"});
    }
    const std::vector<ParameterState> states = parameterStates(chain);
    CHECK(states.back().fault == "there are 1001 parameters; expected at most 1000");
    chain.erase(chain.begin());
    CHECK(*parameterStates(chain).front().value == static_cast<double>(kMaxParameters));
}

TEST_CASE("parameterStates: parameters that all use each other are a cycle, reported briefly and quickly") {
    std::string all = "p0";
    for (int k = 1; all.size() + 6 < 4000; ++k) {
        all += "+p" + std::to_string(k);
    }
    std::vector<Parameter> tangle;
    for (std::size_t k = 0; k < kMaxParameters; ++k) {
        tangle.push_back({"p" + std::to_string(k), all});
    }
    for (const ParameterState &state : parameterStates(tangle)) {
        CHECK_FALSE(state.value.has_value());
        REQUIRE_FALSE(state.fault.empty());
        REQUIRE(state.fault.size() < 200);
    }
    CHECK(faultOf(tangle, 700).starts_with("depends on itself: p0 \xe2\x86\x92 p1 "));
    CHECK(faultOf(tangle, 700).ends_with("\xe2\x86\x92 \xe2\x80\xa6 \xe2\x86\x92 p0"));
}

TEST_CASE("parameterStates: names and expressions that are too long have faults") {
    CHECK(faultOf({{std::string(kMaxParameterName, 'a'), "1"}}, 0).empty());
    CHECK(faultOf({{std::string(kMaxParameterName + 1, 'a'), "1"}}, 0) ==
          "the name has 101 characters; expected at most 100");
    CHECK(faultOf({{"a", "1" + std::string(5000, ' ')}}, 0).find("5001 characters; expected at most 4000") !=
          std::string::npos);
    CHECK(faultOf({{"a", "b" + std::string(5000, ' ')}, {"b", "a"}}, 0).find("characters") != std::string::npos);
}

TEST_CASE("evaluateFormula: dist needs x and y, which parameters and formulas do not have") {
    const Result<double> value = evaluateFormula({}, "1 + dist(3, 4)");
    REQUIRE_FALSE(value.ok());
    CHECK(value.faults().front().message == "expression, column 5: dist needs x and y; use hypot(a, b)");
    CHECK(*evaluateFormula({}, "hypot(3, 4)") == 5.0);
}

namespace {

/// Returns a document with parameters and formulas whose numbers already have the values.
Document withFormulas(Document document, std::vector<Parameter> parameters,
                      const std::map<NumberAddress, std::string> &formulas) {
    document.formulas = formulas;
    const Result<Document> next = setParameters(document, std::move(parameters));
    REQUIRE_MESSAGE(next.ok(), codeOf(next));
    return *next;
}

} // namespace

TEST_CASE("Formulas: width and length of a slot follow, through moves, turns and a project file") {
    const Shape slot = slotAround({1, 1}, {5, 1}, 0.5);
    const Document document = withFormulas(documentOf({slot}), {{"w", "1"}, {"L", "4"}},
                                           {{"shape/1/length"_number, "L"}, {"shape/1/width"_number, "w"}});
    Document turned = *transformSelection(document, selected({1}), PlaneMap::rotation(90, {1, 1}));
    carryFormulas(document, turned);
    CHECK(turned.formulas == document.formulas);
    const Result<Document> read = parseProject(projectText(turned), "test");
    REQUIRE(read.ok());
    CHECK(sameContent(*read, turned));
    const Result<Document> next = overrideParameters(*read, {{"w", "3"}, {"L", "6"}});
    REQUIRE(next.ok());
    CHECK(next->shapes[0]->kind() == ShapeKind::Slot);
    CHECK(next->shapes[0]->as<SlotForm>().radius == 1.5);
    CHECK(distance(next->shapes[0]->nodes[1], {1, 7}) < 1e-12);
    CHECK(codeOf(overrideParameters(*read, {{"w", "-1"}})) == "bad-number");
}

TEST_CASE("Formulas: an arc keeps its radius while its ends move, also where these meet on the way") {
    // Half a circle about (0, 0), whose ends follow its centre and radius.
    Shape arc = makeShape(ShapeKind::Polyline, {{1, 0}, {-1, 0}}, ShapeUse::Constraint);
    arc.path().curves = {Curve::arc({0, 0}, {1, 0}, {0, 1}, 0.0, std::numbers::pi)};
    const Document document = withFormulas(
        documentOf({arc}), {{"c", "0"}, {"r", "1"}},
        {{"shape/1/x/0"_number, "c + r"}, {"shape/1/x/1"_number, "c - r"}, {"shape/1/arcRadius/0"_number, "r"}});
    const Result<Document> next = overrideParameters(document, {{"c", "-2"}, {"r", "3"}});
    REQUIRE(next.ok());
    const Shape &moved = *next->shapes[0];
    CHECK(moved.nodes == std::vector<Vec2>{{1, 0}, {-5, 0}});
    CHECK(distance(moved.path().curves[0].point(0.5), {-2, 3}) < 1e-9);
    Document apart = document;
    apart.formulas.erase("shape/1/x/0"_number);
    apart.formulas.erase("shape/1/x/1"_number);
    const Result<Document> wider = overrideParameters(apart, {{"r", "2"}});
    REQUIRE(wider.ok());
    CHECK(radiusOf(wider->shapes[0]->path().curves[0]) == doctest::Approx(2.0));
    const Result<Document> small = overrideParameters(apart, {{"r", "0.5"}});
    REQUIRE_FALSE(small.ok());
    CHECK(small.faults().front().message == "the ends of an arc are too far apart for its radius 'r'");
}

TEST_CASE("followLength: the second end follows the length, and the first end where that has formulas") {
    const Document plain = documentOf({makeShape(ShapeKind::Polyline, {{1, 1}, {4, 1}, {4, 4}, {7, 8}})});
    Document document = withFormulas(plain, {{"L", "3"}, {"a", "1"}}, {{"shape/1/x/0"_number, "a"}});
    document = followLength(document, {1, 0}, "L");
    document = followLength(document, {1, 1}, "L");
    document = followLength(document, {1, 2}, "L + 2");
    CHECK(document.formulas.at("shape/1/x/1"_number) == "a + L");
    CHECK_FALSE(document.formulas.contains("shape/1/y/1"_number)); // stays
    CHECK(document.formulas.at("shape/1/x/2"_number) == "a + L");
    CHECK(document.formulas.at("shape/1/y/2"_number) == "1 + L");
    CHECK(document.formulas.at("shape/1/x/3"_number) == "a + L + (L + 2)*0.6");
    pruneFormulas(document);
    CHECK(document.formulas.size() == 6);
    const Result<Document> next = overrideParameters(document, {{"L", "8"}, {"a", "0"}});
    REQUIRE(next.ok());
    const std::vector<Vec2> &nodes = next->shapes[0]->nodes;
    CHECK(nodes[1] == Vec2{8, 1});
    CHECK(nodes[2] == Vec2{8, 9});
    CHECK(distance(nodes[2], nodes[3]) == doctest::Approx(10.0));
    CHECK(followLength(plain, {1, 0}, "3").formulas.empty());
}

TEST_CASE("Place formulas: sums, differences and places at an angle are short") {
    CHECK(sumFormula("1", "2.5") == "3.5");
    CHECK(sumFormula("0", "a") == "a");
    CHECK(sumFormula("a", "-b*2") == "a - b*2");
    CHECK(sumFormula("1", "b > 2 ? 1 : 3") == "1 + (b > 2 ? 1 : 3)");
    CHECK(differenceFormula("a", "b - 1") == "a - (b - 1)");
    CHECK(differenceFormula("a", "-2") == "a + 2");
    const PlaceFormula up = polarFormula({"a", "2"}, "L - 1", "90");
    CHECK(up.x == "a");
    CHECK(up.y == "2 + L - 1");
    const PlaceFormula back = polarFormula({"a", "2"}, "L - 1", "180");
    CHECK(back.x == "a - (L - 1)");
    const PlaceFormula aslant = polarFormula({"0", "2"}, "L", "alpha + 30");
    CHECK(aslant.x == "L*cos((alpha + 30)*pi/180)");
    CHECK(aslant.y == "2 + L*sin((alpha + 30)*pi/180)");
    CHECK_FALSE(usesNames("2*cos(pi/3)"));
    CHECK(usesNames("2*cos(a)"));
}

TEST_CASE("numberName: what a number is, in words") {
    Document document = documentOf({slotAround({0, 0}, {4, 0}, 1), square({0, 0}, 2)});
    document.boundaryNames[1] = "inlet";
    document.spacing.partSizes[1] = {0.1, 0.2};
    document.spacing.size = 1.0;
    CHECK(numberName(document, "shape/1/width"_number) == "width of slot 1");
    CHECK(numberName(document, "shape/2/x/1"_number) == "x of node 2 of polygon 2");
    CHECK(numberName(document, "part/1/size"_number) == "size of inlet");
    CHECK(numberName(document, "spacing/size"_number) == "size of the spacing");
    CHECK(numberName(document, "shape/9/width"_number) == "shape/9/width");
}

TEST_CASE("parseAddress: only texts that toString() writes; addresses are ordered by owner, quantity and handle") {
    for (const char *text : {"", "shape", "shape/1", "shape/1/x", "shape/1/x/", "shape/1/x/0/", "shape/-1/x/0",
                             "shape/1/radius/0", "shape/1/foo", "source/0/x/0", "spacing", "spacing/foo",
                             "spacing/size/0", "foo/1/size", "shape/4294967296/radius"}) {
        CAPTURE(text);
        CHECK_FALSE(parseAddress(text).has_value());
    }
    CHECK((parseAddress("shape/7/x/12") == NumberAddress{NumberOwner::ofShape(7), Quantity::X, 12}));
    CHECK(("shape/2/x/0"_number < "shape/10/height"_number)); // ids by number
    CHECK(("shape/2/x/2"_number < "shape/2/x/10"_number));
    CHECK(("shape/2/width"_number < "shape/2/x/2"_number));
    CHECK(("part/9/size"_number < "region/0/area"_number));
    const auto &words = wordsOf<Quantity>();
    CHECK(std::is_sorted(words.begin(), words.end()));
    const auto &owners = wordsOf<NumberOwner::Kind>();
    CHECK(std::is_sorted(owners.begin(), owners.end()));
}
