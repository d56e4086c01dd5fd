#pragma once

#include "ui/dialogs/key_list.hpp"
#include "ui/dialogs/scale_dialog.hpp"
#include "ui/parts/dialog.hpp"

#include <string>
#include <utility>

namespace forefront {

/// Edits the settings. Every change takes effect at once.
class PreferencesDialog final : public Dialog {
  public:
    PreferencesDialog() = default;
    /// Opens the page of keys, with the commands that contain a text.
    explicit PreferencesDialog(std::string command) : page_(kKeys), keys_(std::move(command)) {}

    const char *id() const override { return "preferences"; }
    std::string title() const override { return "Preferences"; }
    float width() const override { return 640.0F; }
    float height() const override { return 560.0F; }
    bool closesOnEscape() const override { return !keys_.capturing(); }
    bool draw(Shell &context) override;

  private:
    void drawAppearance(Shell &context);

    static constexpr int kKeys = 4;

    int page_ = 0;
    ScaleSlider scale_;
    KeyList keys_;
};

} // namespace forefront
