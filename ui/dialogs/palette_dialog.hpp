#pragma once

#include "ui/app/action.hpp"
#include "ui/dialogs/dialog.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// How well a title answers what was typed: the letters must appear in order; beginnings of words and neighbours count
/// more. 0: not at all.
int paletteScore(std::string_view title, std::string_view typed);

/// Every action of the program by name, found by a few letters.
class PaletteDialog final : public Dialog {
  public:
    const char *id() const override { return "palette"; }
    std::string title() const override { return "Do what?"; }
    float width() const override { return 520.0F; }
    bool draw(AppContext &context) override;

  private:
    std::vector<const Action *> matches(const AppContext &context) const;

    std::string typed_;
    int chosen_ = 0;
    bool focus_ = true;
};

} // namespace forefront
