#include "ui/editor/canvas_input.hpp"

#include "ui/parts/shell.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/shell/pointer_hints.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/judging.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace forefront {

namespace {

constexpr double kZoomStep = 1.18;

bool canvasFree(const Shell &context) {
    return !ImGui::GetIO().WantCaptureMouse && !context.dialogs.any();
}

} // namespace

bool CanvasInput::offer(CanvasEvent event, Shell &context) const {
    event.pixel = pixel_;
    event.place = context.view.camera.toPlane(pixel_);
    event.modifiers = modifiers_;
    const ToolUse use(context);
    const bool handled = context.tools.current().handle(event, context);
    use.finish(context);
    return handled;
}

void CanvasInput::dispatch(const InputEvent &event, Shell &context) {
    context.tools.followDocument(context);
    switch (event.kind) {
    case InputKind::MouseMove:
        move(event, context);
        break;
    case InputKind::MouseButton:
        button(event, context);
        break;
    case InputKind::Scroll:
        scroll(event, context);
        break;
    case InputKind::Key:
        keyed_ = keyed_ || event.pressed;
        key(event, context);
        break;
    case InputKind::Text:
        if (!ui::typing().active && !context.dialogs.any() && !context.menuKeys.open) {
            offer({.kind = CanvasEvent::Kind::Text, .character = static_cast<char32_t>(event.code)}, context);
        }
        break;
    case InputKind::Focus:
        if (!event.pressed) {
            modifiers_ = {};
            spaceDown_ = false;
        }
        break;
    case InputKind::Drop:
    case InputKind::Close:
        break;
    }
}

void CanvasInput::move(const InputEvent &event, Shell &context) {
    const Pixel before = pixel_;
    pixel_ = {event.x, event.y};
    const bool over = canvasFree(context) && context.view.camera.viewport.contains(pixel_);
    if (panning_) {
        context.view.pan(pixel_ - before);
        spaceUsed_ = true;
    } else if (held_) {
        offer({.kind = CanvasEvent::Kind::Drag, .button = *held_}, context);
    } else if (over) {
        offer({.kind = CanvasEvent::Kind::Hover}, context);
    } else if (over_) {
        offer({.kind = CanvasEvent::Kind::Leave}, context);
    }
    over_ = over;
    context.view.pointer = over || held_ ? std::optional(context.view.camera.toPlane(pixel_)) : std::nullopt;
}

int CanvasInput::countClicks(const InputEvent &event, Shell &context) {
    const double arrived = event.arrival(context.platform.now());
    const bool again =
        arrived - clickTime_ < 0.35 && glm::distance(pixel_, clickPixel_) < 4.0 * static_cast<double>(context.scale);
    clicks_ = again ? clicks_ + 1 : 1;
    clickTime_ = arrived;
    clickPixel_ = pixel_;
    return clicks_;
}

void CanvasInput::button(const InputEvent &event, Shell &context) {
    const auto which = static_cast<MouseButton>(event.code);
    if (!event.pressed) {
        if (panning_) {
            panning_ = false;
        } else if (held_ == which) {
            held_.reset();
            offer({.kind = CanvasEvent::Kind::Release, .button = which, .clicks = clicks_}, context);
        }
        return;
    }
    if (!canvasFree(context) || !context.view.camera.viewport.contains(pixel_) || held_ || panning_) {
        return;
    }
    context.naming.row.reset(); // from now on, F2 renames what is selected on the canvas
    if (which == MouseButton::Middle || (spaceDown_ && which == MouseButton::Left)) {
        panning_ = true;
        return;
    }
    if (which == MouseButton::Right && shell::openLegendMenu(context, pixel_)) {
        return;
    }
    if (ui::typing().active) {
        context.widgets.fields.leave(FieldFocus::Leave::Click); // it commits its text before anything is selected
        waitingPress_ = event;
        return;
    }
    held_ = which;
    const bool used =
        offer({.kind = CanvasEvent::Kind::Press, .button = which, .clicks = countClicks(event, context)}, context);
    // A tool without a use for the right button has a menu nevertheless.
    if (!used && which == MouseButton::Right) {
        context.selection.clear(); // it is not drawn in this tool, so the menu must not act on it
        context.contextMenu = true;
    }
}

void CanvasInput::scroll(const InputEvent &event, Shell &context) {
    if (!canvasFree(context) || !context.view.camera.viewport.contains(pixel_)) {
        return;
    }
    // Shift turns a wheel sideways on some systems.
    const double steps = event.y != 0.0 ? event.y : event.x;
    const bool forTool = (modifiers_.control() || modifiers_.shift()) &&
                         offer({.kind = CanvasEvent::Kind::Wheel, .wheel = steps}, context);
    if (!forTool) {
        context.view.zoomAt(pixel_, std::pow(kZoomStep, steps));
        context.view.pointer = context.view.camera.toPlane(pixel_);
    }
}

void CanvasInput::spaceKey(const InputEvent &event, Shell &context) {
    // A tap on Space plays or pauses; holding it turns a drag into a pan.
    if (event.pressed && !spaceDown_) {
        spaceDown_ = true;
        // A blank in what is typed for a tool is text.
        spaceUsed_ = offer({.kind = CanvasEvent::Kind::Key, .key = key::kSpace}, context);
    } else if (!event.pressed && spaceDown_) {
        spaceDown_ = false;
        if (!spaceUsed_ && !panning_) {
            countKeyUse(context, key::kSpace);
            context.actions.runShortcut({key::kSpace, {}}, false, context);
        }
    }
}

/// Splits keys between a text field and the program. The field gets the keys that type and edit text, and undo and redo
/// as long as it has something to undo or redo. For other shortcuts with Ctrl or the left Alt key, for function keys
/// and for those that turn pages, the field commits its text, then the shortcut runs.
void CanvasInput::fieldKey(const InputEvent &event, Shell &context) {
    const bool functionKey = event.code >= key::kF1 && event.code < key::kF1 + 12;
    const bool pageKey = event.code == key::kPageUp || event.code == key::kPageDown;
    const bool alt = modifiers_ == kAlt && imgui::keyHeld(key::kLeftAlt); // the right one types characters
    if (!event.pressed || (!modifiers_.control() && !functionKey && !pageKey && !alt)) {
        return;
    }
    const Shortcut shortcut{event.code, modifiers_};
    const ui::Typing typing = ui::typing();
    const bool redo = (event.code == 'Z' && modifiers_.shift()) || event.code == 'Y';
    const bool undo = event.code == 'Z' && !modifiers_.shift();
    const bool clipboard =
        (event.code == 'A' || event.code == 'C' || event.code == 'V' || event.code == 'X') && !modifiers_.shift();
    if ((undo && typing.canUndo) || (redo && typing.canRedo) || clipboard) {
        return;
    }
    if ((undo || redo) && context.dimensionEntry.constraint) { // which is about its text, never about the drawing
        context.dimensionEntry.restore = undo;
        context.widgets.fields.leave(undo ? FieldFocus::Leave::Shortcut : FieldFocus::Leave::No);
        return;
    }
    if (context.actions.knows(shortcut) && !event.repeated) {
        context.widgets.fields.leave(FieldFocus::Leave::Shortcut);
        waiting_ = shortcut;
    }
}

/// Opens a menu of the bar for its letter with Alt, or the first one for F10. Returns false for other keys. A field
/// commits its text first, and keeps the focus if that is refused.
bool CanvasInput::openMenu(const InputEvent &event, Shell &context) {
    const bool leftAlt = imgui::keyHeld(key::kLeftAlt); // the right one types characters on many keyboards
    const bool letter = modifiers_ == kAlt && leftAlt && event.code >= 'A' && event.code <= 'Z';
    const bool first = modifiers_.none() && event.code == key::kF1 + 9;
    if (!event.pressed || event.repeated || (!letter && !first)) {
        return false;
    }
    if (letter && context.actions.canRun({event.code, modifiers_}, context)) {
        return false;
    }
    waitingMenu_ = first ? 'F' : static_cast<char>(event.code);
    if (ui::typing().active) {
        context.widgets.fields.leave(FieldFocus::Leave::Shortcut);
    }
    return true;
}

/// Handles a key while a menu is open, which owns the keyboard. Dear ImGui handles the arrow keys within it and Esc.
void CanvasInput::menuKey(const InputEvent &event, Shell &context) {
    if (!event.pressed) {
        return;
    }
    MenuKeys &keys = context.menuKeys;
    if (event.code == key::kLeft || event.code == key::kRight) {
        keys.step = event.code == key::kRight ? 1 : -1;
    } else if (event.code >= 'A' && event.code <= 'Z' && !modifiers_.control()) {
        keys.letter = static_cast<char>(event.code);
    }
    context.animate();
}

void CanvasInput::runWaiting(Shell &context) {
    // Nothing follows a text that was refused: the user is still in its field.
    const bool stays = context.widgets.fields.travelling();
    if (const std::optional<Shortcut> shortcut = std::exchange(waiting_, std::nullopt); shortcut && !stays) {
        runShortcut(*shortcut, false, context);
        context.animate();
    }
    if (const std::optional<InputEvent> press = std::exchange(waitingPress_, std::nullopt);
        press && !stays && !ui::typing().active) {
        button(*press, context);
    }
    if (const char menu = std::exchange(waitingMenu_, 0); menu != 0 && !stays) {
        context.menuKeys.mnemonic = menu;
        context.animate();
    }
}

/// Offers the pointer again where it rests, if what is under it may have changed: a rubber band must not keep an end
/// that a key, undo or zoom has taken away.
void CanvasInput::showTool(Shell &context) {
    const Camera &camera = context.view.camera;
    const Scene scene{context.document.revision(), camera.toPlane({camera.viewport.x, camera.viewport.y}), camera.zoom};
    if ((!keyed_ && scene == seen_) || !over_ || held_ || panning_ || !canvasFree(context)) {
        return;
    }
    keyed_ = false;
    seen_ = scene;
    context.view.pointer = camera.toPlane(pixel_);
    offer({.kind = CanvasEvent::Kind::Hover}, context);
}

void CanvasInput::endFrame(Shell &context) {
    runWaiting(context);
    context.menuKeys.open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup) && !context.dialogs.any();
    context.tools.followDocument(context);
    showTool(context);
}

void CanvasInput::key(const InputEvent &event, Shell &context) {
    const ImGuiIO &io = ImGui::GetIO();
    modifiers_.bits =
        static_cast<std::uint8_t>((io.KeyShift ? Modifiers::kShift : 0) | (io.KeyCtrl ? Modifiers::kControl : 0) |
                                  (io.KeyAlt ? Modifiers::kAlt : 0));
    if (event.code >= key::kLeftShift) {
        // The tool may show the effect of a modifier before the pointer moves.
        if (over_ && !held_ && !panning_) {
            offer({.kind = CanvasEvent::Kind::Hover}, context);
        }
        return;
    }
    if (context.dialogs.any()) {
        return;
    }
    if (openMenu(event, context)) {
        return;
    }
    if (context.menuKeys.open) {
        menuKey(event, context);
        return;
    }
    if (ui::typing().active) {
        fieldKey(event, context);
        return;
    }
    if (event.code == key::kSpace && modifiers_.none()) {
        spaceKey(event, context);
        return;
    }
    if (!event.pressed) {
        return;
    }
    if (event.code == key::kEscape && ImGui::IsAnyItemActive()) {
        return; // it cancels the drag of a slider
    }
    if (event.code == key::kEscape && context.probe.chosen && !context.probe.active) {
        context.probe.chosen.reset(); // such as the worst element, shown with any tool
        return;
    }
    if (context.probe.walks && modifiers_.none() && walkByKey(context, event.code)) {
        return;
    }
    if (!offer({.kind = CanvasEvent::Kind::Key, .key = event.code, .repeated = event.repeated}, context)) {
        if (modifiers_.none() && !event.repeated) {
            countKeyUse(context, event.code);
        }
        runShortcut({event.code, modifiers_}, event.repeated, context);
    }
}

/// Runs the action with a shortcut, or says what it needs.
void CanvasInput::runShortcut(Shortcut shortcut, bool repeated, Shell &context) {
    if (context.actions.runShortcut(shortcut, repeated, context) || repeated) {
        return;
    }
    if (const Action *const action = context.actions.waiting(shortcut, context)) {
        constexpr std::string_view kEllipsis = "\xe2\x80\xa6";
        std::string title = action->title;
        if (title.ends_with(kEllipsis)) {
            title.resize(title.size() - kEllipsis.size());
        }
        context.log.inform(title + ": " + action->needs);
        context.animate();
    }
}

} // namespace forefront
