#pragma once

#include "ui/parts/dialog.hpp"

#include <string>
#include <vector>

namespace forefront {

class Recovery;

/// Offers to recover drawings that were unsaved when the program crashed.
class RecoveryDialog final : public Dialog {
  public:
    explicit RecoveryDialog(Recovery &recovery) : recovery_(recovery) {}

    const char *id() const override { return "recovery"; }
    std::string title() const override { return "Recover unsaved work?"; }
    float width() const override { return 520.0F; }
    bool draw(Shell &context) override;

  private:
    Recovery &recovery_;
    std::size_t chosen_ = 0;
};

} // namespace forefront
