#pragma once

#include "ui/parts/dialog.hpp"

namespace forefront {

/// A dialog that previews its result on the canvas, and does not dim the window.
class PreviewDialog : public Dialog {
  public:
    /// Returns true if it takes the place of the options bar, in one row; false: it takes the place of the column.
    virtual bool inOptionsBar() const { return false; }
    /// Restores the document from before the preview. Called when Esc or the close button closes the dialog, and before
    /// another document is opened.
    virtual void dismiss(Shell &context) = 0;
};

/// Returns true while a drawing is shown that the user has not accepted yet, at a scale that may be wrong.
bool offersDrawing(const Shell &context);

} // namespace forefront
