#include "ui/widgets/rich_text.hpp"

#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/math_view.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace forefront::ui {

namespace {

constexpr double kMaxImageHeight = 360.0; ///< design pixels

float widthOf(std::string_view text) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

/// Returns the number of bytes of a word that fit into a width, at least one character.
std::size_t fitting(std::string_view word, float width) {
    std::size_t end = 0;
    for (std::size_t next = 0; next < word.size(); end = next) {
        do {
            ++next;
        } while (next < word.size() && (static_cast<unsigned char>(word[next]) & 0xc0U) == 0x80U);
        if (end > 0 && widthOf(word.substr(0, next)) > width) {
            break;
        }
    }
    return end;
}

} // namespace

RichText::RichText(const WidgetContext &context, std::string_view text, float width, MarkupKind kind,
                   const PictureSource &pictures)
    : context_(context), width_(std::max(width, 1.0F)), line_(ImGui::GetTextLineHeight()), blank_(widthOf(" ")),
      ascent_(imgui::baselineOf(*context.fonts.body)) {
    const std::vector<TextPiece> pieces = piecesOf(text, kind);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        if (pieces[k].kind == PieceKind::Formula) {
            addFormula(pieces[k].formula, k, pieces.size() == 1 && kind == MarkupKind::All);
        } else if (pieces[k].kind == PieceKind::Image) {
            addImage(pieces[k], k, pictures);
        } else {
            addWords(pieces[k], k);
        }
    }
    addUnit();
    endLine();
}

RichText::Item RichText::wordItem(std::string text) const {
    Item item;
    item.width = widthOf(text);
    item.ascent = ascent_;
    item.descent = line_ - ascent_;
    item.text = std::move(text);
    return item;
}

/// Adds the words of a piece; those without a blank between them and the piece before stay with it.
void RichText::addWords(const TextPiece &piece, std::size_t number) {
    const std::string_view text = piece.text;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] == ' ' || text[at] == '\n') {
            addUnit();
            blankBefore_ = true;
            if (text[at] == '\n') {
                endLine();
            }
            ++at;
            continue;
        }
        const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
        std::string_view word = text.substr(at, end - at);
        while (!word.empty()) {
            const std::size_t count = widthOf(word) > width_ ? fitting(word, width_) : word.size();
            if (count < word.size()) {
                addUnit(); // a word longer than a line is split
            }
            Item item = wordItem(std::string(word.substr(0, count)));
            item.kind = piece.kind;
            item.target = piece.target;
            item.piece = number;
            item.blank = std::exchange(blankBefore_, false);
            unit_.push_back(std::move(item));
            word.remove_prefix(count);
        }
        at = end;
    }
}

void RichText::addFormula(const MathNode &formula, std::size_t number, bool display) {
    const auto itemOf = [&](const MathNode &node) {
        Item item;
        item.kind = PieceKind::Formula;
        item.formula = setMath(context_, node, display);
        item.width = static_cast<float>(item.formula.extent.width);
        // Ink above the letters of the text pushes lines apart.
        const float gap = context_.px(1.5);
        item.ascent = std::max(ascent_, static_cast<float>(item.formula.extent.ascent) + gap);
        item.descent = std::max(line_ - ascent_, static_cast<float>(item.formula.extent.descent) + gap);
        item.piece = number;
        return item;
    };
    Item whole = itemOf(formula);
    whole.blank = std::exchange(blankBefore_, false);
    if (whole.width <= width_) {
        whole.x = display ? 0.5F * (width_ - whole.width) : 0.0F;
        unit_.push_back(std::move(whole));
        return;
    }
    for (const MathNode &piece : brokenMath(formula)) {
        addUnit();
        Item item = itemOf(piece);
        item.blank = true; // after a relation or an operator, which have as much room on their other side
        unit_.push_back(std::move(item));
    }
}

/// Adds an image on lines of its own.
void RichText::addImage(const TextPiece &piece, std::size_t number, const PictureSource &pictures) {
    addUnit();
    endLine();
    Item item;
    item.kind = PieceKind::Image;
    item.piece = number;
    item.picture = pictures ? pictures(piece.target) : TextPicture{.note = "no image here"};
    item.text = piece.text;
    const float pad = context_.px(3), columns = item.picture.columns, rows = item.picture.rows;
    if (!item.picture.note.empty() || columns < 1.0F || rows < 1.0F) {
        item.width = width_;
        item.text = wrapped(piece.text, width_ - context_.px(16)) + '\n' +
                    wrapped("Image not available: " + item.picture.note, width_ - context_.px(16));
        item.ascent = ImGui::CalcTextSize(item.text.c_str()).y + context_.px(12);
    } else {
        item.width = piece.sized ? width_ * static_cast<float>(piece.share)
                                 : std::min(width_, context_.px(static_cast<double>(columns)));
        item.width = std::min(item.width, context_.px(kMaxImageHeight) * columns / rows);
        item.ascent = item.width * rows / columns;
    }
    item.x = std::round(0.5F * (width_ - item.width));
    item.ascent += pad;
    item.descent = pad;
    place(std::move(item));
    endLine();
}

/// Places what no line may end within, on the next line if it does not fit.
void RichText::addUnit() {
    float room = 0.0F;
    for (const Item &item : unit_) {
        room += item.width;
    }
    const bool blank = !unit_.empty() && unit_.front().blank && used_ > 0.0F;
    if (used_ > 0.0F && used_ + (blank ? blank_ : 0.0F) + room > width_ && !unit_.empty()) {
        endLine();
    }
    for (Item &item : std::exchange(unit_, {})) {
        place(std::move(item));
    }
}

void RichText::place(Item item) {
    const bool first = items_.size() == lineBegin_;
    const bool blank = item.blank && !first;
    if (!first && item.kind != PieceKind::Formula && items_.back().kind == item.kind &&
        items_.back().piece == item.piece) {
        Item &last = items_.back(); // one run of words
        last.text += (blank ? " " : "") + item.text;
        last.width = widthOf(last.text);
        used_ = last.x + last.width;
        return;
    }
    item.x += used_ + (blank ? blank_ : 0.0F);
    used_ = item.x + item.width;
    items_.push_back(std::move(item));
}

/// Gives the items of the line their baseline.
void RichText::endLine() {
    if (items_.size() == lineBegin_) {
        return;
    }
    float ascent = 0.0F, descent = 0.0F;
    for (std::size_t k = lineBegin_; k < items_.size(); ++k) {
        ascent = std::max(ascent, items_[k].ascent);
        descent = std::max(descent, items_[k].descent);
    }
    const float baseline = std::round(height_ + ascent);
    for (std::size_t k = lineBegin_; k < items_.size(); ++k) {
        items_[k].y = baseline;
    }
    height_ = baseline + std::round(descent);
    lineBegin_ = items_.size();
    used_ = 0.0F;
}

void RichText::drawImage(const WidgetContext &context, const Item &item, ImVec2 corner) const {
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const float pad = item.descent;
    const ImVec2 max{corner.x + item.width, corner.y + item.ascent - pad};
    if (item.picture.texture != 0) {
        imgui::drawTexture(list, item.picture.texture, corner, max);
        return;
    }
    list.AddRectFilled(corner, max, context.theme.inset, context.px(4));
    list.AddRect(corner, max, context.theme.line, context.px(4));
    if (!item.picture.note.empty()) {
        list.AddText({corner.x + context.px(8), corner.y + context.px(6)}, context.theme.muted, item.text.c_str());
    }
}

std::optional<std::string> RichText::draw(WidgetContext &context, ImVec2 corner, Colour colour, std::string_view name,
                                          std::size_t &links, std::size_t &images) const {
    ImDrawList &list = *ImGui::GetWindowDrawList();
    std::optional<std::string> clicked;
    const Item *before = nullptr;
    for (const Item &item : items_) {
        const ImVec2 at{corner.x + item.x, corner.y + item.y};
        const ImVec2 top{at.x, at.y - (item.kind == PieceKind::Image ? item.ascent - item.descent : ascent_)};
        if (item.kind == PieceKind::Formula) {
            drawMath(context, item.formula, at, colour);
        } else if (item.kind == PieceKind::Image) {
            drawImage(context, item, top);
            markPart(context, std::string(name) + "/image/" + std::to_string(images++),
                     {top.x, top.y, item.width, item.ascent - item.descent});
        } else if (item.kind == PieceKind::Link) {
            const bool continued = before != nullptr && before->kind == item.kind && before->piece == item.piece;
            links += continued ? 0 : 1;
            const std::string known = std::string(name) + "/link/" + std::to_string(links - 1);
            ImGui::SetCursorScreenPos(top);
            if (hitArea((known + (continued ? "/more" : "")).c_str(), item.width, line_)) {
                clicked = item.target;
            }
            mark(context, continued ? known + "/more" : known);
            list.AddText(top, context.theme.accent, item.text.c_str());
            if (ImGui::IsItemHovered()) {
                ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
                list.AddLine({top.x, top.y + line_ - 1.0F}, {top.x + item.width, top.y + line_ - 1.0F},
                             context.theme.accent);
            }
        } else {
            list.AddText(top, colour, item.text.c_str());
        }
        before = &item;
    }
    return clicked;
}

} // namespace forefront::ui
