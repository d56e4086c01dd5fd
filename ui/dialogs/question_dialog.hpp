#pragma once

#include "ui/parts/dialog.hpp"

#include <functional>
#include <string>
#include <vector>

namespace forefront {

/// Asks a question with a few answers; Esc closes it without an answer.
class QuestionDialog final : public Dialog {
  public:
    struct Answer {
        std::string id; ///< the button is the widget "dialog/ID/ANSWER"
        std::string label;
        bool primary = false;
        std::function<void(Shell &)> then; ///< may be empty
    };
    QuestionDialog(std::string id, std::string title, std::string text, std::vector<Answer> answers)
        : id_(std::move(id)), title_(std::move(title)), text_(std::move(text)), answers_(std::move(answers)) {}

    const char *id() const override { return id_.c_str(); }
    std::string title() const override { return title_; }
    float width() const override;
    bool draw(Shell &context) override;

  private:
    std::string id_, title_, text_;
    std::vector<Answer> answers_;
};

} // namespace forefront
