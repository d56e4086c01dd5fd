#include "core/drawing/constraints/sketch_state.hpp"
#include "core/drawing/document/equality.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/project/project.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/platform/assets.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <memory>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::test;

namespace {

/// Returns a whole number from the environment.
std::uint64_t setting(const char *name, std::uint64_t otherwise) {
    const char *const text = std::getenv(name);
    return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

/// Sends random input to an editor: mostly what a hand does on the canvas, some of it anywhere.
class Hand {
  public:
    Hand(Draughtsman &driver, std::uint64_t seed) : driver_(driver), random_(seed) {}

    /// Sends one event and returns true, or returns false if the event would leave the document or write a file.
    bool act() {
        switch (below(16)) {
        case 0:
        case 1:
        case 2:
        case 3:
        case 4:
            return move();
        case 5:
        case 6:
        case 7:
        case 8:
            return button();
        case 9:
        case 10:
            return key(static_cast<int>('A' + below(26)), tools());
        case 11:
            return key(static_cast<int>('A' + below(26)), anyModifiers());
        case 12:
            return key(kKeys[below(kKeys.size())], anyModifiers());
        case 13:
        case 14:
            return text();
        default:
            return below(4) == 0 ? focus() : scroll();
        }
    }

    /// Lets go of all buttons and keys.
    void letGo() {
        for (int which = 0; which < 3; ++which) {
            send({.kind = InputKind::MouseButton, .code = which, .pressed = false});
        }
        hold({}, false);
        driver_.frames(2);
    }

  private:
    static constexpr std::array<int, 24> kKeys{
        key::kEscape,    key::kEnter,       key::kTab,  key::kBackspace, key::kDelete, key::kLeft,
        key::kRight,     key::kUp,          key::kDown, key::kEscape,    key::kEnter,  key::kDelete,
        key::kBackspace, key::kLeftBracket, key::k0,    key::k9,         key::kPeriod, key::kMinus,
        key::kComma,     key::kEqual,       key::kHome, key::kEnd,       key::kPageUp, key::kPageDown};
    static constexpr std::string_view kText = "0123456789.,-+*/()@=xydqer ";

    std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }
    double part() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

    void send(InputEvent event) {
        event.modifiers = held_;
        driver_.editor().input().push(event);
    }
    void hold(Modifiers wanted, bool pressed) {
        const std::pair<bool, int> keys[] = {
            {wanted.control(), key::kLeftControl}, {wanted.shift(), key::kLeftShift}, {wanted.alt(), key::kLeftAlt}};
        held_ = pressed ? wanted : Modifiers{};
        for (const auto &[down, which] : keys) {
            if (down || !pressed) {
                send({.kind = InputKind::Key, .code = which, .pressed = pressed});
            }
        }
    }

    Modifiers tools() { return below(4) == 0 ? Modifiers{Modifiers::kShift} : Modifiers{}; }
    Modifiers anyModifiers() {
        static constexpr std::array<std::uint8_t, 6> kSets{0,
                                                           Modifiers::kControl,
                                                           Modifiers::kControl,
                                                           Modifiers::kShift,
                                                           Modifiers::kControl | Modifiers::kShift,
                                                           Modifiers::kAlt};
        return {kSets[below(kSets.size())]};
    }

    /// Moves the pointer: a little, to a node or the middle of something drawn, or anywhere.
    bool move() {
        const PixelRect canvas = driver_.canvas();
        const Document &document = driver_.document();
        const std::size_t way = below(8);
        if (way < 3 && !document.shapes.empty()) {
            const Shape &shape = *document.shapes[below(document.shapes.size())];
            const std::vector<Vec2> handles = handlesOf(shape);
            const Vec2 first = handles[below(handles.size())], second = handles[below(handles.size())];
            at_ = driver_.pixel(way == 0 ? 0.5 * (first + second) : first);
            at_ += way == 2 ? Pixel{12.0, -12.0} : Pixel{0.0, 0.0};
        } else if (way < 5) {
            at_ += Pixel{40.0 * part() - 20.0, 40.0 * part() - 20.0};
        } else if (way < 7) {
            at_ = Pixel{canvas.x + part() * canvas.width, canvas.y + part() * canvas.height};
        } else {
            const PixelSize size = driver_.platform().framebufferSize();
            at_ = Pixel{part() * size.width, part() * size.height};
        }
        send({.kind = InputKind::MouseMove, .x = at_.x, .y = at_.y});
        return true;
    }
    /// Returns true if the pointer is over a tab: a press could close it and ask to save it.
    bool overTab() {
        const PixelRect canvas = driver_.canvas();
        return driver_.context().tabs.size() > 1 && at_.y < canvas.y && !canvas.contains(at_);
    }
    /// Presses or releases a button, mostly the left one. Menus load and save files, so they are left alone.
    bool button() {
        if (!down_ && overTab()) {
            return false;
        }
        if (!driver_.canvas().contains(at_) && !down_) {
            const WidgetRegistry::Widget *const menu = driver_.context().widgets.find("menu/File");
            if (menu != nullptr && at_.y < menu->rect.y + 2.0 * menu->rect.height) {
                return false;
            }
        }
        if (!down_) {
            which_ = below(12) == 0 ? 1 : below(30) == 0 ? 2 : 0;
        }
        down_ = !down_;
        send({.kind = InputKind::MouseButton, .code = which_, .pressed = down_});
        return true;
    }
    /// Taps a key, unless it would open, load, save or mesh something.
    bool key(int code, Modifiers modifiers) {
        constexpr std::string_view kFiles = "NOSQEIPW";
        const bool files = modifiers.control() && code < 128 && kFiles.find(static_cast<char>(code)) != kFiles.npos;
        if (files) {
            return false;
        }
        hold(modifiers, true);
        send({.kind = InputKind::Key, .code = code, .pressed = true});
        send({.kind = InputKind::Key, .code = code, .pressed = false});
        hold({}, false);
        return true;
    }
    bool text() {
        const char character = kText[below(kText.size())];
        if (character >= '1' && character <= '9' && !driver_.context().tools.current().hasOptions(driver_.context())) {
            return false;
        }
        send({.kind = InputKind::Text, .code = character});
        return true;
    }
    bool scroll() {
        send({.kind = InputKind::Scroll, .y = part() < 0.5 ? -1.0 : 1.0});
        return true;
    }
    bool focus() {
        send({.kind = InputKind::Focus, .pressed = below(2) == 0});
        return true;
    }

    Draughtsman &driver_;
    std::mt19937_64 random_;
    Pixel at_{320.0, 240.0};
    Modifiers held_;
    bool down_ = false;
    int which_ = 0;
};

/// Closes dialogs and popups, and ends what is unfinished.
void comeToRest(Draughtsman &driver, Hand &hand) {
    hand.letGo();
    for (int k = 0; k < 6; ++k) {
        driver.key(key::kEscape);
    }
    driver.key('V');
    driver.frames(4);
}

/// Looks at each document that comes, so that a fault is reported with the command that made it.
class Watch {
  public:
    explicit Watch(const DocumentStore &store) : loads_(store.loads()), last_(store.current()) {
        starts_[loads_] = last_;
    }

    /// Checks the shapes that were not in the last document.
    void look(const DocumentStore &store) {
        if (store.current() == last_) {
            return;
        }
        ++changes_;
        last_ = store.current();
        if (store.loads() != loads_) {
            loads_ = store.loads();
            starts_.try_emplace(loads_, last_); // kept while it is in another tab
        }
        std::set<std::shared_ptr<const Shape>> shapes(last_->shapes.begin(), last_->shapes.end());
        for (const auto &shape : shapes) {
            if (sound_.contains(shape)) {
                continue;
            }
            const Diagnostics faults = checkShape(*shape);
            if (!faults.empty()) {
                Document alone;
                alone.shapes = {shape};
                INFO("after the command \"" << store.undoLabel() << "\", step " << store.step() << ": "
                                            << faults.front().message << "\n"
                                            << projectText(alone));
                REQUIRE(faults.empty());
            }
        }
        sound_ = std::move(shapes);
    }

    /// Returns the document that the history begins with: the empty one, or that of a lesson that was opened.
    const Document &start() const { return *starts_.at(loads_); }
    std::size_t changes() const { return changes_; }

  private:
    std::uint64_t loads_;
    std::map<std::uint64_t, std::shared_ptr<const Document>> starts_; ///< by DocumentStore::loads()
    std::shared_ptr<const Document> last_;
    std::size_t changes_ = 0;
    std::set<std::shared_ptr<const Shape>> sound_; ///< held, so that no other shape gets the address of one of them
};

/// Checks what must hold for every document in the editor.
void checkSound(Draughtsman &driver, Watch &watch) {
    const Document &document = driver.document();
    watch.look(driver.context().document);
    Selection pruned = driver.context().selection;
    pruned.prune(document);
    REQUIRE(pruned == driver.context().selection);
    Document held = document;
    pruneFormulas(held);
    REQUIRE(held.formulas == document.formulas);
    const SketchState sketch = sketchState(document);
    INFO("after the command \"" << driver.context().document.undoLabel() << "\"\n" << projectText(document));
    REQUIRE(sketch.violated.empty());
}

/// Goes back to the document that the test began with where random input has deleted most of it, or made it so large
/// that every step takes longer and tries nothing new.
void renew(DocumentStore &store, const Document &beginning) {
    constexpr std::size_t kMaxShapes = 40, kMaxNodes = 1000;
    const Document &document = *store.current();
    const std::size_t nodes =
        std::accumulate(document.shapes.begin(), document.shapes.end(), std::size_t{0},
                        [](std::size_t sum, const auto &shape) { return sum + shape->nodes.size(); });
    const bool large = document.shapes.size() > kMaxShapes || nodes > kMaxNodes;
    const bool small = 2 * document.shapes.size() < beginning.shapes.size() ||
                       2 * document.constraints.size() < beginning.constraints.size();
    if (large || small) {
        Document next = beginning;
        next.nextId = std::max(document.nextId, beginning.nextId);
        store.replace(std::move(next), "Begin again");
    }
}

/// Returns a map of 3 x 3 regions: borders with a node between them, which meet where three or four regions do.
Document neighbours() {
    std::vector<Shape> shapes;
    const auto add = [&shapes](ShapeKind kind, std::vector<Vec2> nodes) {
        Shape shape;
        shape.form = formOf(kind);
        shape.nodes = std::move(nodes);
        shapes.push_back(std::move(shape));
    };
    const auto place = [](int i, int j) { return Vec2{i + 0.1 * ((i + 2 * j) % 3), j + 0.1 * ((2 * i + j) % 3)}; };
    add(ShapeKind::Polygon, {place(0, 0), place(1, 0), place(2, 0), place(3, 0), place(3, 1), place(3, 2), place(3, 3),
                             place(2, 3), place(1, 3), place(0, 3), place(0, 2), place(0, 1)});
    for (int i = 0; i < 3; ++i) {
        for (int j = 1; j < 3; ++j) {
            const Vec2 across = 0.5 * (place(i, j) + place(i + 1, j)), up = 0.5 * (place(j, i) + place(j, i + 1));
            add(ShapeKind::Polyline, {place(i, j), across + Vec2{0.0, 0.05}, place(i + 1, j)});
            add(ShapeKind::Polyline, {place(j, i), up + Vec2{0.05, 0.0}, place(j, i + 1)});
        }
    }
    Document map = *addShapes({}, std::move(shapes));
    for (int k = 0; k < 9; ++k) {
        map.regionMarkers.push_back({{k % 3 + 0.5, k / 3 + 0.5}, k + 1});
    }
    return map;
}

/// Sends random input to a document that is open, then undoes and redoes all that it did.
void attack(Draughtsman &driver) {
    const std::uint64_t events = setting("FOREFRONT_FUZZ_EVENTS", 2000);
    const std::uint64_t seed = setting("FOREFRONT_FUZZ_SEED", 7);
    CAPTURE(seed);
    driver.context().snapping.infers = true;
    const std::shared_ptr<const Document> beginning = driver.context().document.current();
    REQUIRE(sketchState(*beginning).violated.empty());
    Hand hand(driver, seed);
    Watch watch(driver.context().document);
    std::uint64_t count = 0;
    while (count < events) {
        CAPTURE(count);
        if (!hand.act()) {
            continue;
        }
        if (++count % 3 == 0) { // more would be a backlog, and the hand would aim at what was drawn long ago
            driver.platform().show(count % 30 == 0); // drawing all frames takes long
            while (!driver.editor().input().empty()) {
                driver.frames(1);
                watch.look(driver.context().document);
            }
        }
        if (count % 500 == 0) {
            checkSound(driver, watch);
            renew(driver.context().document, *beginning);
        }
        driver.context().quit = false;
    }
    comeToRest(driver, hand);
    checkSound(driver, watch);
    CHECK(watch.changes() > events / 200); // it did draw

    while (driver.context().document.redo()) {
    }
    const Document last = driver.document();
    const Result<Document> read = parseProject(projectText(last), "the fuzzer");
    REQUIRE(read.ok());
    CHECK_MESSAGE(sameContent(*read, last), projectText(last), "\nis read as\n", projectText(*read));
    while (driver.context().document.undo()) {
        checkSound(driver, watch);
    }
    CHECK(sameContent(driver.document(), watch.start()));
    driver.platform().show(true);
    driver.frames(2);
    while (driver.context().document.redo()) {
    }
    CHECK(sameContent(driver.document(), last));
    driver.frames(2);
}

/// An editor with an empty drawing and folders of its own.
struct Attacked {
    TemporaryFolder folder;
    Draughtsman driver{{.settingsFolder = folder.path / "settings", .stateFolder = {}}, {800, 600}};

    Attacked() { driver.context().settings.recentFiles = {(folder.path / "none.forefront").string()}; } // of dialogs
    void open(Document document) {
        driver.context().document.load(std::move(document), {});
        driver.settle();
        driver.key(key::kHome); // fits the view
        driver.settle();
    }
};

} // namespace

// FOREFRONT_FUZZ_EVENTS and FOREFRONT_FUZZ_SEED choose more events, and others.
TEST_CASE("Fuzz: random input leaves a valid document that can be undone to its start and redone") {
    Attacked attacked;
    attack(attacked.driver);
}

TEST_CASE("Fuzz: random input to a sketch leaves no constraint that does not hold") {
    const Result<Document> bracket = readDocument(assetFolder() / "samples/bracket.json");
    REQUIRE(bracket.ok());
    REQUIRE(!bracket->constraints.empty());
    Attacked attacked;
    attacked.open(*bracket);
    attack(attacked.driver);
}

TEST_CASE("Fuzz: random input to a map of neighbours leaves a valid document") {
    Attacked attacked;
    attacked.open(neighbours());
    attack(attacked.driver);
}
