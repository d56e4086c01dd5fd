#include "core/teaching/lesson_page/text_html.hpp"

#include "core/files/text/base64.hpp"
#include "core/teaching/lesson_page/math_html.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>

namespace forefront {

std::string TextHtml::image(const TextPiece &piece) {
    const std::string words = escapedHtml(piece.text);
    const auto known = lesson_.pictures.find(piece.target);
    if (known == lesson_.pictures.end() || !known->second->faults.empty()) {
        return "<span class=\"lost\">Image not available: " + words + "</span>";
    }
    const auto place = std::find(files_.begin(), files_.end(), piece.target);
    const std::string number = std::to_string(place - files_.begin());
    if (place == files_.end()) {
        files_.push_back(piece.target);
    }
    const std::string width =
        piece.sized ? " style=\"width:" + std::to_string(std::lround(100.0 * piece.share)) + "%\"" : std::string();
    return "<img data-picture=\"" + number + "\" alt=\"" + words + "\"" + width + '>';
}

std::string TextHtml::of(std::string_view text, MarkupKind kind) {
    const std::vector<TextPiece> pieces = piecesOf(text, kind);
    std::string html;
    for (const TextPiece &piece : pieces) {
        if (piece.kind == PieceKind::Words) {
            html += escapedHtml(piece.text);
        } else if (piece.kind == PieceKind::Formula) {
            html += mathHtml(piece.formula, pieces.size() == 1 && kind == MarkupKind::All);
        } else if (piece.kind == PieceKind::Image) {
            html += image(piece);
        } else {
            const std::size_t page = pageOfTarget(lesson_, piece.target).value_or(0);
            html += "<a href=\"#" + std::to_string(page + 1) + "\" data-page=\"" + std::to_string(page) + "\">" +
                    escapedHtml(piece.text) + "</a>";
        }
    }
    return html;
}

std::vector<std::string> TextHtml::pictures() const {
    std::vector<std::string> urls;
    for (const std::string &file : files_) {
        const LessonPicture &picture = *lesson_.pictures.at(file);
        const char *const kind = picture.kind == LessonPictureKind::Png ? "png" : "jpeg";
        urls.push_back(std::string("data:image/") + kind + ";base64," + toBase64(picture.bytes));
    }
    return urls;
}

} // namespace forefront
