#pragma once

#include "core/drawing/shapes/shape_geometry.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/ui/driver.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace forefront::test {

/// A driver that works in drawing coordinates. Starts with an empty drawing, with about 10 x 10 units in view.
/// Relations are not sought and the grid has steps of a tenth, so that nodes are where they are clicked.
class Draughtsman : public Driver {
  public:
    explicit Draughtsman(EditorSetup setup = {}, PixelSize size = {1280, 800})
        : Driver(withoutSample(std::move(setup)), size) {
        key('N', {Modifiers::kControl});
        settle();
        context().snapping.infers = false;
        context().snapping.gridStep = 0.1;
    }

    Pixel pixel(Vec2 place) { return context().view.camera.toPixel(place); }
    void clickPlace(Vec2 place) {
        clickAt(pixel(place));
        frames(30); // so that the next click does not make a double-click
    }
    void doubleClickPlace(Vec2 place) {
        clickAt(pixel(place));
        clickAt(pixel(place));
        frames(30);
    }
    void moveToPlace(Vec2 place) { moveTo(pixel(place)); }
    void dragPlaces(Vec2 from, Vec2 to) {
        drag(pixel(from), pixel(to));
        frames(30);
    }
    const Document &document() { return *context().document.current(); }
    std::string undoLabel() { return context().document.undoLabel(); }
    /// Enters a file in an open file dialog, such as "import", and confirms it.
    void chooseFile(const std::string &dialog, const std::filesystem::path &file) {
        click("dialog/" + dialog + "/name");
        key('A', {Modifiers::kControl});
        type(file.string());
        click("dialog/" + dialog + "/ok");
        settle();
    }
    /// Draws a rectangle with its tool.
    void rectangle(Vec2 a, Vec2 b) {
        key('R');
        dragPlaces(a, b);
    }
    void polygon(const std::vector<Vec2> &corners) {
        key('P');
        for (const Vec2 corner : corners) {
            clickPlace(corner);
        }
        key(key::kEnter);
    }
    /// Types a text into a field and commits it with Enter.
    void fill(std::string_view field, std::string_view text) {
        click(field);
        key('A', {Modifiers::kControl});
        type(text);
        key(key::kEnter);
        settle();
    }
    bool logHas(std::string_view code) {
        for (const MessageLog::Entry &entry : context().log.entries()) {
            if (entry.diagnostic.code == code) {
                return true;
            }
        }
        return false;
    }

  private:
    static EditorSetup withoutSample(EditorSetup setup) {
        setup.sample = false;
        return setup;
    }
};

using testing::TemporaryFolder;

} // namespace forefront::test
