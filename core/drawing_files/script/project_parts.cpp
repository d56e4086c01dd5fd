#include "core/drawing_files/script/project_parts.hpp"

#include "core/drawing_files/project/project.hpp"

#include <algorithm>
#include <charconv>
#include <tuple>
#include <utility>

namespace forefront {

namespace {

/// Returns the end of the string that begins at a quote.
std::size_t endOfString(std::string_view text, std::size_t at) {
    for (++at; at < text.size() && text[at] != '"'; ++at) {
        at += text[at] == '\\' ? 1 : 0;
    }
    return std::min(at + 1, text.size());
}

std::uint32_t numberOf(std::string_view text) {
    std::uint32_t value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

/// The text of a project, put together from pieces of a script and others.
class PiecedProject {
  public:
    explicit PiecedProject(const SourceText &script) : script_(script) {}

    /// Appends a piece; `offset`: in the script, absent if it is not from there.
    void add(std::string_view piece, std::optional<std::size_t> offset = {}) {
        if (offset) {
            pieces_.push_back({text_.size(), piece.size(), *offset});
        }
        text_ += piece;
    }

    Result<Document> read() const {
        ImportNotes notes;
        SourceText source{text_, script_.name, script_.path, {}};
        source.notes = &notes;
        Result<Document> document = readProjectText(source);
        Diagnostics faults = document ? unknownMembers(notes) : document.faults();
        if (faults.empty()) {
            return document;
        }
        for (Diagnostic &fault : faults) {
            moveToScript(fault);
        }
        return faults;
    }

  private:
    struct Piece {
        std::size_t begin, size, offset;
    };

    /// A script is refused for members that a project file may have from a newer program.
    static Diagnostics unknownMembers(const ImportNotes &notes) {
        Diagnostics faults;
        for (const ImportNote &note : notes.entries()) {
            Diagnostic fault;
            fault.code = "unknown-member";
            fault.message = note.message.substr(0, note.message.rfind(" is ignored"));
            fault.line = note.line;
            fault.column = note.column;
            faults.push_back(std::move(fault));
        }
        return faults;
    }

    /// Replaces the place of a fault in the text by that in the script; without one it gets no place.
    void moveToScript(Diagnostic &fault) const {
        const auto isBefore = [&](std::size_t at) {
            const TextPlace place = placeOf(text_, at);
            return std::tie(place.line, place.column) <= std::tie(fault.line, fault.column);
        };
        const auto after = std::partition_point(pieces_.begin(), pieces_.end(),
                                                [&](const Piece &piece) { return isBefore(piece.begin); });
        const int line = std::exchange(fault.line, 0), column = std::exchange(fault.column, 0);
        fault.file.clear();
        if (after == pieces_.begin()) {
            return;
        }
        const Piece &piece = *std::prev(after);
        const TextPlace begin = placeOf(text_, piece.begin), end = placeOf(text_, piece.begin + piece.size),
                        there = placeOf(script_.text, piece.offset);
        if (std::tie(line, column) < std::tie(end.line, end.column)) {
            fault.file = script_.name;
            fault.line = there.line + line - begin.line;
            fault.column = line == begin.line ? there.column + column - begin.column : column;
        }
    }

    const SourceText &script_;
    std::string text_;
    std::vector<Piece> pieces_;
};

} // namespace

std::string_view textOf(std::string_view text, const JsonValue &value) {
    const std::size_t begin = value.offset();
    std::size_t at = begin;
    if (value.is(JsonKind::String)) {
        at = endOfString(text, begin);
    } else if (value.is(JsonKind::Array) || value.is(JsonKind::Object)) {
        int depth = 0;
        do {
            const char c = text[at];
            depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
            at = c == '"' ? endOfString(text, at) : at + 1;
        } while (depth > 0 && at < text.size());
    } else {
        at = std::min(text.find_first_of(",]} \t\r\n", begin), text.size());
    }
    return text.substr(begin, at - begin);
}

Result<Document> readProjectValue(const JsonValue &project, const SourceText &script) {
    PiecedProject text(script);
    text.add(textOf(script.text, project), project.offset());
    return text.read();
}

ProjectParts ProjectParts::of(const Document &document) {
    ProjectParts parts;
    const std::string text = projectText(document);
    const Result<JsonDocument> json = JsonDocument::parse({text, {}, {}, {}});
    const JsonValue root = json->root();
    for (auto member = root.begin(); member != root.end(); ++member) {
        if (member.key() != "shapes") {
            parts.members.push_back({member.key(), std::string(textOf(text, *member))});
            continue;
        }
        for (const JsonValue shape : *member) {
            parts.shapes.push_back({static_cast<std::uint32_t>(shape.find("id")->integer().value_or(0)),
                                    std::string(textOf(text, shape))});
        }
    }
    return parts;
}

std::string_view ProjectParts::member(std::string_view name) const {
    const auto found =
        std::find_if(members.begin(), members.end(), [&](const auto &member) { return member.name == name; });
    return found != members.end() ? std::string_view(found->text) : std::string_view();
}

void ProjectParts::set(MemberText given) {
    const auto found =
        std::find_if(members.begin(), members.end(), [&](const auto &member) { return member.name == given.name; });
    if (found == members.end()) {
        if (!given.text.empty()) {
            members.push_back(std::move(given));
        }
    } else if (given.text.empty()) {
        members.erase(found);
    } else {
        *found = std::move(given);
    }
}

Result<Document> ProjectParts::read(const SourceText &script) const {
    std::uint32_t next = std::max(1U, numberOf(member("nextId")));
    for (const ShapeText &shape : shapes) {
        next = std::max(next, shape.id + 1);
    }
    PiecedProject project(script);
    project.add("{");
    for (const MemberText &member : members) {
        project.add(jsonString(member.name) + ": ");
        project.add(member.text, member.offset);
        project.add(",\n");
    }
    project.add("\"shapes\": [");
    for (const ShapeText &shape : shapes) {
        project.add(&shape == &shapes.front() ? "" : ",\n");
        if (shape.id != 0) {
            project.add(shape.text, shape.offset);
            continue;
        }
        const bool empty = shape.text.find_first_not_of(" \t\r\n", 1) == shape.text.size() - 1;
        project.add("{\"id\": " + std::to_string(next++) + (empty ? "" : ", "));
        project.add(std::string_view(shape.text).substr(1),
                    shape.offset ? std::optional(*shape.offset + 1) : std::nullopt);
    }
    project.add("]}");
    return project.read();
}

} // namespace forefront
