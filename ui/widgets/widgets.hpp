#pragma once

#include "ui/editor/app_context.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

/// Widgets of Dear ImGui in the dress of the program. Each registers its name and rectangle, so that scripts and tests
/// can say "click file/save". Names are paths, unique within a frame: "dialog/export/format".
namespace forefront::ui {

/// Registers the item just drawn with Dear ImGui itself.
void mark(AppContext &context, std::string_view name, bool enabled = true);
/// Registers any rectangle.
void markRect(AppContext &context, std::string_view name, const PixelRect &rect, bool enabled = true);

/// Registers the window of Dear ImGui that is being drawn.
void markWindow(AppContext &context, std::string_view name);

enum class ButtonKind : std::uint8_t { Plain, Primary, Quiet };
/// Width in design pixels; 0: as wide as the label, negative: all that is left.
bool button(AppContext &context, std::string_view name, std::string_view label, ButtonKind kind = ButtonKind::Plain,
            bool enabled = true, float width = 0.0F);
/// A square button with an icon; `on`: lit. Size in design pixels.
bool iconButton(AppContext &context, std::string_view name, const char *icon, const std::string &tooltip,
                bool on = false, bool enabled = true, float size = 32.0F);
bool checkbox(AppContext &context, std::string_view name, std::string_view label, bool &value);
/// A switch with an eye and a label, lit when on; for layers.
bool eyeSwitch(AppContext &context, std::string_view name, std::string_view label, bool &value, float width);
/// One of several exclusive choices side by side; true when it changed. `width` of the whole in design pixels; 0: all.
/// `tips`: one for each choice, or none.
bool segmented(AppContext &context, std::string_view name, std::span<const char *const> labels, int &choice,
               float width = 0.0F, std::span<const char *const> tips = {});
bool combo(AppContext &context, std::string_view name, std::span<const char *const> labels, int &choice,
           float width = -1.0F);
/// Logarithmic or linear slider. `format` as printf for a double.
bool slider(AppContext &context, std::string_view name, double &value, double least, double greatest,
            const char *format, bool logarithmic = false, float width = -1.0F);
/// A thin track with a round grip and the value in words at its right; `t` in [0, 1]. Widths in design pixels.
bool thinSlider(AppContext &context, std::string_view name, double &t, std::string_view shown, float width,
                float textWidth);
/// Text in one line. True when it changed (with `onEnter`: when Enter was pressed).
bool inputText(AppContext &context, std::string_view name, std::string &value, std::string_view hint = {},
               float width = -1.0F, bool onEnter = false, bool focus = false);
/// Text that counts once its field is left, by Enter, Tab or a click elsewhere; Esc leaves it as it was. True in the
/// frame in which it is left with another text, which is then in `value`. `selectAll`: entering it selects the text.
bool entry(AppContext &context, std::string_view name, std::string &value, std::string_view hint = {},
           float width = -1.0F, bool selectAll = false);
/// The same with a number. What is no finite number is told in the log and changes nothing.
bool inputNumber(AppContext &context, std::string_view name, double &value, float width = -1.0F);
/// The number that was typed; none: told in the log.
std::optional<double> typedNumber(AppContext &context, const std::string &typed);
/// What the field that has the keyboard can take back or do again; nothing while none has it.
struct Typing {
    bool active = false, canUndo = false, canRedo = false;
};
Typing typing();
/// A whole line that can be chosen. True when clicked.
bool selectable(AppContext &context, std::string_view name, std::string_view label, bool selected,
                std::string_view detail = {});
/// Text in the accent colour that can be clicked.
bool link(AppContext &context, std::string_view name, std::string_view text);
/// Menu entry that runs an action of the registry.
void actionItem(AppContext &context, const Action &action);

/// A heading over a group.
void heading(AppContext &context, std::string_view text);
/// Muted label, then the value in the same line at a fixed column (design pixels).
void field(AppContext &context, std::string_view label, std::string_view value, float column = 108.0F);
void muted(AppContext &context, std::string_view text);
void small(AppContext &context, std::string_view text, bool wrap = false);
/// Shows `text` while the last item is hovered.
void tooltip(AppContext &context, std::string_view text);
/// Shows `text` while the last item, or the label to its left, is hovered.
void rowTooltip(AppContext &context, std::string_view text);
/// Shows `text` while the pointer is over a rectangle of the current window.
void tooltipOver(AppContext &context, const PixelRect &rect, std::string_view text);
/// A coloured pill with text, such as "out of date"; true when clicked.
bool badge(AppContext &context, std::string_view name, std::string_view text, Colour colour);

/// "12 345": digits grouped by thin gaps for people.
std::string count(std::uint64_t number);
/// printf into a string.
std::string format(const char *pattern, ...) __attribute__((format(printf, 1, 2)));
/// A number as people write it, with `digits` significant digits, all digits before the point and no trailing zeros:
/// "0.05", "12.3", "140". With an exponent only below 0.0001 and from 10⁹ on.
std::string number(double value, int digits = 4);
/// A mean of counts with about three digits: "3.27", "41.5", "140".
std::string mean(double value);

} // namespace forefront::ui
