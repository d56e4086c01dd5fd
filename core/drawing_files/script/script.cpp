#include "core/drawing_files/script/script.hpp"

#include "core/files/json/json_check.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

namespace forefront {

namespace {

/// Returns the members of a command besides "command".
std::span<const std::string_view> membersOf(ScriptWord word) {
    static constexpr std::string_view kNew[] = {"project"};
    static constexpr std::string_view kOpen[] = {"file", "projection", "layer", "nameProperty", "sizeProperty", "weld"};
    static constexpr std::string_view kSave[] = {"file"};
    static constexpr std::string_view kAdd[] = {"shapes"};
    static constexpr std::string_view kMove[] = {"shapes", "nodes", "by", "alone"};
    static constexpr std::string_view kConstrain[] = {"kind", "parts", "value"};
    static constexpr std::string_view kName[] = {"name", "boundary", "shape", "segments", "regionMarker"};
    static constexpr std::string_view kSize[] = {"size", "expression", "boundary", "growth"};
    static constexpr std::string_view kParameter[] = {"name", "expression"};
    static constexpr std::string_view kChange[] = {"replace", "remove", "members"};
    static constexpr std::string_view kSteps[] = {"steps"};
    static constexpr std::string_view kMesh[] = {"hash"};
    static constexpr std::string_view kExport[] = {"file", "format", "open", "elevation"};
    switch (word) {
    case ScriptWord::New:
        return kNew;
    case ScriptWord::Open:
        return kOpen;
    case ScriptWord::Save:
        return kSave;
    case ScriptWord::Add:
        return kAdd;
    case ScriptWord::Move:
        return kMove;
    case ScriptWord::Constrain:
        return kConstrain;
    case ScriptWord::Name:
        return kName;
    case ScriptWord::Size:
        return kSize;
    case ScriptWord::Parameter:
        return kParameter;
    case ScriptWord::Change:
        return kChange;
    case ScriptWord::Undo:
    case ScriptWord::Redo:
        return kSteps;
    case ScriptWord::Mesh:
        return kMesh;
    case ScriptWord::Export:
        return kExport;
    case ScriptWord::Check:
        break;
    }
    return {};
}

/// Records a fault for each member that the command does not have.
void checkMembers(const JsonValue &command, ScriptWord word, JsonCheck &check) {
    const std::span<const std::string_view> known = membersOf(word);
    for (auto member = command.begin(); member != command.end(); ++member) {
        const std::string key = member.key();
        if (key == "command" || std::find(known.begin(), known.end(), key) != known.end()) {
            continue;
        }
        std::string list;
        for (const std::string_view name : known) {
            list += (list.empty() ? "" : ", ") + std::string(name);
        }
        check.fault(member.keyValue(), "unknown-member",
                    "unknown member " + inQuotes(key) + " of the command " + std::string(wordOf(word)) + "; expected " +
                        (list.empty() ? "none" : list));
    }
}

} // namespace

Result<Script> Script::read(const SourceText &source) {
    Result<JsonDocument> json = JsonDocument::parseSequence(source);
    if (!json) {
        return json.faults();
    }
    Script script;
    script.json_ = std::make_shared<const JsonDocument>(*std::move(json));
    JsonCheck check(source);
    for (const JsonValue item : script.json_->root()) {
        if (check.full()) {
            break;
        }
        if (!check.expect(item, JsonKind::Object, "a command")) {
            continue;
        }
        check.refuseRepeats(item);
        if (const auto word = check.member(item, "command", "the line")) {
            const std::size_t before = check.faults().size();
            const auto chosen = static_cast<ScriptWord>(check.choice(*word, wordsOf<ScriptWord>(), "the command"));
            if (check.faults().size() == before) {
                checkMembers(item, chosen, check);
                script.commands_.push_back({chosen, item});
            }
        }
    }
    if (!check.faults().empty()) {
        return check.faults();
    }
    return script;
}

} // namespace forefront
