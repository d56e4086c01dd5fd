#pragma once

#include "ui/dialogs/drawing_cards.hpp"
#include "ui/parts/dialog.hpp"

namespace forefront {

/// Shows the samples with thumbnails; a click opens one as a new document.
class GalleryDialog final : public Dialog {
  public:
    explicit GalleryDialog(Shell &context);

    const char *id() const override { return "gallery"; }
    std::string title() const override { return "Samples"; }
    float width() const override { return 940.0F; }
    float height() const override { return 640.0F; }
    bool draw(Shell &context) override;

  private:
    DrawingCards cards_;
};

} // namespace forefront
