#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/files/source/import_notes.hpp"
#include "ui/dialogs/import_dialog.hpp"
#include "ui/dialogs/import_layers.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/fault_text.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/messages/option_hints.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// The rows of the dialog that imports a drawing: its sizes, its questions and its report.

namespace forefront {

namespace {

constexpr float kLabels = 104.0F;  ///< column of the values, in design pixels
constexpr float kChoices = 176.0F; ///< width of the choices, in design pixels
constexpr double kMaxReport = 150; ///< height of the faults and notes, in design pixels

std::string extent(const Box2 &box, double scale) {
    return box.empty() ? std::string("nothing")
                       : ui::grouped(scale * box.size().x) + " \xc3\x97 " + ui::grouped(scale * box.size().y);
}

/// Returns the place of a text in a list that holds it.
int placeIn(const std::vector<std::string> &list, const std::string &text) {
    return static_cast<int>(std::find(list.begin(), list.end(), text) - list.begin());
}

std::vector<std::string> textsOf(const Diagnostics &diagnostics) {
    std::vector<std::string> texts;
    for (const Diagnostic &diagnostic : diagnostics) {
        texts.push_back(withEditorHints(diagnostic.message, {}));
    }
    return texts;
}

/// Notes of one kind on what reading a file did.
struct NoteGroup {
    const char *id, *title;
    std::vector<std::string> texts;
    std::vector<std::optional<Vec2>> places; ///< of each, in the file
};

/// Returns true if a note says that something of the file is not in the drawing.
bool leavesOut(const Diagnostic &note) {
    const auto says = [&note](std::string_view words) { return note.message.find(words) != std::string::npos; };
    return says("ignored") || says("left out") || says("not read");
}

/// Returns the first place that a note names, as in "first at (2.5, 4)", in the coordinates of the file.
std::optional<Vec2> firstPlace(const std::string &message) {
    for (std::size_t at = message.find("at ("); at != std::string::npos; at = message.find("at (", at + 1)) {
        double x = 0.0, y = 0.0;
        const char *const text = message.c_str() + at + 4, *const end = message.c_str() + message.size();
        const auto first = std::from_chars(text, end, x);
        const bool comma = first.ec == std::errc() && end - first.ptr > 2 && first.ptr[0] == ',' && first.ptr[1] == ' ';
        if (comma && std::from_chars(first.ptr + 2, end, y).ec == std::errc()) {
            return Vec2{x, y};
        }
    }
    return std::nullopt;
}

/// Returns the notes in groups: what the user should look at, what is left out, what was changed.
std::vector<NoteGroup> groupsOf(const Diagnostics &notes) {
    NoteGroup ask{"ask", "Check", {}, {}}, leftOut{"left-out", "Left out", {}, {}},
        changed{"changed", "Changed", {}, {}};
    for (const Diagnostic &note : notes) {
        NoteGroup &group = note.severity != Severity::Note ? ask : leavesOut(note) ? leftOut : changed;
        group.texts.push_back(withEditorHints(note.message, {}));
        group.places.push_back(note.at ? note.at : firstPlace(note.message));
    }
    std::vector<NoteGroup> groups;
    for (NoteGroup *group : {&ask, &leftOut, &changed}) {
        if (!group->texts.empty()) {
            groups.push_back(std::move(*group));
        }
    }
    return groups;
}

/// Returns the height of small texts one below the other, in pixels.
float heightOf(const Shell &context, const std::vector<std::string> &texts, float width) {
    ImGui::PushFont(context.fonts.small);
    float height = 0.0F;
    for (const std::string &text : texts) {
        height += ImGui::CalcTextSize(ui::wrapped(text, width).c_str(), nullptr, false, width).y +
                  ImGui::GetStyle().ItemSpacing.y;
    }
    ImGui::PopFont();
    return height;
}

} // namespace

void ImportDialog::drawSizes(Shell &context) const {
    std::size_t nodes = 0;
    for (const auto &shape : drawing_.shapes) {
        nodes += shape->nodes.size();
    }
    ui::field(context, "Contents", countText(drawing_.shapes.size(), "shape") + ", " + countText(nodes, "node"),
              kLabels);
    ui::field(context, "Size in file", extent(boundsOf(drawing_), 1.0), kLabels);
    ui::field(context, "This drawing", extent(boundsOf(start_ ? *start_ : *context.document.current()), 1.0), kLabels);
}

void ImportDialog::drawUnit(Shell &context) {
    ImGui::AlignTextToFramePadding();
    ui::muted(context, "1 unit in file =");
    ImGui::SameLine();
    double scale = scale_;
    if (ui::inputNumber(context, "dialog/importoptions/scale", scale, 76.0F) &&
        ui::checkPositive(context, "dialog/importoptions/scale", scale)) {
        scale_ = scale;
    }
    ImGui::SameLine();
    ui::muted(context, "drawing units");
    // Common units of drawings.
    const struct {
        const char *id, *label;
        double factor;
    } common[] = {{"same", "same", 1.0},
                  {"mm",
                   "mm\xe2\x86\x92"
                   "m",
                   0.001},
                  {"inch",
                   "in\xe2\x86\x92"
                   "mm",
                   25.4},
                  {"point",
                   "px\xe2\x86\x92"
                   "mm",
                   25.4 / 96.0}};
    {
        ui::Flow flow(context, ImGui::GetContentRegionAvail().x, context.px(6));
        for (const auto &choice : common) {
            flow.item(choice.id);
            if (ui::chip(context, std::string("dialog/importoptions/") + choice.id, choice.label,
                         scale_ == choice.factor)) {
                scale_ = choice.factor;
            }
        }
    }
    if (!contents_.unit.empty() || drawing_.unit != LengthUnit::None) {
        ui::field(context, "Unit in file",
                  contents_.unit.empty() ? std::string(pluralOf(drawing_.unit)) : contents_.unit, kLabels);
    }
    ui::field(context, "Imported size", extent(boundsOf(drawing_), scale_), kLabels);
}

/// Asks which layers are read, and where the names of its features are.
void ImportDialog::drawMap(Shell &context) {
    if (drawLayerChoice(context, contents_, options_.layer, kLabels, kChoices)) {
        readLayers();
    }
    if (contents_.degrees) {
        ui::rowLabel(context, "Coordinates", kLabels);
        static constexpr std::array<const char *, 2> kDegrees{"to metres", "keep degrees"};
        int choice = options_.degrees == DegreeRule::Local ? 0 : 1;
        if (ui::segmented(context, "dialog/importoptions/degrees", kDegrees, choice, kChoices)) {
            options_.degrees = choice == 0 ? DegreeRule::Local : DegreeRule::Keep;
            read();
        }
        ui::rowTooltip(context, "The map has longitudes and latitudes. Projected, distances from its middle are true; "
                                "in degrees, it is stretched from west to east.");
    }
    if (!contents_.properties.empty()) {
        std::vector<std::string> labels{"automatic"};
        labels.insert(labels.end(), contents_.properties.begin(), contents_.properties.end());
        ui::rowLabel(context, "Names from", kLabels);
        int choice = options_.nameProperty ? 1 + placeIn(contents_.properties, *options_.nameProperty) : 0;
        if (ui::combo(context, "dialog/importoptions/names", labels, choice, kChoices)) {
            options_.nameProperty = choice > 0 ? std::optional(labels[static_cast<std::size_t>(choice)]) : std::nullopt;
            read();
        }
        ui::rowTooltip(context, "The property of the features that names regions and boundaries; id also uses the "
                                "own ids of the features. Automatic: name, Name or NAME, else NAME_n of the finest "
                                "administrative level n.");
    }
}

/// Asks how lines and areas are joined, cut off and left out.
void ImportDialog::drawJoining(Shell &context) {
    ui::rowLabel(context, "Weld tolerance", kLabels);
    std::optional<double> tolerance = options_.weldTolerance;
    if (ui::inputOptional(context, "dialog/importoptions/weld", tolerance, arranges_ ? "auto" : "0", 76.0F, {},
                          drawing_.unit) &&
        ui::checkPositive(context, "dialog/importoptions/weld", tolerance.value_or(0.0), true)) {
        options_.weldTolerance = tolerance;
        read();
    }
    ui::tooltip(context, arranges_
                             ? "Join nodes and lines closer than this, in units of the file. Auto: 1e-6 of the "
                               "drawing's diagonal, less if that changes its area by over 0.1 %."
                             : "Join nodes and lines closer than this, in units of the file. 0: leave the drawing "
                               "as it is.");
    ImGui::SameLine();
    ui::muted(context, "in file");
    if (hasFeatures_) {
        ui::rowLabel(context, "Overlaps", kLabels);
        static constexpr std::array<const char *, 2> kRules{"later wins", "smaller wins"};
        int rule = options_.overlap == OverlapRule::Smaller ? 1 : 0;
        if (ui::segmented(context, "dialog/importoptions/overlap", kRules, rule, kChoices)) {
            options_.overlap = rule == 1 ? OverlapRule::Smaller : OverlapRule::Later;
            read();
        }
    }
    bool cuts = !options_.beyondPage;
    if (leavesPage_ && ui::checkbox(context, "dialog/importoptions/page", "Cut off at the page", cuts)) {
        options_.beyondPage = !cuts;
        read();
    }
    if (hasLines_ && ui::checkbox(context, "dialog/importoptions/lines", "Leave out lines", options_.dropLines)) {
        read();
    }
    if (hasStrokes_ &&
        ui::checkbox(context, "dialog/importoptions/strokes", "Mesh what the strokes paint", options_.strokeAreas)) {
        read();
    }
    if (whiteShapes_ > 0) {
        bool holes = options_.whiteHoles.value_or(true);
        if (ui::checkbox(context, "dialog/importoptions/white", "White shapes are holes", holes)) {
            options_.whiteHoles = holes;
            read();
        }
        ui::tooltip(context,
                    "White shapes that lie on others are holes in these. Otherwise they are merged with them.");
    }
    if (contents_.filledShapes > 1 || options_.shapeRegions) { // a switch that is on can be switched off
        if (ui::checkbox(context, "dialog/importoptions/regions", "Make every filled shape a region",
                         options_.shapeRegions)) {
            read();
        }
        ui::tooltip(context, "Each keeps its name, as far as no later shape covers it. Otherwise all are one region.");
    }
}

/// Draws a note; a click on one with a place goes there.
void ImportDialog::drawNote(Shell &context, const std::string &name, const std::string &text,
                            const std::optional<Vec2> &place) const {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ui::small(context, text, true);
    ui::mark(context, name);
    if (!place) {
        return;
    }
    const ImVec2 end{at.x + ImGui::GetContentRegionAvail().x, ImGui::GetItemRectMax().y};
    if (!ImGui::IsWindowHovered() || !ImGui::IsMouseHoveringRect(at, end)) {
        return;
    }
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    ImGui::GetWindowDrawList()->AddRectFilled({at.x - context.px(4), at.y}, end, fade(context.theme.hovered, 0.5),
                                              context.px(4));
    ui::tooltipOver(context, {at.x, at.y, end.x - at.x, end.y - at.y}, "Click to go there");
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        constexpr double kShown = 0.15; // of the drawing, in the height of the canvas
        context.view.goTo(scale_ * *place, context.platform.now());
        Camera &camera = context.view.camera;
        const double height = kShown * scale_ * boundsOf(drawing_).diagonal();
        if (height > 0.0) {
            camera.zoom =
                std::clamp(camera.viewport.height / height, std::min(camera.zoom, camera.maxZoom), camera.maxZoom);
        }
        context.animate();
    }
}

/// Shows why the file cannot be read with the options, or what reading it changed; what does not fit is scrolled.
void ImportDialog::drawReport(Shell &context) const {
    const float width = ImGui::GetContentRegionAvail().x;
    const std::vector<std::string> faults = textsOf(faults_);
    const std::vector<NoteGroup> groups = groupsOf(notes_);
    float height = heightOf(context, faults, width);
    for (const NoteGroup &group : groups) {
        height += heightOf(context, group.texts, width) + ImGui::GetFontSize() + 2.0F * ImGui::GetStyle().ItemSpacing.y;
    }
    if (height <= 0.0F) {
        return;
    }
    ImGui::BeginChild("report", {0, std::min(height, context.px(kMaxReport))}, false, ImGuiWindowFlags_NoNav);
    for (const std::string &fault : faults) {
        ui::faultText(context, fault);
    }
    std::size_t k = 0;
    for (const NoteGroup &group : groups) {
        ui::heading(context, std::string(group.title) + "  " + ui::count(group.texts.size()));
        ui::mark(context, std::string("dialog/importoptions/group/") + group.id);
        for (std::size_t i = 0; i < group.texts.size(); ++i) {
            drawNote(context, "dialog/importoptions/note/" + std::to_string(k++), group.texts[i], group.places[i]);
        }
    }
    ImGui::EndChild();
    ui::mark(context, "dialog/importoptions/report");
}

} // namespace forefront
