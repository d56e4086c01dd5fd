#include "tests/support/temporary_folder.hpp"
#include "ui/dialogs/file_list.hpp"
#include "ui/tools/common/numeric_entry.hpp"
#include "ui/widgets/parse_number.hpp"

#include <doctest/doctest.h>

#include <array>
#include <fstream>
#include <span>
#include <string>

using namespace forefront;
using Answer = NumericEntry::Answer;

namespace {

constexpr std::array kPlace{EntryField::X, EntryField::Y};
constexpr std::array kRadius{EntryField::Radius};
constexpr std::array kDirection{EntryField::Distance, EntryField::Angle};
constexpr std::array kSize{EntryField::Width, EntryField::Height};
using Fields = std::span<const EntryField>;

/// Types like a keyboard: the key first, then its character.
Answer type(NumericEntry &entry, std::string_view text, Fields fields = kDirection) {
    Answer last = Answer::Unused;
    for (const char c : text) {
        const int code = c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c;
        last = entry.handle({.kind = CanvasEvent::Kind::Key, .key = code}, fields);
        const Answer text_ =
            entry.handle({.kind = CanvasEvent::Kind::Text, .character = static_cast<char32_t>(c)}, fields);
        last = text_ == Answer::Unused ? last : text_;
    }
    return last;
}

Answer press(NumericEntry &entry, int code, Fields fields = kDirection) {
    return entry.handle({.kind = CanvasEvent::Kind::Key, .key = code}, fields);
}

} // namespace

TEST_CASE("NumericEntry: a single number is the distance to the next node") {
    NumericEntry entry;
    CHECK(type(entry, "12.5") == Answer::Used);
    CHECK(entry.label() == "distance 12.5_   angle");
    CHECK(press(entry, key::kEnter) == Answer::Place);
    CHECK(entry.locks().distance == 12.5);
    CHECK_FALSE(entry.isOpen());
}

TEST_CASE("NumericEntry: before the first node a number opens the coordinates; other keys stay shortcuts") {
    for (const int code : {int{key::kComma}, int{key::kEqual}, int{'D'}, int{'Q'}}) {
        NumericEntry entry;
        CHECK(press(entry, code, kPlace) == Answer::Unused);
    }
    for (const char *const x : {"2", "-2", ".5"}) {
        NumericEntry entry;
        CHECK(type(entry, x, kPlace) == Answer::Used);
        CHECK(entry.label() == "x " + std::string(x) + "_   y");
        press(entry, key::kTab, kPlace);
        type(entry, "-3", kPlace);
        CHECK(press(entry, key::kEnter, kPlace) == Answer::Place);
        CHECK(entry.locks().x == std::stod(x));
        CHECK(entry.locks().y == -3.0);
    }
}

TEST_CASE("NumericEntry: X and Y lock coordinates; both determine the node") {
    NumericEntry entry;
    CHECK(type(entry, "x-3", kPlace) == Answer::Used);
    CHECK(press(entry, key::kEnter, kPlace) == Answer::Used);
    CHECK(entry.locks().x == -3.0);
    CHECK(type(entry, "y1e2", kPlace) == Answer::Used);
    CHECK(entry.label() == "x -3   y 1e2_");
    CHECK(press(entry, key::kEnter, kPlace) == Answer::Place);
    CHECK(entry.locks().y == 100.0);
    type(entry, "x", kPlace);
    CHECK_FALSE(entry.locks().x.has_value()); // the letter again unlocks it
    CHECK(entry.locks().y == 100.0);
}

TEST_CASE("NumericEntry: Tab moves from distance to angle, Shift+Tab back, and values take effect at once") {
    NumericEntry entry;
    type(entry, "d4");
    CHECK(entry.locks().distance == 4.0); // before Enter
    CHECK(press(entry, key::kTab) == Answer::Used);
    CHECK(type(entry, "30") == Answer::Used);
    CHECK(entry.locks().angle == 30.0);
    const CanvasEvent back{.kind = CanvasEvent::Kind::Key, .key = key::kTab, .modifiers = {Modifiers::kShift}};
    CHECK(entry.handle(back, kDirection) == Answer::Used);
    CHECK(entry.label() == "distance 4_   angle 30");
    type(entry, "5");
    CHECK(press(entry, key::kEnter) == Answer::Place);
    CHECK(entry.locks().distance == 5.0);
    CHECK(entry.locks().angle == 30.0);
}

TEST_CASE("NumericEntry: the letter of another field first commits the typed number") {
    NumericEntry entry;
    type(entry, "d20q90");
    CHECK(entry.locks().distance == 20.0);
    CHECK(entry.locks().angle == 90.0);
    CHECK(press(entry, key::kEnter) == Answer::Place);
    CHECK(entry.locks().distance == 20.0);
    CHECK(entry.locks().angle == 90.0);
}

TEST_CASE("NumericEntry: D is the diameter where a radius is asked for; the one typed last counts") {
    NumericEntry entry;
    type(entry, "d16", kRadius);
    CHECK(entry.label() == "diameter 16_");
    CHECK(entry.locks().distance == 8.0);
    CHECK(entry.expression(EntryField::Radius) == "8"); // a plain number, which needs no formula
    CHECK(press(entry, key::kEnter, kRadius) == Answer::Place);
    CHECK(entry.value(EntryField::Radius) == 8.0);
    entry.clear();
    type(entry, "3", kRadius);
    type(entry, "d", kRadius);
    CHECK(entry.label() == "diameter _");
    type(entry, "10", kRadius);
    CHECK(entry.value(EntryField::Radius) == 5.0);
}

TEST_CASE("NumericEntry: width, Tab, height sets both, and Tab cycles") {
    NumericEntry entry;
    type(entry, "6", kSize);
    press(entry, key::kTab, kSize);
    type(entry, "5", kSize);
    CHECK(entry.value(EntryField::Width) == 6.0);
    CHECK(entry.value(EntryField::Height) == 5.0);
    press(entry, key::kTab, kSize);
    CHECK(entry.label() == "width 6_   height 5");
    CHECK(press(entry, key::kEnter, kSize) == Answer::Place);
    CHECK(entry.value(EntryField::Width) == 6.0);
    CHECK(entry.value(EntryField::Height) == 5.0);
}

TEST_CASE("NumericEntry: two numbers are a point, relative with @") {
    NumericEntry entry;
    type(entry, "3,-4.5");
    REQUIRE(entry.pair().has_value()); // before Enter
    CHECK(press(entry, key::kEnter) == Answer::Place);
    REQUIRE(entry.pair().has_value());
    CHECK(entry.pair()->value == Vec2{3, -4.5});
    CHECK_FALSE(entry.pair()->relative);
    entry.clear();
    type(entry, "@1,2");
    CHECK(press(entry, key::kEnter) == Answer::Place);
    CHECK(entry.pair()->relative);
}

TEST_CASE("NumericEntry: expressions of parameters, also after =, by comma, and with the letters of fields") {
    const NamedValues names{{"r", 0.5}, {"depth", 3.0}};
    const auto typed = [&](NumericEntry &entry, std::string_view text, Fields fields = kDirection) {
        Answer last = Answer::Unused;
        for (const char c : text) {
            const int code = c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c;
            last = entry.handle({.kind = CanvasEvent::Kind::Key, .key = code}, fields, names);
            entry.handle({.kind = CanvasEvent::Kind::Text, .character = static_cast<char32_t>(c)}, fields, names);
        }
        return last;
    };
    NumericEntry entry;
    typed(entry, "2*r");
    CHECK(entry.locks().distance == 1.0); // before Enter
    CHECK(entry.expression(EntryField::Distance) == "2*r");
    CHECK(entry.handle({.kind = CanvasEvent::Kind::Key, .key = key::kTab}, kDirection, names) == Answer::Used);
    typed(entry, "=depth*10");
    CHECK(entry.locks().angle == 30.0);
    CHECK(entry.handle({.kind = CanvasEvent::Kind::Key, .key = key::kEnter}, kDirection, names) == Answer::Place);
    CHECK(entry.expression(EntryField::Angle) == "depth*10");
    entry.clear();
    typed(entry, "d4q9"); // a number is complete, so a letter opens another field
    CHECK(entry.locks().distance == 4.0);
    CHECK(entry.locks().angle == 9.0);
    entry.clear();
    typed(entry, "=max(2, r), depth/2");
    REQUIRE(entry.pair().has_value());
    CHECK(entry.pair()->value == Vec2{2, 1.5});
    CHECK(entry.pair()->yText == "depth/2");
    entry.clear();
    typed(entry, "2*q");
    CHECK(entry.handle({.kind = CanvasEvent::Kind::Key, .key = key::kEnter}, kDirection, names) == Answer::Used);
    CHECK(entry.isWrong());
    CHECK(entry.fault().find("'q'") != std::string::npos);
}

TEST_CASE("NumericEntry: invalid text stays and is marked; Backspace and Esc remove it") {
    NumericEntry entry;
    type(entry, "1-");
    CHECK(press(entry, key::kEnter) == Answer::Used);
    CHECK(entry.isWrong());
    CHECK(entry.isOpen());
    press(entry, key::kBackspace);
    CHECK_FALSE(entry.isWrong());
    CHECK(press(entry, key::kEnter) == Answer::Place);
    CHECK(entry.locks().distance == 1.0);
    entry.clear();
    type(entry, "d-2");
    press(entry, key::kEnter);
    CHECK(entry.isWrong()); // a distance must be positive
    CHECK(press(entry, key::kEscape) == Answer::Used);
    CHECK_FALSE(entry.isOpen());
    CHECK(press(entry, key::kEscape) == Answer::Unused);
}

TEST_CASE("parseNumber and parsePair: accept only finite numbers that make up the entire text") {
    CHECK(parseNumber(" 2.5 ") == 2.5);
    CHECK(parseNumber("+1e-3") == 1e-3);
    for (const char *text : {"", "-", "2x", "1,5", "nan", "inf", "1e999", "0x10"}) {
        CAPTURE(text);
        CHECK_FALSE(parseNumber(text).has_value());
    }
    CHECK(parsePair("1 2")->value == Vec2{1, 2});
    for (const char *text : {"", "1", "1,", ",1", "1,2,3", "@"}) {
        CAPTURE(text);
        CHECK_FALSE(parsePair(text).has_value());
    }
}

TEST_CASE("File list: folders come first, hidden and other files are left out, names are sorted ignoring case") {
    const testing::TemporaryFolder place;
    const std::filesystem::path &folder = place.path;
    for (const char *name : {"b.forefront", "A.Forefront", "mesh.msh", ".hidden.forefront"}) {
        std::ofstream(folder / name) << "12345";
    }
    std::filesystem::create_directory(folder / "zoo");
    const FileFilter projects{"Projects", {".forefront"}, "project"};
    const Result<std::vector<FileEntry>> listed = listFolder(folder, projects);
    REQUIRE(listed.ok());
    REQUIRE(listed->size() == 3);
    CHECK((*listed)[0].name == "zoo");
    CHECK((*listed)[0].folder);
    CHECK((*listed)[1].name == "A.Forefront");
    CHECK((*listed)[1].size == 5);
    CHECK((*listed)[2].name == "b.forefront");
    CHECK(listFolder(folder, {"All", {}, "any"})->size() == 4);
    CHECK(listFolder(folder / "nowhere", projects).faults().front().code == "folder");
}

TEST_CASE("File names: the extension follows the filter, and paths are resolved") {
    const std::vector<FileFilter> all{{"MSH", {".msh"}, "msh2"}, {"VTU", {".vtu"}, "vtu"}, {"All", {}, "any"}};
    CHECK(withExtension("pier", all[0], all) == "pier.msh");
    CHECK(withExtension("pier.vtu", all[0], all) == "pier.msh");
    CHECK(withExtension("pier.v2", all[0], all) == "pier.v2.msh");
    CHECK(withExtension("pier.MSH", all[0], all) == "pier.MSH");
    CHECK(withExtension("pier", all[2], all) == "pier");
    CHECK(resolved("/data", "x.msh") == "/data/x.msh");
    CHECK(resolved("/data", "../x.msh") == "/x.msh");
    CHECK(resolved("/data/a", "..") == "/data");
    CHECK(resolved("/data", "/y/") == "/y");
    CHECK(fileSizeText(999) == "999 B");
    CHECK(fileSizeText(1536) == "1.5 kB");
    CHECK(fileSizeText(2500000) == "2.5 MB");
}
