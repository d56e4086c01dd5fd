#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

namespace forefront::test {

TEST_CASE("Node sizes: entered in the inspector, they refine the spacing, survive moving the node, and are undone") {
    Draughtsman driver;
    driver.polygon({{1, 1}, {9, 1}, {9, 8}, {1, 8}});
    driver.key('V');
    driver.clickPlace({9, 8});
    REQUIRE(driver.context().selection.nodes.size() == 1);
    driver.fill("inspector/nodesize", "0.05");
    const auto size = [&] { return driver.document().shapes[0]->nodeSizes; };
    REQUIRE(size().size() == 1);
    CHECK(size().begin()->second == PartSize{0.05, 0.2});
    CHECK(driver.undoLabel() == "Change size at node");
    driver.settle();
    CHECK(driver.context().preview->spacing->at({9, 8}) == doctest::Approx(0.05));
    CHECK(driver.context().preview->spacing->sample({9, 8}).describe.find("size at node ") == 0);
    driver.fill("inspector/nodegrowth", "0.5");
    CHECK(size().begin()->second.growth == 0.5);
    driver.dragPlaces({9, 8}, {8, 7});
    driver.settle();
    CHECK(driver.context().preview->spacing->at({8, 7}) == doctest::Approx(0.05));
    driver.fill("inspector/nodesize", "-1");
    CHECK(driver.logHas("bad-size"));
    CHECK(size().begin()->second.size == 0.05);
    driver.click("inspector/nodesize");
    driver.key('A', {Modifiers::kControl});
    driver.key(key::kDelete);
    driver.key(key::kEnter);
    driver.settle();
    CHECK(size().empty());
    driver.key('Z', {Modifiers::kControl});
    CHECK(size().size() == 1);
}

TEST_CASE("Node sizes: entered for several nodes at once") {
    Draughtsman driver;
    driver.polygon({{1, 1}, {9, 1}, {9, 8}, {1, 8}});
    driver.key('V');
    driver.context().selection.clear();
    const std::uint32_t id = driver.document().shapes[0]->id;
    driver.context().selection.nodes = {{id, 0}, {id, 2}};
    driver.settle();
    driver.fill("inspector/nodesize", "0.1");
    CHECK(driver.document().shapes[0]->nodeSizes ==
          std::map<std::uint32_t, PartSize>{{0, {0.1, 0.2}}, {2, {0.1, 0.2}}});
    driver.context().selection.nodes = {{id, 2}};
    driver.settle();
    driver.fill("inspector/nodesize", "0.5");
    driver.context().selection.nodes = {{id, 0}, {id, 1}, {id, 2}};
    driver.settle();
    driver.fill("inspector/nodegrowth", "0.3");
    CHECK(driver.document().shapes[0]->nodeSizes ==
          std::map<std::uint32_t, PartSize>{{0, {0.1, 0.3}}, {2, {0.5, 0.3}}});
}

TEST_CASE("Node sizes: fields of nodes that differ are empty, and an entered number applies to all") {
    Draughtsman driver;
    driver.polygon({{1, 1}, {9, 1}, {9, 8}, {1, 8}});
    driver.key('V');
    const std::uint32_t id = driver.document().shapes[0]->id;
    const auto choose = [&](std::set<NodeRef> nodes) {
        driver.context().selection.clear();
        driver.context().selection.nodes = std::move(nodes);
        driver.settle();
    };
    const auto sizes = [&] { return driver.document().shapes[0]->nodeSizes; };
    choose({{id, 1}});
    driver.fill("inspector/nodesize", "0.1");
    choose({{id, 2}});
    driver.fill("inspector/nodesize", "0.5");
    driver.fill("inspector/nodegrowth", "0.4");
    choose({{id, 1}, {id, 2}});
    driver.fill("inspector/nodegrowth", "0.2"); // the growth of the first node; the second had 0.4
    CHECK(sizes() == std::map<std::uint32_t, PartSize>{{1, {0.1, 0.2}}, {2, {0.5, 0.2}}});
    choose({{id, 0}, {id, 1}, {id, 2}}); // the first one has no size
    driver.fill("inspector/nodegrowth", "0.3");
    CHECK(sizes() == std::map<std::uint32_t, PartSize>{{1, {0.1, 0.3}}, {2, {0.5, 0.3}}});
    choose({{id, 1}, {id, 2}});
    driver.fill("inspector/nodesize", "0.1");
    CHECK(sizes() == std::map<std::uint32_t, PartSize>{{1, {0.1, 0.3}}, {2, {0.1, 0.3}}});
}

} // namespace forefront::test
