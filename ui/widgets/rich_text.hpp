#pragma once

#include "core/teaching/markup/marked_text.hpp"
#include "core/teaching/markup/math_layout.hpp"
#include "ui/widgets/widget_context.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct ImVec2;

namespace forefront::ui {

/// A picture that a text shows.
struct TextPicture {
    unsigned texture = 0;              ///< of OpenGL; 0: still being read, or not available
    float columns = 0.0F, rows = 0.0F; ///< in pixels of its file; 0: not available
    std::string note{};                ///< why it is not available; empty: it is
};
/// Returns the picture of a file that a text names.
using PictureSource = std::function<TextPicture(const std::string &file)>;

/// A text with formulas, images and links, wrapped to a width. Lives within a frame.
class RichText {
  public:
    /// Wraps a text in the body font. `pictures`: may be empty if the text has no images.
    RichText(const WidgetContext &context, std::string_view text, float width, MarkupKind kind,
             const PictureSource &pictures = {});

    float height() const { return height_; }
    /// Draws the text with its corner at a place of the screen. Links and images are named `name`/link/0 and so on, for
    /// which `links` and `images` count. Returns the target of the link that was clicked.
    std::optional<std::string> draw(WidgetContext &context, ImVec2 corner, Colour colour, std::string_view name,
                                    std::size_t &links, std::size_t &images) const;

  private:
    /// Something on a line, from the left end of its baseline.
    struct Item {
        PieceKind kind = PieceKind::Words;
        float x = 0.0F, y = 0.0F, width = 0.0F;
        float ascent = 0.0F, descent = 0.0F;
        std::string text{};    ///< words; of an image, its words and why it is not available
        std::string target{};  ///< of a link
        std::size_t piece = 0; ///< that it is a part of
        bool blank = false;    ///< a blank comes before it, unless it begins a line
        MathLayout formula{};
        TextPicture picture{};
    };

    void addWords(const TextPiece &piece, std::size_t number);
    void addFormula(const MathNode &formula, std::size_t number, bool display);
    void addImage(const TextPiece &piece, std::size_t number, const PictureSource &pictures);
    void addUnit();
    void place(Item item);
    void endLine();
    Item wordItem(std::string text) const;
    void drawImage(const WidgetContext &context, const Item &item, ImVec2 corner) const;

    const WidgetContext &context_;
    float width_, line_, blank_, ascent_; ///< of the text; height of a line and its baseline, width of a blank
    float height_ = 0.0F;
    float used_ = 0.0F;      ///< of the line that is being filled
    std::vector<Item> unit_; ///< no line may end within it
    bool blankBefore_ = false;
    std::size_t lineBegin_ = 0; ///< the first item of the line
    std::vector<Item> items_;
};

} // namespace forefront::ui
