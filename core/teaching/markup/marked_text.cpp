#include "core/teaching/markup/marked_text.hpp"

#include "core/files/source/source.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <utility>

namespace forefront {

namespace {

/// Splits a text into pieces.
class MarkupReader {
  public:
    MarkupReader(std::string_view text, MarkupKind kind) : text_(text), kind_(kind) {}

    Result<std::vector<TextPiece>> read() {
        while (at_ < text_.size() && faults_.empty()) {
            const std::string_view rest = text_.substr(at_);
            if (rest.size() > 1 && rest[0] == '\\' &&
                std::string_view("$[!\\").find(rest[1]) != std::string_view::npos) {
                words_ += rest[1];
                at_ += 2;
            } else if (rest[0] == '$') {
                formula();
            } else if (rest.starts_with("![") || (rest[0] == '[' && linkAt(at_))) {
                reference(rest[0] == '!');
            } else {
                words_ += rest[0];
                ++at_;
            }
        }
        endWords();
        return faults_.empty() ? Result<std::vector<TextPiece>>(std::move(pieces_))
                               : Result<std::vector<TextPiece>>(std::move(faults_));
    }

  private:
    void fail(std::size_t at, const char *code, std::string message, std::string advice) {
        faults_ = error(code, std::move(message), std::move(advice));
        faults_.front().column = static_cast<int>(at) + 1;
    }

    void endWords() {
        if (!words_.empty()) {
            TextPiece piece;
            piece.text = std::exchange(words_, {});
            pieces_.push_back(std::move(piece));
        }
    }

    void add(TextPiece piece, std::size_t end) {
        endWords();
        piece.at = at_;
        pieces_.push_back(std::move(piece));
        at_ = end;
    }

    void formula() {
        std::size_t close = at_ + 1;
        while (close < text_.size() && text_[close] != '$') {
            close += text_[close] == '\\' ? 2U : 1U;
        }
        if (close >= text_.size()) {
            fail(at_, "bad-formula", "the formula that begins here has no closing $",
                 "close it with $, or write \\$ for a dollar sign");
            return;
        }
        Result<MathNode> math = parseMath(text_.substr(at_ + 1, close - at_ - 1));
        if (!math) {
            faults_ = math.faults();
            faults_.front().column += static_cast<int>(at_) + 1;
            return;
        }
        add({.kind = PieceKind::Formula, .formula = *std::move(math)}, close + 1);
    }

    /// Returns true if a bracket begins a link: its closing one is followed by a round one. Other brackets are words.
    bool linkAt(std::size_t at) const {
        const std::size_t close = text_.find(']', at);
        return close != std::string_view::npos && text_.substr(close + 1).starts_with('(');
    }

    /// Reads [words](target) or ![words](target).
    void reference(bool image) {
        const char *const code = image ? "bad-image" : "bad-link";
        if (kind_ == MarkupKind::Formulas) {
            fail(at_, code,
                 std::string(image ? "an image" : "a link") + " in a text that has room for words and formulas only",
                 "move it into the text of the page; write \\[ for a bracket that is shown");
            return;
        }
        const std::size_t open = at_ + (image ? 2 : 1), close = text_.find(']', open);
        const bool targeted = close != std::string_view::npos && text_.substr(close + 1).starts_with('(');
        const std::size_t end = targeted ? text_.find(')', close) : std::string_view::npos;
        if (end == std::string_view::npos) {
            fail(at_, code, "the brackets that begin here are not closed",
                 image ? "write ![what it shows](file.png), or \\! for an exclamation mark" : "write [words](#3)");
            return;
        }
        TextPiece piece{.kind = image ? PieceKind::Image : PieceKind::Link,
                        .text = std::string(text_.substr(open, close - open)),
                        .target = std::string(text_.substr(close + 2, end - close - 2))};
        if (image ? takeImage(piece) : takeLink(piece)) {
            add(std::move(piece), end + 1);
        }
    }

    bool takeImage(TextPiece &piece) {
        if (piece.text.find_first_not_of(' ') == std::string::npos) {
            fail(at_, "bad-image", "the image has no words for those who cannot see it",
                 "write what it shows into its square brackets");
            return false;
        }
        constexpr std::string_view kWidth = " width=";
        if (const std::size_t width = piece.target.rfind(kWidth); width != std::string::npos) {
            const std::string value = piece.target.substr(width + kWidth.size());
            const bool percent = value.size() > 1 && value.size() < 5 && value.back() == '%' &&
                                 value.find_first_not_of("0123456789") == value.size() - 1;
            const int number = percent ? std::atoi(value.c_str()) : 0;
            if (number < 1 || number > 100) {
                fail(at_, "bad-image", "invalid width " + inQuotes(value) + " of an image",
                     "write it in per cent of the column, from width=1% to width=100%");
                return false;
            }
            piece.share = 0.01 * number;
            piece.sized = true;
            piece.target.resize(width);
        }
        if (piece.target.empty()) {
            fail(at_, "bad-image", "the image has no file", "write its path into the round brackets");
            return false;
        }
        return true;
    }

    bool takeLink(TextPiece &piece) {
        if (piece.text.find_first_not_of(' ') == std::string::npos || piece.target.size() < 2 ||
            piece.target.front() != '#') {
            fail(at_, "bad-link", "unknown target " + inQuotes(piece.target) + " of a link",
                 "write [words](#3) for a page of this lesson, or # and its title; write \\[ for a bracket that is "
                 "shown");
            return false;
        }
        piece.target.erase(0, 1);
        return true;
    }

    std::string_view text_;
    MarkupKind kind_;
    std::size_t at_ = 0;
    std::string words_; ///< read since the last piece
    std::vector<TextPiece> pieces_;
    Diagnostics faults_;
};

} // namespace

Result<std::vector<TextPiece>> parseMarkup(std::string_view text, MarkupKind kind) {
    return MarkupReader(text, kind).read();
}

std::vector<TextPiece> piecesOf(std::string_view text, MarkupKind kind) {
    Result<std::vector<TextPiece>> pieces = parseMarkup(text, kind);
    if (pieces) {
        return *std::move(pieces);
    }
    TextPiece words;
    words.text = text;
    return {words};
}

std::string plainText(std::string_view text) {
    std::string words;
    for (const TextPiece &piece : piecesOf(text)) {
        words += piece.kind == PieceKind::Formula ? plainMath(piece.formula)
                 : piece.kind == PieceKind::Image ? std::string()
                                                  : piece.text;
    }
    return words;
}

} // namespace forefront
