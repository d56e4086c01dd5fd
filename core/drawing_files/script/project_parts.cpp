#include "core/drawing_files/script/project_parts.hpp"

#include "core/drawing_files/project/project.hpp"

#include <algorithm>
#include <charconv>

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

ProjectParts ProjectParts::of(const Document &document) {
    ProjectParts parts;
    const std::string text = projectText(document);
    const Result<JsonDocument> json = JsonDocument::parse({text, {}, {}, {}});
    const JsonValue root = json->root();
    for (auto member = root.begin(); member != root.end(); ++member) {
        if (member.key() != "shapes") {
            parts.members.emplace_back(member.key(), textOf(text, *member));
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
        std::find_if(members.begin(), members.end(), [&](const auto &member) { return member.first == name; });
    return found != members.end() ? std::string_view(found->second) : std::string_view();
}

void ProjectParts::set(std::string_view name, std::string text) {
    const auto found =
        std::find_if(members.begin(), members.end(), [&](const auto &member) { return member.first == name; });
    if (text.empty() && found != members.end()) {
        members.erase(found);
    } else if (!text.empty() && found != members.end()) {
        found->second = std::move(text);
    } else if (!text.empty()) {
        members.emplace_back(name, std::move(text));
    }
}

Result<Document> ProjectParts::read() const {
    std::uint32_t next = std::max(1U, numberOf(member("nextId")));
    for (const ShapeText &shape : shapes) {
        next = std::max(next, shape.id + 1);
    }
    std::string text = "{";
    for (const auto &[name, content] : members) {
        text += (text.size() == 1 ? "" : ",\n") + jsonString(name) + ": " + content;
    }
    text += ",\n\"shapes\": [";
    for (const ShapeText &shape : shapes) {
        text += &shape == &shapes.front() ? "" : ",\n";
        text += shape.id != 0 ? shape.text : "{\"id\": " + std::to_string(next++) + ", " + shape.text.substr(1);
    }
    Result<Document> document = parseProject(text + "]}", {});
    if (document) {
        return document;
    }
    Diagnostics faults = document.faults();
    for (Diagnostic &fault : faults) {
        fault.line = fault.column = 0; // of a text that nobody has seen
    }
    return faults;
}

} // namespace forefront
