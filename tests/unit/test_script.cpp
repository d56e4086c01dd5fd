#include "core/drawing/document/equality.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing_files/script/script_player.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

namespace forefront::script_test {

constexpr std::string_view kPlateCommand =
    R"({"command": "add", "shapes": [{"kind": "rectangle", "nodes": [[0, 0], [4, 2]]}]})"
    "\n";

SourceText scriptSource(std::string_view text) {
    return {text, "plate.jsonl", {}, {}};
}

/// Plays a script, and returns the faults of its reader or of the first command that fails.
Status playScript(std::string_view text, ScriptPlayer &player) {
    const SourceText source = scriptSource(text);
    const Result<Script> script = Script::read(source);
    if (!script) {
        return script.faults();
    }
    for (const ScriptCommand &command : script->commands()) {
        if (Status faults = player.play(command, source); !faults.empty()) {
            return faults;
        }
    }
    return {};
}

/// Returns the document after the plate and further commands.
Document plateAfter(const std::string &commands) {
    ScriptPlayer player;
    const Status faults = playScript(std::string(kPlateCommand) + commands, player);
    REQUIRE_MESSAGE(faults.empty(), toString(faults.front()));
    return player.document();
}

/// Returns the first fault of commands after the plate, as it is printed.
std::string plateRefused(const std::string &commands) {
    ScriptPlayer player;
    const Status faults = playScript(std::string(kPlateCommand) + commands, player);
    REQUIRE_FALSE(faults.empty());
    return toString(faults.front());
}

bool checkContains(const std::string &text, std::string_view part) {
    INFO(text);
    const bool found = text.find(part) != std::string::npos;
    CHECK_MESSAGE(found, part);
    return found;
}

TEST_CASE("Script: the reader names every fault with its place") {
    const auto faultsOf = [](std::string_view text) {
        const Result<Script> script = Script::read(scriptSource(text));
        REQUIRE_FALSE(script.ok());
        return script.faults();
    };
    const Diagnostics faults = faultsOf("{\"command\": \"new\"}\n{\"command\": \"mesh\", \"hsah\": \"1\"}\n"
                                        "{\"command\": \"draw\"}\n{\"file\": \"a\"}\n");
    REQUIRE(faults.size() == 3);
    for (int k = 0; k < 3; ++k) {
        CHECK(faults[k].file == "plate.jsonl");
        CHECK(faults[k].line == k + 2);
    }
    CHECK(faults[0].column == 21);
    checkContains(faults[0].message, "unknown member 'hsah' of the command mesh; expected hash");
    checkContains(faults[1].message, "expected one of \"new\", \"open\", \"add\"");
    checkContains(faults[2].message, "\"command\"");
    CHECK(faultsOf("{\"command\": \"new\"}\n{\"command\": ").front().line == 2);
    CHECK(faultsOf("{\"command\": \"new\"}\n[1]").front().line == 2);
    checkContains(faultsOf("[1]").front().message, "a command");
    checkContains(faultsOf(" \n").front().message, "expected a value, found the end of the file");
}

TEST_CASE("Script: shapes are added and get ids") {
    const Document document = plateAfter(R"({"command": "add", "shapes": [
        {"id": 7, "kind": "circle", "nodes": [[2, 1], [2.5, 1]]},
        {"kind": "rectangle", "nodes": [[9, 0], [10, 2]]}]})");
    REQUIRE(document.shapes.size() == 3);
    CHECK(document.shapes[0]->id == 1);
    CHECK(document.shapes[1]->id == 7);
    CHECK(document.shapes[2]->id == 8);
    CHECK(document.nextId == 9);
    CHECK(outlineOf(*document.shapes[0]).segmentCount() == 4);
}

TEST_CASE("Script: shapes and nodes move") {
    const Document moved = plateAfter(R"({"command": "move", "shapes": [1], "by": [1, 0.5]})");
    CHECK(handlesOf(*moved.shapes[0]).front() == Vec2{1, 0.5});
    const Document pulled = plateAfter(R"({"command": "change", "replace": [{"id": 1, "kind": "polygon", "tag": 1,
        "use": "boundary", "nodes": [[0, 0], [4, 0], [4, 2]]}]}
        {"command": "move", "nodes": ["shape/1/node/1"], "by": [1, 0]})");
    CHECK(pulled.shapes[0]->nodes[1] == Vec2{5, 0});
    CHECK(pulled.shapes[0]->nodes[2] == Vec2{4, 2});
}

TEST_CASE("Script: what is moved takes along what is joined with it, but alone") {
    const std::string beside = R"({"command": "add", "shapes": [{"kind": "polygon", "nodes": [[4, 0], [7, 0], [4, 2]]}]}
        )";
    const std::string move = R"({"command": "move", "nodes": ["shape/2/node/2"], "by": [1, 0])";
    const Document joined = plateAfter(beside + move + "}");
    CHECK(joined.shapes[0]->nodes[1] == Vec2{5, 2});
    CHECK(joined.shapes[1]->nodes == std::vector<Vec2>{{5, 0}, {7, 0}, {5, 2}}); // the plate stays a rectangle
    const Document alone = plateAfter(beside + move + R"(, "alone": true})");
    CHECK(alone.shapes[0]->nodes[1] == Vec2{4, 2});
    CHECK(alone.shapes[1]->nodes == std::vector<Vec2>{{4, 0}, {7, 0}, {5, 2}});
    checkContains(plateRefused(R"({"command": "move", "shapes": [1], "by": [1, 0], "alone": 1})"), "\"alone\"");

    const std::string dimension = R"({"command": "parameter", "name": "w", "expression": "4"}
        {"command": "constrain", "kind": "length", "parts": ["shape/1/segment/0"], "value": "w"}
        {"command": "constrain", "kind": "fixed", "parts": ["shape/1/node/0"]}
        {"command": "parameter", "name": "w", "expression": "5"})";
    const Document wider = plateAfter(beside + dimension);
    CHECK(wider.shapes[0]->nodes[1].x == doctest::Approx(5.0));
    CHECK(wider.shapes[1]->nodes[0].x == wider.shapes[0]->nodes[1].x);
    CHECK(wider.shapes[1]->nodes[2] == wider.shapes[0]->nodes[1]);
}

TEST_CASE("Script: parameters, dimensions and their formulas") {
    const std::string path = R"({"command": "new"}
        {"command": "add", "shapes": [{"kind": "polygon", "use": "boundary", "tag": 1, "nodes": [[0, 0], [4, 0], [4, 2]]}]}
        {"command": "parameter", "name": "r", "expression": "1.5"}
        {"command": "constrain", "kind": "length", "parts": ["shape/1/segment/0"], "value": "2*r"}
    )";
    const auto bottom = [](const Document &document) {
        return distance(document.shapes[0]->nodes[0], document.shapes[0]->nodes[1]);
    };
    const Document document = plateAfter(path);
    REQUIRE(document.constraints.size() == 1);
    CHECK(document.constraints[0]->value == 3.0);
    CHECK(bottom(document) == doctest::Approx(3.0));
    CHECK(document.formulas.size() == 1);
    CHECK(bottom(plateAfter(path + R"({"command": "parameter", "name": "r", "expression": 2.5})")) ==
          doctest::Approx(5.0));
    CHECK(plateAfter(R"({"command": "parameter", "name": "a", "expression": "1"}
        {"command": "parameter", "name": "a", "expression": null})")
              .parameters.empty());
}

TEST_CASE("Script: names of boundary parts and sizes") {
    const Document named = plateAfter(R"({"command": "name", "boundary": 1, "name": "wall"}
        {"command": "name", "segments": ["shape/1/segment/0"], "name": "inlet"})");
    CHECK(named.boundaryNames.at(1) == "wall");
    CHECK(named.boundaryNames.size() == 2);
    CHECK(plateAfter(R"({"command": "name", "shape": 1, "name": "all"})").boundaryNames.at(1) == "all");
    CHECK(plateAfter(R"({"command": "size", "size": 0.25})").spacing.size == 0.25);
    CHECK_FALSE(plateAfter(R"({"command": "size", "size": 0.25} {"command": "size", "size": null})").spacing.size);
    CHECK(plateAfter(R"({"command": "size", "expression": "0.1+x"})").spacing.expression == "0.1+x");
    const Document part = plateAfter(R"({"command": "size", "boundary": 1, "size": 0.125, "growth": 0.5})");
    CHECK_FALSE(sameContent(part, plateAfter("")));
}

TEST_CASE("Script: whole members change, and steps go back and forward") {
    const Document document = plateAfter(R"({"command": "change", "members": {"guides": [{"x": 1.5}]}})");
    REQUIRE(document.guides.size() == 1);
    CHECK(document.guides[0].at == 1.5);
    CHECK(plateAfter(R"({"command": "change", "remove": [1]})").shapes.empty());
    const std::string steps = R"({"command": "size", "size": 0.5} {"command": "size", "size": 0.25}
        {"command": "undo", "steps": 2})";
    CHECK_FALSE(plateAfter(steps).spacing.size);
    CHECK(plateAfter(steps + R"({"command": "redo"})").spacing.size == 0.5);
    CHECK(plateAfter(R"({"command": "new"})").shapes.empty());
    CHECK(plateAfter(R"({"command": "new", "project": {"format": "forefront", "version": 1, "spacing": {"size": 3},
        "shapes": []}})")
              .spacing.size == 3.0);
}

TEST_CASE("Script: faults name the line and the member") {
    checkContains(plateRefused(R"({"command": "move", "shapes": [1, 5], "by": [1, 0]})"),
                  "plate.jsonl:2:35: error: shape 5 not found");
    checkContains(plateRefused(R"({"command": "move", "shapes": [1], "by": [1]})"), "\"by\"");
    checkContains(plateRefused(R"({"command": "move", "by": [1, 0]})"), "\"shapes\"");
    checkContains(plateRefused(R"({"command": "undo", "steps": 9})"), "cannot go back 9 of 1 commands");
    checkContains(plateRefused(R"({"command": "redo"})"), "cannot go forward 1 of 0 commands");
    checkContains(plateRefused(R"({"command": "size"})"), "plate.jsonl:2:1:");
    checkContains(plateRefused(R"({"command": "size", "size": "2*q"})"), "plate.jsonl:2:29: error: \"size\": ");
    checkContains(plateRefused(R"({"command": "size", "size": -1})"), "plate.jsonl:2:1: error: size: ");
    checkContains(plateRefused(R"({"command": "name", "name": "a"})"), "expected one of the members boundary, shape");
    checkContains(plateRefused(R"({"command": "constrain", "kind": "length", "parts": ["shape/1/edge/0"]})"),
                  "plate.jsonl:2:54:");
    checkContains(
        plateRefused(R"({"command": "constrain", "kind": "horizontal", "parts": ["shape/1/segment/0"], "value": 1})"),
        "has no value");
    checkContains(
        plateRefused(R"({"command": "add", "shapes": [{"id": 1, "kind": "circle", "nodes": [[2, 1], [3, 1]]}]})"),
        "[duplicate-id]");
}

TEST_CASE("Script: faults inside shapes and projects have their places in the script") {
    const auto place = [](const std::string &commands) { return plateRefused(commands).substr(0, 18); };
    CHECK(place("{\"command\": \"add\", \"shapes\": [\n{\"kind\": \"circel\", \"nodes\": [[2, 1], [3, 1]]}]}") ==
          "plate.jsonl:3:10: ");
    CHECK(place("{\"command\": \"add\", \"shapes\": [\n {\"kind\": \"circle\", \"nodes\": [[2, 1], [3, 1]],\n  "
                "\"tag\": 0}]}") == "plate.jsonl:4:10: ");
    checkContains(
        plateRefused("{\"command\": \"add\", \"shapes\": [{\"kind\": \"circle\", \"nodes\": [[2, 1], [3, 1]],\n"
                     "\"tga\": 2}]}"),
        "plate.jsonl:3:1: error: unknown member 'tga' [unknown-member]");
    checkContains(plateRefused("{\"command\": \"add\", \"shapes\": [{}]}"), "plate.jsonl:2:");
    CHECK(place("{\"command\": \"change\", \"members\": {\n\"circleTolerance\": 7}}") == "plate.jsonl:3:20: ");
    checkContains(plateRefused(R"({"command": "change", "members": {"tolerance": 7}})"), "unknown member 'tolerance'");
    checkContains(plateRefused(R"({"command": "change", "members": {"tolerance": null}})"),
                  "plate.jsonl:2:35: error: the project has no member 'tolerance' to remove");
    CHECK(place("{\"command\": \"new\", \"project\": {\"format\": \"forefront\", \"version\": 1,\n\"shapes\": 3}}") ==
          "plate.jsonl:3:11: ");
}

TEST_CASE("Script: a refused command leaves the document as it is") {
    ScriptPlayer player;
    CHECK(playScript(kPlateCommand, player).empty());
    const Document before = player.document();
    for (const char *command :
         {R"({"command": "move", "shapes": [4], "by": [1, 0]})", R"({"command": "size", "size": 0})",
          R"({"command": "add", "shapes": [{"kind": "circle"}]})", R"({"command": "undo", "steps": 5})"}) {
        CHECK_FALSE(playScript(command, player).empty());
        CHECK(sameContent(player.document(), before));
        CHECK(player.position() == 1);
    }
}

TEST_CASE("Script: faults of another file keep their place, and a note names the command") {
    const SourceText source = scriptSource("\n{\"command\": \"open\", \"file\": \"a.json\"}");
    const Result<Script> script = Script::read(source);
    REQUIRE(script.ok());
    Diagnostics own = error("cannot-read", "no such file");
    own.front().file = "a.json";
    const Diagnostics placed = placedAt(own, script->commands().front(), source);
    REQUIRE(placed.size() == 2);
    CHECK(toString(placed[0]) == "a.json: error: no such file [cannot-read]");
    CHECK(toString(placed[1]) == "plate.jsonl:2:1: note: the command open failed [failed-command]");
    CHECK(toString(placedAt(error("e", "wrong"), script->commands().front(), source).front()) ==
          "plate.jsonl:2:1: error: open: wrong [e]");
}

} // namespace forefront::script_test
