#pragma once

#include "ui/parts/dialog.hpp"

namespace forefront {

/// A dialog that previews its result on the canvas. It is placed in the upper left corner and does not dim the window.
class PreviewDialog : public Dialog {
  public:
    /// Restores the document from before the preview. Called when Esc or the close button closes the dialog, and before
    /// another document is opened.
    virtual void dismiss(Shell &context) = 0;
};

} // namespace forefront
