#pragma once

#include "core/engine/base/length_unit.hpp"
#include "ui/parts/dialog.hpp"

#include <string>

namespace forefront {

class ActionRegistry;

/// Chooses the unit of the drawing, and whether its coordinates are scaled to it.
class UnitDialog final : public Dialog {
  public:
    explicit UnitDialog(LengthUnit unit) : unit_(unit) {}

    const char *id() const override { return "unit"; }
    std::string title() const override { return "Unit"; }
    float width() const override { return 440.0F; }
    bool draw(Shell &context) override;

  private:
    void drawEffect(Shell &context, LengthUnit before);
    /// Returns false if the command was refused.
    bool accept(Shell &context) const;

    LengthUnit unit_;
    bool scales_ = true; ///< where both units are known
};

/// Adds the command that opens the dialog.
void addUnitAction(ActionRegistry &actions);

} // namespace forefront
