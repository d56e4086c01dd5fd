#pragma once

#include "core/engine/session/snapshot.hpp"

#include <memory>
#include <string>
#include <vector>

namespace forefront {

struct Shell;

/// A modal dialog, centred over the dimmed window. Open one with context.dialogs.open(std::make_unique<...>()); several
/// stack. Esc closes it unless closesOnEscape() returns false.
class Dialog {
  public:
    virtual ~Dialog() = default;
    virtual const char *id() const = 0;
    virtual std::string title() const = 0;
    /// Width and height in design pixels; height 0: as high as the content.
    virtual float width() const { return 480.0F; }
    virtual float height() const { return 0.0F; }
    virtual bool closesOnEscape() const { return true; }
    /// Adds the parts of the run's snapshot that it needs while it is open.
    virtual void request(SnapshotLayers & /*wanted*/) const {}
    /// Draws the content. Returns false to close the dialog.
    virtual bool draw(Shell &context) = 0;
};

class DialogHost {
  public:
    void open(std::unique_ptr<Dialog> dialog) { opening_.push_back(std::move(dialog)); }
    /// Returns the dialog on top, or null.
    const Dialog *top() const { return stack_.empty() ? nullptr : stack_.back().get(); }
    bool any() const { return !stack_.empty() || !opening_.empty(); }
    /// Returns true while a dialog waits to be drawn for the first time.
    bool opening() const { return !opening_.empty() || !appeared_; }
    void closeAll();
    /// Withdraws and closes every preview; call it before another document replaces the current one.
    void dismissPreviews(Shell &context);
    /// Draws all dialogs; called once per frame by the editor.
    void draw(Shell &context);

  private:
    void drawFrom(std::size_t level, Shell &context, std::vector<bool> &keep);

    std::vector<std::unique_ptr<Dialog>> stack_;
    std::vector<std::unique_ptr<Dialog>> opening_;
    std::vector<const Dialog *> dismissed_; ///< in stack_, to be closed
    bool appeared_ = true;                  ///< all of stack_ were drawn with their size
};

} // namespace forefront
