#include "tests/ui/edit_driver.hpp"
#include "ui/workspace/messages/option_hints.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>

namespace forefront::test {

TEST_CASE("Notes on files name what to do in the editor, not options of the command line") {
    const TemporaryFolder place;
    std::ofstream(place.path / "inked.svg") << R"(<svg viewBox="0 0 10 10"><rect width="9" height="6"/>)"
                                            << R"(<path fill="none" stroke="black" d="M1 1L3 5H1Z"/></svg>)";
    std::ofstream(place.path / "gap.geojson")
        << R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {}, "geometry": )"
        << R"({"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,3],[0,3],[0,0]]]}}, )"
        << R"({"type": "Feature", "properties": {}, "geometry": )"
        << R"({"type": "Polygon", "coordinates": [[[4.001,0],[8,0],[8,3],[4.001,3],[4.001,0]]]}}]})";
    std::ofstream(place.path / "atlas.json")
        << R"({"type": "Topology", "arcs": [[[0, 0], [4, 0], [4, 3], [0, 0]]], "objects": {"land": {"type": "Polygon", )"
        << R"("arcs": [[0]], "properties": {"nom": "A"}}, "sea": {"type": "Point", "coordinates": [1, 1]}}})";
    Draughtsman driver;
    const auto log = [&] {
        std::string text;
        for (const MessageLog::Entry &entry : driver.context().log.entries()) {
            text += entry.diagnostic.message + '\n' + entry.diagnostic.advice + '\n';
        }
        driver.context().log.clear();
        return text;
    };
    const auto expectHints = [](const std::string &text, std::initializer_list<const char *> hints) {
        CHECK_MESSAGE(text.find("--") == std::string::npos, text);
        for (const char *hint : hints) {
            CHECK_MESSAGE(text.find(std::string("in File > Import drawing, ") + hint) != std::string::npos, text);
        }
    };
    log();
    for (const bool opens : {true, false}) {
        CAPTURE(opens);
        for (const char *file : {"inked.svg", "gap.geojson", "atlas.json"}) {
            driver.key(opens ? 'O' : 'I', {Modifiers::kControl});
            driver.frames(5);
            driver.chooseFile(opens ? "open" : "import", place.path / file);
            if (!opens) {
                driver.click("dialog/importoptions/ok");
                driver.settle();
            }
        }
        expectHints(log(), {"\"Leave out lines\" leaves", "\"Mesh what the strokes paint\" meshes",
                            "a weld tolerance of 0.00105 joins", "\"Layer\" selects another",
                            "\"Names from\" takes names from one of them"});
    }
    CHECK(withEditorHints("--weld 2; --weld 3", {}) == "a weld tolerance of 2; a weld tolerance of 3");
}

} // namespace forefront::test
