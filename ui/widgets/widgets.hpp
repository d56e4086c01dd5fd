#pragma once

#include "ui/widgets/widget_context.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Widgets of Dear ImGui in the style of the program. Each registers its name and rectangle, so that scripts and tests
/// can refer to it. Names are paths, unique within a frame: "dialog/export/format".
namespace forefront::ui {

/// Registers the last item of Dear ImGui.
void mark(WidgetContext &context, std::string_view name, bool enabled = true);
/// Registers any rectangle.
void markRect(WidgetContext &context, std::string_view name, const PixelRect &rect, bool enabled = true);
/// Registers a rectangle of the window of Dear ImGui that is being drawn, which may be scrolled away.
void markPart(WidgetContext &context, std::string_view name, const PixelRect &rect);

/// Registers the window of Dear ImGui that is being drawn.
void markWindow(WidgetContext &context, std::string_view name);

/// Adds an area that takes clicks, in pixels of the screen. Returns true if it was clicked. Dear ImGui aborts on a side
/// of zero, as a small window leaves it, so that each side counts as one pixel at least.
bool hitArea(const char *name, float width, float height);

enum class ButtonKind : std::uint8_t { Plain, Primary, Quiet };
/// Draws a button. Width in design pixels; 0: as wide as the label, negative: the rest of the row.
bool button(WidgetContext &context, std::string_view name, std::string_view label, ButtonKind kind = ButtonKind::Plain,
            bool enabled = true, float width = 0.0F);
/// Draws one of several buttons of which one is chosen: that one is filled, the others have only an edge. Returns true
/// if it was pressed.
bool chip(WidgetContext &context, std::string_view name, std::string_view label, bool chosen);
/// Draws a square button with an icon, highlighted if `on`. Size in design pixels.
bool iconButton(WidgetContext &context, std::string_view name, const char *icon, const std::string &tooltip,
                bool on = false, bool enabled = true, float size = 32.0F);
/// Draws a checkbox. In a dialog, Tab reaches it and Space switches it.
bool checkbox(WidgetContext &context, std::string_view name, std::string_view label, bool &value);
/// Draws a visibility switch for a layer: an eye and a label.
bool eyeSwitch(WidgetContext &context, std::string_view name, std::string_view label, bool &value, float width);
/// Draws exclusive choices side by side; returns true when the choice changed. `width` is the total width in design
/// pixels; 0: the rest of the row. `tips` holds one tooltip per choice, or none.
bool segmented(WidgetContext &context, std::string_view name, std::span<const char *const> labels, int &choice,
               float width = 0.0F, std::span<const char *const> tips = {});
bool combo(WidgetContext &context, std::string_view name, std::span<const char *const> labels, int &choice,
           float width = -1.0F);
/// Draws a combo of any texts, such as names from a file, which may be empty or repeated.
bool combo(WidgetContext &context, std::string_view name, const std::vector<std::string> &labels, int &choice,
           float width = -1.0F);
/// Draws a linear or logarithmic slider and its number; `width` is the total width. `format` is a printf format for a
/// double.
bool slider(WidgetContext &context, std::string_view name, double &value, double minimum, double maximum,
            const char *format, bool logarithmic = false, float width = -1.0F);
/// Draws a thin slider with `shown` to its right; `t` in [0, 1]. Widths in design pixels.
bool thinSlider(WidgetContext &context, std::string_view name, double &t, std::string_view shown, float width,
                float textWidth);
/// Draws a one-line text field. Returns true when the text changed, or with `onEnter` when Enter was pressed. With
/// `selectAll`, entering the field selects its text.
bool inputText(WidgetContext &context, std::string_view name, std::string &value, std::string_view hint = {},
               float width = -1.0F, bool onEnter = false, bool focus = false, bool selectAll = false);
/// Draws a text field that is committed by Enter, Tab or a click elsewhere; Esc restores the old text. Returns true in
/// the frame in which a changed text is committed to `value`. With `selectAll`, entering the field selects its text.
bool entry(WidgetContext &context, std::string_view name, std::string &value, std::string_view hint = {},
           float width = -1.0F, bool selectAll = false);
/// Returns true if the entry() that is drawn next is being edited, or this frame begins to edit it: it must be given
/// all that its user may change.
bool showsEdited(const WidgetContext &context, std::string_view name, float width = -1.0F);
/// The text field being edited, if any, and whether it can undo and redo.
struct Typing {
    bool active = false, canUndo = false, canRedo = false;
};
Typing typing();
/// Returns true if Enter, also that of the keypad, was pressed in the window being drawn or in its children, not in a
/// menu or dialog above it.
bool enterPressed();
/// Returns true if enterPressed() while no field had the focus. Call it before the fields are drawn: one that takes
/// Enter gives up the focus.
bool enterOutsideFields();
/// Lets Tab reach the first field or switch of the window being drawn when none has the focus. Call it before they are
/// drawn.
void startTabbing(WidgetContext &context);
/// Lets Tab reach the switch just drawn, if it is in a dialog; on the canvas and in panels, its keys are shortcuts.
/// Returns true if it has the focus.
bool takesFocus(WidgetContext &context, std::string_view name);
/// Draws a selectable row. Returns true when clicked.
bool selectable(WidgetContext &context, std::string_view name, std::string_view label, bool selected,
                std::string_view detail = {});
/// Draws a link. Returns true when clicked.
bool link(WidgetContext &context, std::string_view name, std::string_view text);

/// Draws the heading of a group.
void heading(WidgetContext &context, std::string_view text);
/// Draws a muted label and its value in the column where rowLabel() of this width has its field; below a label that
/// needs more room.
void field(WidgetContext &context, std::string_view label, std::string_view value, double width);
void muted(WidgetContext &context, std::string_view text);
/// Marks the label just drawn as "caption/TEXT/Y", where Y is its place on the screen: labels repeat between panels.
void markCaption(WidgetContext &context, std::string_view text);
/// Draws the muted label of a row in a column of this width, in design pixels; a wider label is on a line of its own,
/// above the field. Draw the field next.
void rowLabel(WidgetContext &context, const char *text, double width);
void small(WidgetContext &context, std::string_view text, bool wrap = false);
/// Shows `text` while the last item is hovered.
void tooltip(WidgetContext &context, std::string_view text);
/// Shows `text` while the last item, or the label to its left, is hovered.
void rowTooltip(WidgetContext &context, std::string_view text);
/// Shows `text` while the pointer is over a rectangle of the current window.
void tooltipOver(WidgetContext &context, const PixelRect &rect, std::string_view text);
/// Shows `text` below the last item, in the error colour or, for a remark, in grey.
void faultNote(WidgetContext &context, std::string_view text, bool fault = true);
/// Draws a coloured pill with text, such as "out of date". Returns true when clicked.
bool badge(WidgetContext &context, std::string_view name, std::string_view text, Colour colour);

/// Formats a count with grouped digits: "12 345".
std::string count(std::uint64_t number);
/// Formats like printf and returns the string.
std::string format(const char *pattern, ...) __attribute__((format(printf, 1, 2)));
/// Formats a number for display, with `digits` significant digits, all digits before the point and no trailing zeros:
/// "0.05", "12.3", "140". Uses an exponent only below 0.0001 and from 10⁹.
std::string number(double value, int digits = 4);
/// Formats a number as number() does, with grouped digits before the point: "12 345.5".
std::string grouped(double value, int digits = 5);
/// Formats a number for editing: the shortest text that is read as the same number, with an exponent only for very
/// small and very large numbers.
std::string editedNumber(double value);
/// Formats a number for a table, with up to twelve significant digits, which leave out the noise of rounding: "0.72"
/// for 0.7200000000000001.
std::string listedNumber(double value);
/// Formats a mean of counts with about three digits: "3.27", "41.5", "140".
std::string mean(double value);

} // namespace forefront::ui
