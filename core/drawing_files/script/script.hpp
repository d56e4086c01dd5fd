#pragma once

#include "core/engine/base/enum_words.hpp"
#include "core/engine/base/result.hpp"
#include "core/files/json/json.hpp"
#include "core/files/source/source.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace forefront {

/// The commands of a script; `forefront run --help` describes them and their members.
enum class ScriptWord : std::uint8_t {
    New,
    Open,
    Add,
    Move,
    Constrain,
    Name,
    Size,
    Parameter,
    Change,
    Undo,
    Redo,
    Mesh,
    Check,
    Export,
    Save
};

template <>
struct EnumWords<ScriptWord> {
    static constexpr auto kLast = ScriptWord::Save;
    static constexpr std::array<std::string_view, 15> kList = {"new",  "open", "add",       "move",   "constrain",
                                                               "name", "size", "parameter", "change", "undo",
                                                               "redo", "mesh", "check",     "export", "save"};
};

/// A command of a script: a JSON object with its word as the member "command".
struct ScriptCommand {
    ScriptWord word = ScriptWord::New;
    JsonValue value;
};

/// A parsed script: JSON objects, one command each, usually one a line. The text must outlive it.
class Script {
  public:
    /// Parses a script and checks that every command and member is known. Faults, each with line and column:
    /// json-syntax, bad-value, unknown-member and those of JsonDocument::parse().
    static Result<Script> read(const SourceText &source);

    const std::vector<ScriptCommand> &commands() const { return commands_; }

  private:
    std::shared_ptr<const JsonDocument> json_;
    std::vector<ScriptCommand> commands_;
};

} // namespace forefront
