#pragma once

#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"
#include "ui/parts/preview_dialog.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace ui {
class Flow;
}

/// A number, choice or switch that an operation asks for.
struct OperationField {
    enum class Kind : std::uint8_t { Number, Choice, Flag };
    const char *id = "";
    const char *label = "";
    double value = 0.0; ///< proposed; index of a choice; 0 or 1 for a flag
    const char *tooltip = "";
    Kind kind = Kind::Number;
    std::vector<const char *> choices{};
    bool isLength = false; ///< of a number: it is in the unit of the document
};

/// An operation on the selection that asks for numbers.
struct Operation {
    const char *id = "";    ///< its fields are the widgets "dialog/ID/FIELD"
    const char *title = ""; ///< also the label of the edit
    std::vector<OperationField> fields;
    /// Returns the document after the operation; the values are those of the fields, in order. `made` may become the
    /// new selection.
    std::function<Result<Document>(const Document &, const Selection &, const std::vector<double> &, Selection *made)>
        run;
    /// Lets numbers of the result follow the expressions typed into the fields, in order; those of plain numbers are
    /// empty. Returns true if all of them do. None: no number can.
    std::function<bool(Document &, const Selection &, const std::vector<std::string> &)> follow{};
    /// Adds constraints to the settled result; the first document is the one before the operation. None: adds none.
    Document (*constrain)(const Document &, const Document &) = nullptr;
};

/// Asks in the options bar for the numbers of an operation while the canvas previews its result, also for a number that
/// is being typed. Cancel leaves the document and its history unchanged; OK is one undo step.
class OperationDialog final : public PreviewDialog {
  public:
    OperationDialog(Operation operation, Shell &context);

    const char *id() const override { return operation_.id; }
    std::string title() const override { return operation_.title; }
    bool inOptionsBar() const override { return true; }
    void dismiss(Shell &context) override;
    bool draw(Shell &context) override;

  private:
    /// The contents of the fields, in order.
    struct Entries {
        std::vector<double> values;
        std::vector<std::string> formulas; ///< expressions of the values; empty: plain numbers
        bool operator==(const Entries &) const = default;
    };

    void drawField(Shell &context, std::size_t index);
    void drawRemarks(Shell &context, ui::Flow &flow);
    /// Draws Cancel and OK. Returns false to close the dialog.
    bool drawButtons(Shell &context, bool enter);
    /// Returns the contents of the fields, with the number that is being typed.
    Entries entriesBeingTyped(const Shell &context) const;
    void show(Shell &context, Entries entries);
    void accept(Shell &context);
    std::string widget(std::size_t index) const;

    Operation operation_;
    Entries entries_;       ///< as committed
    Entries shown_;         ///< as previewed
    bool followed_ = false; ///< the result follows the expressions
    std::shared_ptr<const Document> start_;
    Selection selection_;
    Selection made_;
    std::string stroke_;
    std::string fault_; ///< why there is no result, and how to fix it
};

} // namespace forefront
