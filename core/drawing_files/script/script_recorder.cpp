#include "core/drawing_files/script/script_recorder.hpp"

#include "core/drawing/document/equality.hpp"
#include "core/drawing_files/script/script_edits.hpp"
#include "core/drawing_files/script/step_lines.hpp"
#include "core/engine/base/hash.hpp"

#include <utility>

namespace forefront {

ScriptRecorder::ScriptRecorder(std::shared_ptr<const Document> start) {
    load(std::move(start));
}

void ScriptRecorder::load(std::shared_ptr<const Document> document) {
    history_ = History(*document, "Open");
    write(newLine(*document));
    entries_ = {std::move(document)};
}

void ScriptRecorder::record(std::shared_ptr<const Document> document) {
    if (walk(document.get()) || sameContent(history_.document(), *document)) {
        return;
    }
    for (const std::string &line : linesBetween(history_.document(), *document)) {
        if (accept(line, *document)) {
            entries_.resize(history_.position());
            entries_.push_back(std::move(document));
            return;
        }
    }
    load(std::move(document)); // what no command can make, such as a spacing that the project file alone holds
}

/// Returns true if a document was current before in this history, and goes there.
bool ScriptRecorder::walk(const Document *document) {
    const std::size_t now = history_.position();
    for (std::size_t k = entries_.size(); k-- > 0;) {
        if (entries_[k].get() != document) {
            continue;
        }
        if (k != now) {
            const std::size_t steps = k < now ? now - k : k - now;
            write(std::string("{\"command\": \"") + (k < now ? "undo" : "redo") + '"' +
                  (steps > 1 ? ", \"steps\": " + std::to_string(steps) : "") + "}");
            history_.goTo(k);
        }
        return true;
    }
    return false;
}

/// Writes a line if it leads to the document.
bool ScriptRecorder::accept(const std::string &line, const Document &document) {
    const SourceText source{line, {}, {}, {}};
    const Result<Script> script = Script::read(source);
    if (!script) {
        return false;
    }
    Result<Document> next = editedDocument(history_.document(), script->commands().front(), source);
    if (!next || !sameContent(*next, document) || next->nextId != document.nextId) {
        return false;
    }
    history_.commit("step", *std::move(next));
    write(line);
    return true;
}

void ScriptRecorder::recordMesh(std::uint64_t hash) {
    if (meshed_) {
        return;
    }
    write("{\"command\": \"mesh\", \"hash\": \"" + toHex(hash) + "\"}");
    meshed_ = true;
}

void ScriptRecorder::recordExport(const std::filesystem::path &file, const std::string &format, std::uint64_t hash,
                                  const std::vector<std::string> &open, const std::string &elevation) {
    recordMesh(hash);
    std::string names;
    for (const std::string &name : open) {
        names += (names.empty() ? "" : ", ") + jsonString(name);
    }
    write("{\"command\": \"export\", \"file\": " + jsonString(file.string()) +
          (format.empty() ? "" : ", \"format\": " + jsonString(format)) +
          (names.empty() ? "" : ", \"open\": [" + names + "]") +
          (elevation.empty() ? "" : ", \"elevation\": " + jsonString(elevation)) + "}");
    meshed_ = true;
}

void ScriptRecorder::recordSave(const std::filesystem::path &file) {
    const bool meshed = meshed_;
    write("{\"command\": \"save\", \"file\": " + jsonString(file.string()) + "}");
    meshed_ = meshed;
}

void ScriptRecorder::write(const std::string &line) {
    text_ += line + '\n';
    ++commands_;
    meshed_ = false;
}

} // namespace forefront
