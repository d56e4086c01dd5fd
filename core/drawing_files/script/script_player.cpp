#include "core/drawing_files/script/script_player.hpp"

#include "core/drawing_files/script/script_edits.hpp"
#include "core/files/json/json_check.hpp"

#include <string>
#include <utility>

namespace forefront {

namespace {

Result<std::string> readText(const ScriptCommand &command, std::string_view member, const SourceText &source,
                             bool needed) {
    JsonCheck check(source);
    const std::string of = "the command " + std::string(wordOf(command.word));
    const auto value = needed ? check.member(command.value, member, of) : command.value.find(member);
    std::string text = value ? check.string(*value, inQuotes(member)) : std::string();
    if (value && text.empty() && check.faults().empty()) {
        check.fault(*value, "bad-value", inQuotes(member) + " is empty");
    }
    if (!check.faults().empty()) {
        return check.faults();
    }
    return text;
}

} // namespace

Diagnostics placedAt(Diagnostics faults, const ScriptCommand &command, const SourceText &source) {
    const TextPlace place = placeOf(source.text, command.value.offset());
    bool elsewhere = false;
    for (Diagnostic &fault : faults) {
        if (fault.file.empty()) {
            fault.file = source.name;
            fault.line = place.line;
            fault.column = place.column;
            fault.message = std::string(wordOf(command.word)) + ": " + fault.message;
        }
        elsewhere = elsewhere || fault.file != source.name;
    }
    if (elsewhere && hasErrors(faults)) {
        Diagnostic note;
        note.severity = Severity::Note;
        note.code = "failed-command";
        note.message = "the command " + std::string(wordOf(command.word)) + " failed";
        note.file = source.name;
        note.line = place.line;
        note.column = place.column;
        faults.push_back(std::move(note));
    }
    return faults;
}

bool editsDocument(ScriptWord word) {
    switch (word) {
    case ScriptWord::Open:
    case ScriptWord::Mesh:
    case ScriptWord::Check:
    case ScriptWord::Export:
    case ScriptWord::Save:
        return false;
    default:
        return true;
    }
}

Status ScriptPlayer::play(const ScriptCommand &command, const SourceText &source) {
    if (command.word == ScriptWord::Undo || command.word == ScriptWord::Redo) {
        return walk(command, source);
    }
    Result<Document> next = editedDocument(document(), command, source);
    if (!next) {
        return placedAt(next.faults(), command, source);
    }
    if (command.word == ScriptWord::New) {
        load(*std::move(next));
    } else {
        history_.commit(std::string(wordOf(command.word)), *std::move(next));
    }
    return {};
}

Status ScriptPlayer::walk(const ScriptCommand &command, const SourceText &source) {
    JsonCheck check(source);
    const auto steps = command.value.find("steps");
    const std::int64_t count = steps ? check.integer(*steps, 1, 1'000'000'000, "\"steps\"") : 1;
    if (!check.faults().empty()) {
        return check.faults();
    }
    const bool back = command.word == ScriptWord::Undo;
    const std::size_t room = back ? history_.position() : history_.size() - 1 - history_.position();
    if (static_cast<std::size_t>(count) > room) {
        return placedAt(error("nothing-to-undo", "cannot go " + std::string(back ? "back " : "forward ") +
                                                     std::to_string(count) + " of " + std::to_string(room) +
                                                     " commands"),
                        command, source);
    }
    const auto shift = static_cast<std::size_t>(count);
    history_.goTo(back ? history_.position() - shift : history_.position() + shift);
    return {};
}

Result<std::string> requiredText(const ScriptCommand &command, std::string_view member, const SourceText &source) {
    return readText(command, member, source, true);
}

Result<std::string> optionalText(const ScriptCommand &command, std::string_view member, const SourceText &source) {
    return readText(command, member, source, false);
}

} // namespace forefront
