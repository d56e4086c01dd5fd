#include "core/teaching/lesson/markup_check.hpp"

#include "core/files/source/text_place.hpp"

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <utility>

namespace forefront {

namespace {

/// Returns where the byte of a decoded string of JSON is in the text of the file.
std::size_t offsetWithin(std::string_view text, const JsonValue &string, std::size_t byte) {
    std::size_t at = string.offset() + 1, decoded = 0;
    while (decoded < byte && at < text.size() && text[at] != '"') {
        if (text[at] != '\\') {
            ++at;
            ++decoded;
        } else if (text.substr(at + 1).starts_with('u')) {
            const std::string_view digits = text.substr(at + 2, 4);
            unsigned code = 0;
            std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
            // Each half of a surrogate pair counts as two of its four bytes.
            decoded += code < 0x80 ? 1 : code < 0x800 || (code >= 0xd800 && code < 0xe000) ? 2 : 3;
            at += 6;
        } else {
            at += 2;
            ++decoded;
        }
    }
    return at;
}

} // namespace

bool isWithinFolder(const std::filesystem::path &path) {
    return path.is_relative() && std::find(path.begin(), path.end(), "..") == path.end();
}

void MarkupCheck::page(const JsonValue &page, const RandomNumbers &numbers) {
    ++page_;
    numbers_ = &numbers;
    if (const auto text = page.find("text"); text && text->is(JsonKind::Array)) {
        for (const JsonValue paragraph : *text) {
            this->text(paragraph, MarkupKind::All);
        }
    } else if (text) {
        this->text(*text, MarkupKind::All);
    }
    if (const auto question = page.find("question"); question && question->is(JsonKind::Object)) {
        this->question(*question);
    }
}

void MarkupCheck::question(const JsonValue &question) {
    for (const std::string_view name : {"text", "hint", "why"}) {
        member(question, name);
    }
    list(question, "choices", MarkupKind::Formulas);
    list(question, "mistakes", MarkupKind::All);
}

/// Checks the texts of a list of choices or mistakes.
void MarkupCheck::list(const JsonValue &object, std::string_view member, MarkupKind textKind) {
    const auto items = object.find(member);
    if (!items || !items->is(JsonKind::Array)) {
        return;
    }
    for (const JsonValue item : *items) {
        this->member(item, "text", textKind);
        this->member(item, "hint");
    }
}

void MarkupCheck::member(const JsonValue &object, std::string_view name, MarkupKind kind) {
    if (const auto value = object.is(JsonKind::Object) ? object.find(name) : std::nullopt) {
        text(*value, kind);
    }
}

void MarkupCheck::fault(const JsonValue &value, std::size_t at, const std::string &code, const std::string &message,
                        const std::string &advice, std::size_t page) {
    if (faults_.size() < kMaxListedFaults) {
        faults_.push_back(faultAt(source_, offsetWithin(source_.text, value, at), code,
                                  "page " + std::to_string(page) + ": " + message, advice));
    }
}

void MarkupCheck::text(const JsonValue &value, MarkupKind kind) {
    if (!value.is(JsonKind::String)) {
        return; // reported by the reader
    }
    const Result<std::vector<TextPiece>> pieces = parseMarkup(value.string(), kind);
    if (!pieces) {
        const Diagnostic &found = pieces.faults().front();
        fault(value, static_cast<std::size_t>(found.column - 1), found.code, found.message, found.advice, page_);
        return;
    }
    for (const TextPiece &piece : *pieces) {
        if (piece.kind == PieceKind::Link) {
            links_.push_back({value, piece.at, withNumbers(piece.target, *numbers_), page_});
        } else if (piece.kind == PieceKind::Image) {
            image(value, piece);
        }
    }
}

void MarkupCheck::image(const JsonValue &value, const TextPiece &piece) {
    const std::string file = withNumbers(piece.target, *numbers_);
    if (!isWithinFolder(file)) {
        fault(value, piece.at, "bad-image", "the image " + inQuotes(file) + " is outside the lesson's folder",
              "move it into that folder, and give its path relative to the lesson", page_);
        return;
    }
    if (file.find('{') != std::string::npos) {
        fault(value, piece.at, "bad-image", "the file of an image cannot depend on a value of the run",
              "write its path, perhaps with a random number", page_);
        return;
    }
    if (!readPicture_ || pictures_.contains(file)) {
        return;
    }
    LessonPicture picture = readPicture_(file);
    bytes_ += picture.bytes.size();
    if (bytes_ > kMaxLessonPictures) {
        picture.bytes.clear();
        picture.faults = error("large-picture", "the images of the lesson are larger than 16 MiB in all",
                               "make them smaller in another program");
    }
    const TextPlace place = placeOf(source_.text, offsetWithin(source_.text, value, piece.at));
    picture.line = place.line;
    picture.column = place.column;
    picture.page = page_;
    pictures_.emplace(file, std::make_shared<const LessonPicture>(std::move(picture)));
}

void MarkupCheck::links(const Lesson &lesson) {
    for (const Link &link : links_) {
        if (!pageOfTarget(lesson, link.target)) {
            fault(link.text, link.at, "bad-link",
                  "the link leads to page " + inQuotes(link.target) + ", which does not exist",
                  "write # and a number up to " + std::to_string(lesson.pages.size()) +
                      ", or # and the title of a page",
                  link.page);
        }
    }
}

} // namespace forefront
