#include "core/drawing/commands/carry_joints.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/clipboard/node_table.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

/// Returns a triangle, a circle and a rectangle, with the ids 1 to 3.
Document tabulated() {
    return *addShapes({}, {makeShape(ShapeKind::Polygon, {{0, 0}, {4, 0}, {0.1, 1.0 / 3.0}}),
                           makeShape(ShapeKind::Circle, {{7, 7}, {8, 7}}),
                           makeShape(ShapeKind::Rectangle, {{10, 0}, {12, 1}})});
}

NodeTableResult placed(const Document &document, std::string_view text, const std::set<std::uint32_t> &shapes = {1}) {
    return placeNodes(document, shapes, linesOf(text));
}

const std::vector<Vec2> &nodesOf(const NodeTableResult &result, std::size_t shape = 0) {
    REQUIRE_MESSAGE(result.next.has_value(), result.fault);
    return result.next->shapes[shape]->nodes;
}

} // namespace

TEST_CASE("Table of nodes: what is copied has all digits and moves nothing when it comes back") {
    const Document document = tabulated();
    const std::vector<NodeRow> rows = nodeRows(document, {1, 2, 3});
    REQUIRE(rows.size() == 9);
    const std::string text = nodeTableText(rows);
    CHECK(text.starts_with("shape\tnode\tx\ty\n1\t1\t0\t0\n1\t2\t4\t0\n1\t3\t0.1\t0.3333333333333333\n2\t1\t7\t7\n"));
    const NodeTableResult again = placed(document, text, {});
    REQUIRE(again.next.has_value());
    CHECK(again.moved == 0);
    for (std::size_t k = 0; k < document.shapes.size(); ++k) {
        CHECK(*again.next->shapes[k] == *document.shapes[k]);
    }
}

TEST_CASE("Table of nodes: a node at a negative zero is listed at 0") {
    const Document document = documentOf({makeShape(ShapeKind::Polyline, {{-0.0, 1}, {2, -0.0}})});
    CHECK(nodeTableText(nodeRows(document, {1})) == "shape\tnode\tx\ty\n1\t1\t0\t1\n1\t2\t2\t0\n");
}

TEST_CASE("Table of nodes: separators, decimal commas and headings") {
    const std::vector<Vec2> expected{{0, 0}, {4.5, 0}, {0, 1200.25}};
    for (const std::string_view text : {
             "0\t0\n4.5\t0\n0\t1200.25\n",           // a spreadsheet
             "0\t0\n4,5\t0\n0\t1.200,25\n",          // with decimal commas and thousands
             "0;0\r\n4,5;0\r\n\r\n0;1200,25",        // lines of Windows, an empty one
             "0,0\n4.5,0\n0,1200.25",                // values separated by commas
             "0, 0\n4.5, 0\n0, 1200.25",             // and blanks
             "0,0 0,0\n4,5 0\n0 1200,25",            // decimal commas between blanks
             "X,Y\n0,0\n4.5,0\n0,1200.25",           // a heading
             "0\t0\n4,5; 0\n0\t1200,25",             // a line with a separator of its own
             "y;name;x\n0;a;0\n0;b;4,5\n1200,25;c;0" // other columns, another order
         }) {
        CAPTURE(text);
        CHECK(nodesOf(placed(tabulated(), text)) == expected);
    }
}

TEST_CASE("Table of nodes: rows that name their nodes may be some of them, of several shapes, in any order") {
    const NodeTableResult result =
        placed(tabulated(), "node\tshape\tx\ty\n2\t2\t9\t7\n3\t1\t1\t2\n3\t3\t13\t2\n1\t1\t0\t0\n", {});
    CHECK(result.moved == 3);
    CHECK(nodesOf(result) == std::vector<Vec2>{{0, 0}, {4, 0}, {1, 2}});
    CHECK(nodesOf(result, 1) == std::vector<Vec2>{{7, 7}, {9, 7}});
    CHECK(nodesOf(result, 2) == std::vector<Vec2>{{10, 0}, {13, 2}});
}

TEST_CASE("Table of nodes: joined nodes follow, and a plain path may get another number of nodes") {
    Document document = tabulated();
    document = *addShape(document, makeShape(ShapeKind::Polyline, {{4, 0}, {6, -2}}));
    const NodeTableResult moved = placed(document, "1\t2\t5\t0.5\n");
    REQUIRE(moved.next.has_value());
    const Result<Document> joined = carryJoints(document, *moved.next);
    REQUIRE(joined.ok());
    CHECK(joined->shapes[3]->nodes == std::vector<Vec2>{{5, 0.5}, {6, -2}});

    CHECK(nodesOf(placed(document, "0 0\n3 0\n3 3\n0 3\n")) == std::vector<Vec2>{{0, 0}, {3, 0}, {3, 3}, {0, 3}});
    Shape tagged = *document.shapes[0];
    tagged.segmentTags = {1, 2, 3};
    const Document special = *replaceShape(document, tagged);
    CHECK(placed(special, "0 0\n3 0\n3 3\n0 3\n").fault ==
          "the table has 4 lines, but polygon 1 has 3 nodes; give it one line for each node");
    CHECK(placed(special, "0 0\n3 0\n3 3\n").next.has_value());
}

TEST_CASE("Table of nodes: a line that cannot be used is named, and then none is") {
    const Document document = tabulated();
    const auto faultsOf = [&](std::string_view text) {
        const NodeTableResult result = placed(document, text);
        CHECK_FALSE(result.next.has_value());
        CHECK(result.fault == "");
        std::string all;
        for (const TableFault &fault : result.faults) {
            all += std::to_string(fault.line) + ": " + fault.reason + '\n';
        }
        return all;
    };
    CHECK(faultsOf("0\t0\n4\tfour\n1\n") == "1: expected a number, got 'four'\n2: expected 2 columns, got 1\n");
    CHECK(faultsOf("0\t0\n4\t1e999\n1\t1\n") == "1: expected a number, got '1e999'\n");
    CHECK(faultsOf("shape\tnode\tx\ty\n9\t1\t0\t0\n1\t4\t0\t0\n1\t0\t1\t1\n") ==
          "1: shape 9 not found\n2: node 4 not found; polygon 1 has 3 nodes\n"
          "3: expected the number of a node, got '0'\n"); // all at once
    CHECK(faultsOf("shape\tnode\tx\ty\n9\t1\t0\t0\n1\t4\t0\t0\n2\t1\t1\t1\n2\t1\t2\t2") ==
          "1: shape 9 not found\n2: node 4 not found; polygon 1 has 3 nodes\n"
          "4: node 1 of circle 2 is also in line 4\n");
    CHECK(faultsOf("3\t1\t9\t0\n3\t2\t13\t0.5\n") ==
          "0: node 1 of rectangle 3 would be at (9, 0.5), as its other nodes say; convert the shape to a path to move "
          "it alone\n");
}

TEST_CASE("Table of nodes: the order of the rows does not matter, and none is left unused") {
    const Document document = tabulated();
    for (const std::string_view text : {"2\t1\t7.5\t7\n2\t2\t8\t7\n", "2\t2\t8\t7\n2\t1\t7.5\t7\n"}) {
        const NodeTableResult circle = placed(document, text, {});
        CHECK(nodesOf(circle, 1) == std::vector<Vec2>{{7.5, 7}, {8, 7}});
        CHECK(circle.moved == 1);
    }
    const NodeTableResult corner = placed(document, "3\t1\t9\t0\n3\t2\t12\t0\n3\t3\t12\t1\n3\t4\t10\t1\n", {});
    CHECK_FALSE(corner.next.has_value());
    REQUIRE(corner.faults.size() == 1);
    CHECK(corner.faults[0].line == 0);
    CHECK(nodesOf(placed(document, "3\t4\t9\t1\n3\t3\t12\t1\n3\t2\t12\t0\n3\t1\t9\t0\n", {}), 2) ==
          std::vector<Vec2>{{9, 0}, {12, 1}});
}

TEST_CASE("Table of nodes: numbers with wrong groups of thousands or two signs are refused, ambiguous commas too") {
    const Document document = tabulated();
    for (const std::string_view number :
         {"1.2.2024,5", "1,.5", "+-5", "1,2,3", "12,34.5", ",123.5", "1.2345,5", "--1", "1.234.,5"}) {
        CAPTURE(number);
        const NodeTableResult result = placed(document, std::string(number) + "\t0\n4\t0\n0\t1\n");
        REQUIRE(result.faults.size() == 1);
        CHECK(result.faults[0].line == 0);
    }
    CHECK(nodesOf(placed(document, "-1.234.567,5\t0\n+4,\t,5\n-0\t1e1\n")) ==
          std::vector<Vec2>{{-1234567.5, 0}, {4, 0.5}, {0, 10}});
    CHECK(nodesOf(placed(document, "1,234.5\t0\n4\t0\n0\t1\n"))[0].x == 1234.5);
    CHECK(nodesOf(placed(document, "1,234\t0,5\n4\t0\n0\t1\n"))[0].x == 1.234);
    CHECK(placed(document, "1,234\t0\n4\t0\n0\t1,500\n").fault ==
          "'1,234' in line 1 may be 1.234 or 1234; write decimal points, or another number of decimals, and no "
          "thousands separators");
}

TEST_CASE("Table of nodes: tables that have no meaning are refused as a whole") {
    const Document document = tabulated();
    const auto faultOf = [&](std::string_view text, const std::set<std::uint32_t> &shapes = {1}) {
        const NodeTableResult result = placed(document, text, shapes);
        CHECK_FALSE(result.next.has_value());
        CHECK(result.faults.empty());
        return result.fault;
    };
    CHECK(faultOf(" \n\n") == "the table is empty; expected lines with two numbers, x and y");
    CHECK(faultOf("1,5,2,5\n").starts_with("four numbers separated by commas may be two with decimal commas"));
    CHECK(faultOf("name\tvalue\n1\t2\n").starts_with("the heading 'name\tvalue' has no columns x and y"));
    CHECK(faultOf("node\tx\ty\n1\t2\t3\n").starts_with("the table has a column node but none shape"));
    CHECK(faultOf("x\ty\n") == "the table has a heading but no lines with numbers");
    CHECK(faultOf("1\t2\n", {1, 2}).starts_with("two columns are the nodes of one shape"));
    CHECK(faultOf("1\t2\n", {2}) == "the table has 1 line, but circle 2 has 2 nodes; give it one line for each node");
    Document locked = *setLocked(document, {1}, true);
    const NodeTableResult kept = placed(locked, "0\t0\n4\t0\n0\t9\n");
    REQUIRE(kept.faults.size() == 1);
    CHECK(kept.faults[0].reason == "polygon 1 is locked; unlock it to move its nodes");
}
