#pragma once

#include "core/teaching/lesson/lesson.hpp"
#include "core/teaching/markup/marked_text.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// Writes texts of a lesson as HTML, and keeps the pictures that they show.
class TextHtml {
  public:
    explicit TextHtml(const Lesson &lesson) : lesson_(lesson) {}

    /// Returns a text, whose values have been replaced, as HTML. Pictures are numbered by their places in pictures(),
    /// links by their pages, counted from 0: lesson.js completes both.
    std::string of(std::string_view text, MarkupKind kind = MarkupKind::All);
    /// Returns the pictures that the texts so far show, as URLs with their data.
    std::vector<std::string> pictures() const;

  private:
    std::string image(const TextPiece &piece);

    const Lesson &lesson_;
    std::vector<std::string> files_; ///< of the pictures
};

} // namespace forefront
