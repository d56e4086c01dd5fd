#include "tests/ui/meshed_square.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace forefront::test {

namespace {

/// Opens the panel, high enough for its list of meshes.
void openPanel(Driver &driver) {
    driver.context().settings.tabsHeight = 420.0;
    driver.context().animate();
    driver.settle();
    driver.click("panel/adapt");
    driver.settle();
}

/// A meshed square with the panel that adapts meshes.
class Adapting : public MeshedSquare {
  public:
    Adapting() { openPanel(*this); }
    const AdaptProgress &adaptation() { return context().adaptation.now(); }
    const Mesh &roundMesh(std::size_t round) { return adaptation().rounds[round]->mesh; }
};

} // namespace

TEST_CASE("Adapt: rounds meet the target of an expression; each mesh can be shown, and its spacing kept") {
    Adapting driver;
    const std::uint64_t first = driver.run().meshHash;
    driver.fill("adapt/expression", "atan(2*(x+y-9))");
    driver.fill("adapt/error", "20");
    driver.click("adapt/start");
    driver.settle();
    REQUIRE(driver.adaptation().rounds.size() >= 2);
    CHECK(driver.adaptation().met);
    CHECK(driver.adaptation().rounds.back()->error.value_or(1.0) <= 0.2);
    CHECK(meshHash(driver.roundMesh(0)) == first);
    const std::size_t last = driver.adaptation().rounds.size() - 1;
    CHECK(driver.context().adaptation.selected == last);
    CHECK(driver.run().meshHash == meshHash(driver.roundMesh(last))); // shown as it was made
    CHECK(driver.context().judgement->of.field == "estimated error");
    CHECK(driver.context().judgement->values == driver.adaptation().rounds[last]->errors);

    driver.click("adapt/round/0");
    driver.settle();
    CHECK(driver.run().meshHash == first);
    CHECK(driver.context().judgement->values == driver.adaptation().rounds[0]->errors);
    const WidgetRegistry::Widget *const keep = driver.context().widgets.find("adapt/keep");
    REQUIRE(keep != nullptr);
    CHECK_FALSE(keep->enabled); // the first mesh has the spacing of the drawing already

    driver.click("adapt/round/1");
    driver.settle();
    driver.click("adapt/keep");
    driver.settle();
    CHECK(driver.undoLabel() == "Keep adapted spacing");
    const std::uint64_t second = meshHash(driver.roundMesh(1));
    driver.key(key::kF5);
    driver.settle();
    CHECK_FALSE(driver.context().run.showsFile());
    CHECK(driver.run().meshHash == second); // the drawing makes the same mesh
}

TEST_CASE("Adapt: Esc ends an adaptation and leaves the rounds that are finished") {
    Adapting driver;
    driver.fill("adapt/expression", "sin(3*x)*sin(3*y)");
    driver.fill("adapt/error", "0.05");
    driver.fill("adapt/rounds", "100");
    driver.click("adapt/start");
    driver.until([&] { return driver.adaptation().rounds.size() >= 2; });
    CHECK(driver.has("adapt/progress"));
    driver.moveTo(driver.canvas().centre());
    driver.key(key::kEscape);
    driver.until([&] { return !driver.context().adaptation.busy(); });
    driver.settle();
    CHECK(driver.logHas("cancelled"));
    CHECK_FALSE(driver.adaptation().met);
    CHECK(driver.adaptation().rounds.size() >= 2);
    CHECK(driver.has("adapt/start"));
}

TEST_CASE("Adapt: nodal values of an opened mesh give one new mesh, without an error until they are computed again") {
    MeshedSquare maker;
    MeshFields made{maker.mesh(), {}, {}};
    for (const Vec2 place : made.mesh.nodes) {
        made.fields["heat"].push_back(std::atan(4.0 * (place.x - 5.0)));
    }
    Draughtsman driver;
    driver.context().run.showFile(made);
    openPanel(driver);
    driver.click("adapt/field");
    driver.settle();
    driver.click("adapt/field/heat");
    driver.fill("adapt/error", "10");
    driver.click("adapt/start");
    driver.settle();
    const AdaptProgress &now = driver.context().adaptation.now();
    REQUIRE(now.rounds.size() == 2);
    CHECK(now.rounds[0]->error.value_or(0.0) > 0.1);
    CHECK_FALSE(now.rounds[1]->error);
    CHECK(driver.run().quality.elements > made.mesh.elements.size());
    CHECK(driver.context().view.field.empty());
}

TEST_CASE("Adapt: bad fields and sizes are refused with a message, and another document drops the rounds") {
    Adapting driver;
    const WidgetRegistry::Widget *start = driver.context().widgets.find("adapt/start");
    REQUIRE(start != nullptr);
    CHECK_FALSE(start->enabled); // no field yet
    driver.fill("adapt/expression", "1+*x");
    driver.click("adapt/start");
    driver.settle();
    CHECK(driver.logHas("expression-syntax"));
    CHECK(driver.adaptation().rounds.empty());
    CHECK_FALSE(driver.context().run.showsFile());
    driver.fill("adapt/expression", "x*x");
    driver.fill("adapt/minimum", "2");
    driver.fill("adapt/maximum", "1.5");
    driver.click("adapt/start");
    driver.settle();
    CHECK(driver.logHas("bad-size"));
    driver.fill("adapt/minimum", "0.4");
    driver.click("adapt/start");
    driver.settle();
    REQUIRE_FALSE(driver.adaptation().rounds.empty());
    driver.context().document.load({}, {});
    driver.settle();
    CHECK(driver.adaptation().rounds.empty());
}

} // namespace forefront::test
