#pragma once

#include "core/drawing_files/script/script_player.hpp"

#include <doctest/doctest.h>

#include <string>

namespace forefront::test {

/// Returns the document that the commands of a recorded script make; those that mesh and export are left out.
inline Document replayedScript(const std::string &text) {
    const SourceText source{text, "day.jsonl", {}, {}};
    const Result<Script> script = Script::read(source);
    REQUIRE(script.ok());
    ScriptPlayer player;
    for (const ScriptCommand &command : script->commands()) {
        if (editsDocument(command.word)) {
            REQUIRE(player.play(command, source).empty());
        }
    }
    return player.document();
}

} // namespace forefront::test
