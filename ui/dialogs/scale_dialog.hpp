#pragma once

#include "ui/parts/dialog.hpp"

#include <string>

namespace forefront {

inline constexpr const char *kScaleNote =
    "Multiplies the scale of the screen. Takes effect when you release the slider.";

/// A slider for the scale of the interface, which takes effect when the slider is released: it moves with the scale.
class ScaleSlider {
  public:
    /// `name`: of the widget.
    void draw(Shell &context, const std::string &name);
    void reset(Shell &context);

  private:
    double percent_ = 0.0; ///< while it is dragged; 0: not drawn yet
};

/// Sets the scale of the interface.
class ScaleDialog final : public Dialog {
  public:
    const char *id() const override { return "scale"; }
    std::string title() const override { return "Interface scale"; }
    float width() const override { return 420.0F; }
    bool draw(Shell &context) override;

  private:
    ScaleSlider slider_;
};

} // namespace forefront
