#include "core/files/nastran/nastran_cards.hpp"

#include "core/engine/base/letter_case.hpp"

#include <algorithm>

namespace forefront {

namespace {

constexpr std::size_t kNameWidth = 8;

bool isBlank(char c) {
    return static_cast<unsigned char>(c) <= ' ';
}

} // namespace

NastranCards::NastranCards(std::string_view text) : text_(text) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = upperCase(std::string(text.substr(at, std::min<std::size_t>(end - at, 20))));
        const std::size_t word = line.find_first_not_of(' ');
        if (word != std::string::npos && line.compare(word, 5, "BEGIN") == 0) {
            at_ = std::min(end + 1, text.size());
            return;
        }
        at = end + 1;
    }
}

/// Finds the next line that is not blank, without its comment.
bool NastranCards::nextLine(Line &line) {
    while (at_ < text_.size()) {
        const std::size_t begin = at_;
        const std::size_t newline = std::min(text_.find('\n', begin), text_.size());
        at_ = std::min(newline + 1, text_.size());
        const std::string_view content = text_.substr(begin, newline - begin);
        std::size_t end = std::min(content.find('$'), content.size());
        while (end > 0 && isBlank(content[end - 1])) {
            --end;
        }
        if (end > 0) {
            line = {begin, begin + end};
            return true;
        }
    }
    return false;
}

bool NastranCards::continues(const Line &line) const {
    const char first = text_[line.begin];
    return first == '+' || first == '*' || first == ',' || isBlank(first);
}

/// Returns the end of the name of a card: a comma or the end of its field.
std::size_t NastranCards::nameEnd(const Line &line) const {
    const std::size_t comma = text_.substr(line.begin, line.end - line.begin).find(',');
    return comma != std::string_view::npos ? line.begin + comma : std::min(line.begin + kNameWidth, line.end);
}

/// Adds the fields of a line, as many as it can have.
void NastranCards::addFields(const Line &line, NastranCard &card) const {
    const std::string_view content = text_.substr(line.begin, line.end - line.begin);
    const bool isFree = content.find(',') != std::string_view::npos;
    if (!isFree && content.find('\t') != std::string_view::npos) {
        card.fault = "a line in fields of fixed width has tabs";
        card.advice = "replace them by blanks, for example with expand";
        return;
    }
    const std::size_t named = nameEnd(line);
    const bool isLarge = text_.substr(line.begin, named - line.begin).find('*') != std::string_view::npos;
    const std::size_t fields = isLarge ? 4 : 8, width = isLarge ? 16 : 8;
    std::size_t at = isFree ? named + 1 : named;
    for (std::size_t k = 0; k < fields; ++k) {
        at = std::min(at, line.end);
        std::size_t begin = at;
        std::size_t end = std::min(isFree ? text_.substr(0, line.end).find(',', at) : at + width, line.end);
        at = isFree ? end + 1 : end;
        while (begin < end && isBlank(text_[begin])) {
            ++begin;
        }
        while (begin < end && isBlank(text_[end - 1])) {
            --end;
        }
        card.fields_.emplace_back(begin, end);
    }
}

bool NastranCards::next(NastranCard &card) {
    card = NastranCard();
    Line line;
    if (hasPending_) {
        line = pending_;
        hasPending_ = false;
    } else if (!nextLine(line)) {
        return false;
    }
    card.offset = line.begin;
    std::string name(text_.substr(line.begin, nameEnd(line) - line.begin));
    std::erase_if(name, [](char c) { return isBlank(c) || c == '*'; });
    card.name = upperCase(name);
    if (card.name == "ENDDATA") {
        return false;
    }
    if (continues(line)) {
        card.fault = "a continuation line does not follow a card";
        return true;
    }
    addFields(line, card);
    while (nextLine(line)) {
        if (!continues(line)) {
            pending_ = line;
            hasPending_ = true;
            break;
        }
        addFields(line, card);
    }
    return true;
}

} // namespace forefront
