#pragma once

#include "core/teaching/lesson/glossary.hpp"
#include "ui/parts/dialog.hpp"

#include <string>
#include <string_view>

namespace forefront {

/// Explains the terms of the advancing front, each with a figure and links to others.
class GlossaryDialog final : public Dialog {
  public:
    /// `term`: id of the term to show first.
    explicit GlossaryDialog(std::string_view term);

    const char *id() const override { return "glossary"; }
    std::string title() const override { return "Glossary"; }
    float width() const override { return 760.0F; }
    float height() const override { return 520.0F; }
    bool draw(Shell &context) override;

  private:
    void drawList(Shell &context);
    void drawTerm(Shell &context);

    const GlossaryTerm *term_; ///< never null
};

} // namespace forefront
