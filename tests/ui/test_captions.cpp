#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <utility>

namespace forefront::test {

namespace {

bool isCaption(std::string_view name) {
    return name.starts_with("caption/");
}

/// Returns true for the widgets that labels stand beside.
bool isFieldOf(std::string_view name, std::string_view window) {
    return name.starts_with(window) && name.size() > window.size() && name[window.size()] == '/';
}

/// Expects that no label in sight is cut at an edge of its window, or reaches into another widget of these windows.
void expectClear(Driver &driver, const std::string &where, std::initializer_list<std::string_view> windows) {
    driver.settle();
    std::size_t captions = 0;
    for (const auto &[caption, label] : driver.context().widgets.all()) {
        if (!isCaption(caption) || !label.visible) {
            continue;
        }
        ++captions;
        if (label.clip) {
            INFO(where, ": ", caption);
            CHECK(label.rect.x >= label.clip->x - 0.5);
            CHECK(label.rect.x + label.rect.width <= label.clip->x + label.clip->width + 0.5);
        }
        for (const auto &[name, widget] : driver.context().widgets.all()) {
            bool field = false;
            for (const std::string_view window : windows) {
                field = field || isFieldOf(name, window);
            }
            if (field && widget.visible && widget.rect.height < 3.0 * label.rect.height) {
                INFO(where, ": ", caption, " and ", name);
                CHECK_FALSE(label.rect.overlaps(widget.rect));
            }
        }
    }
    INFO(where);
    CHECK(captions > 0);
}

/// Draws one shape of each kind that the inspector shows differently, with named parts.
void drawShapes(Driver &driver) {
    const auto shape = [](ShapeKind kind, std::vector<Vec2> nodes) {
        Shape item;
        item.form = formOf(kind);
        item.nodes = std::move(nodes);
        return item;
    };
    Document drawing = *addShapes({}, {shape(ShapeKind::Rectangle, {{0, 0}, {120000, 80000}}),
                                       shape(ShapeKind::Circle, {{20000, 20000}, {30000, 20000}}),
                                       shape(ShapeKind::Ellipse, {{60000, 40000}, {70000, 40000}, {60000, 45000}}),
                                       shape(ShapeKind::Polygon, {{80000, 10000}, {90000, 10000}, {85000, 20000}})});
    drawing.spacing.sources = {{SourceShape::Box, {1e4, 1e4}, {2e4, 2e4}, 0.0, 4000.0, 0.2, "wake", {}, 20.0},
                               {SourceShape::Line, {1e4, 1e4}, {2e4, 2e4}, 0.0, 4000.0, 0.2, "edge", 5000.0}};
    drawing.regionMarkers = {{{5000, 5000}, 2, 0.0, 0.15}};
    driver.context().document.apply(std::move(drawing), "Draw");
    driver.settle();
    driver.context().actions.run("view.fit", driver.context());
}

void expectClearPanels(Driver &driver) {
    Shell &context = driver.context();
    drawShapes(driver);
    const auto select = [&](const std::string &what, Selection selection) {
        context.selection = std::move(selection);
        driver.showPanel("inspector");
        expectClear(driver, what, {"inspector"});
    };
    for (const std::uint32_t id : {1U, 2U, 3U, 4U}) {
        select("shape " + std::to_string(id), {.shapes = {id}});
        select("segment of " + std::to_string(id), {.segments = {{id, 0}}});
        select("node of " + std::to_string(id), {.nodes = {{id, 0}}});
    }
    select("several shapes", {.shapes = {1, 2}});
    select("box", {.sources = {0}});
    select("line", {.sources = {1}});
    select("region", {.markers = {0}});
    context.selection.clear();
    const std::pair<WorkspaceKind, const char *> panels[] = {{WorkspaceKind::Size, "spacing"},
                                                             {WorkspaceKind::Judge, "checks"},
                                                             {WorkspaceKind::Mesh, "meshing"},
                                                             {WorkspaceKind::Judge, "adapt"}};
    for (const auto &[workspace, panel] : panels) {
        driver.workspace(workspace);
        driver.showPanel(panel);
        expectClear(driver, panel, {panel});
    }
}

} // namespace

TEST_CASE("Labels: none is cut or reaches into a field, at 1280 x 800 and at 1440 x 900 with a scale of 1.5") {
    Driver small({}, {1280, 800}, 1.0);
    expectClearPanels(small);
    Driver large({}, {1440, 900}, 1.5);
    expectClearPanels(large);
}

TEST_CASE("Labels: those of the options bar are whole or left out, for every tool and width") {
    for (const auto &[size, scale] : {std::pair{PixelSize{1280, 800}, 1.0}, std::pair{PixelSize{1440, 900}, 1.5}}) {
        Driver driver({}, size, scale);
        for (const auto &tool : driver.context().tools.tools) {
            driver.context().tools.choose(tool->id(), driver.context());
            driver.settle();
            for (const auto &[caption, label] : driver.context().widgets.all()) {
                const PixelRect bar = driver.context().widgets.find("options")->rect;
                if (!isCaption(caption) || !label.rect.overlaps(bar)) {
                    continue;
                }
                INFO(tool->id(), ": ", caption);
                CHECK(label.rect.x + label.rect.width <= bar.x + bar.width);
                for (const auto &[name, widget] : driver.context().widgets.all()) {
                    if (name.starts_with("options/") && !name.starts_with("options/rest")) {
                        INFO(name);
                        CHECK_FALSE(label.rect.overlaps(widget.rect));
                    }
                }
            }
        }
    }
}

TEST_CASE("Labels: one that is wider than its column is above its field") {
    Driver driver({}, {1280, 800}, 1.0);
    driver.workspace(WorkspaceKind::Judge);
    driver.showPanel("checks");
    driver.settle();
    const WidgetRegistry::Widget *caption = nullptr;
    for (const auto &[name, widget] : driver.context().widgets.all()) {
        caption = name.starts_with("caption/Minimum scaled Jacobian/") ? &widget : caption;
    }
    REQUIRE(caption != nullptr);
    const PixelRect field = driver.context().widgets.find("checks/min-scaled-jacobian")->rect;
    CHECK_FALSE(caption->rect.overlaps(field));
    CHECK((caption->rect.x + caption->rect.width < field.x || caption->rect.y + caption->rect.height <= field.y));
}

} // namespace forefront::test
