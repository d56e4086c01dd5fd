#include "core/engine/base/hash.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/mesh/element_words.hpp"

#include <imgui.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace forefront::shell {

namespace {

/// Lays out the cells of the status bar from left to right, with hairlines between them.
class Cells {
  public:
    Cells(Shell &context, const PixelRect &rect) : context_(context), rect_(rect), x_(rect.x) {}

    /// Adds a cell at least `minWidth` design pixels wide, so that changing digits do not move the next ones.
    void add(const std::string &name, const std::string &text, Colour colour, double minWidth = 0.0) {
        const double scale = static_cast<double>(context_.scale);
        const double pad = 10.0 * scale;
        const ImVec2 size = ImGui::CalcTextSize(text.c_str());
        const double width = std::max(static_cast<double>(size.x), minWidth * scale) + 2.0 * pad;
        ImDrawList &list = *ImGui::GetWindowDrawList();
        if (x_ > rect_.x) {
            list.AddLine({static_cast<float>(x_), static_cast<float>(rect_.y + 6.0 * scale)},
                         {static_cast<float>(x_), static_cast<float>(rect_.y + rect_.height - 6.0 * scale)},
                         context_.theme.line);
        }
        list.AddText({static_cast<float>(x_ + pad),
                      static_cast<float>(rect_.y + (rect_.height - static_cast<double>(size.y)) / 2.0)},
                     colour, text.c_str());
        last_ = {x_, rect_.y, width, rect_.height};
        ui::markRect(context_, "status/" + name, last_);
        x_ += width;
    }
    bool clicked(const char *name) const {
        ImGui::SetCursorScreenPos({static_cast<float>(last_.x), static_cast<float>(last_.y)});
        return ImGui::InvisibleButton(name, {static_cast<float>(last_.width), static_cast<float>(last_.height)});
    }
    double at() const { return x_; }

  private:
    Shell &context_;
    PixelRect rect_;
    PixelRect last_;
    double x_;
};

std::string pointerText(const View &view) {
    if (!view.pointer) {
        return "x \xe2\x80\x93   y \xe2\x80\x93";
    }
    const double step = view.camera.length(1.0);
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step))), 0, 9);
    return ui::format("x %.*f   y %.*f", decimals, view.pointer->x, decimals, view.pointer->y);
}

/// Rounds a predicted count to two digits, since further digits mean nothing and would flicker.
std::uint64_t roundedTo2(double count) {
    const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(count)) - 1.0));
    return static_cast<std::uint64_t>(std::round(count / unit) * unit);
}

/// Adds the figures of the mesh, and the predicted number of elements if that is more informative.
void addMesh(Cells &cells, Shell &context) {
    const Theme &theme = context.theme;
    const SessionSnapshot &run = context.run.now();
    const double predicted = context.preview->estimatedElements;
    if (run.quality.elements > 0) {
        cells.add("counts", elementsInShort(run.quality) + "   " + ui::count(run.quality.nodes) + " \xe2\x97\x8f",
                  theme.text, 100);
        cells.clicked("counts");
        const bool counted = run.quality.kinds != MeshQuality{}.kinds; // not while the mesh is being made
        ui::tooltip(context, counted
                                 ? elementsInWords(run.quality.kinds) + ", " + ui::count(run.quality.nodes) + " nodes"
                                 : "Triangles and nodes");
        cells.add(
            "quality",
            ui::format("\xce\xb1 %.3f   min\xe2\x88\xa0 %.1f\xc2\xb0", run.quality.alphaMean, run.quality.minAngle),
            theme.text, 120);
        cells.clicked("quality");
        ui::tooltip(context, run.complete && run.advance < run.known
                                 ? "Mean shape factor and smallest angle so far; the mesh is improved at the end"
                                 : "Mean shape factor and smallest angle");
    }
    const bool differs = run.quality.elements == 0 || context.run.preview() || context.run.outOfDate();
    if (predicted > 0.0 && differs) {
        cells.add("estimate", "about " + ui::count(roundedTo2(predicted)) + " \xe2\x96\xb3", theme.muted, 100);
        cells.clicked("estimate");
        ui::tooltip(context, "Predicted number of triangles, within about 10 %");
    }
    if (run.complete && run.meshHash != 0 && run.advance == run.known) {
        cells.add("hash", "hash " + toHex(run.meshHash).substr(0, 8), theme.muted, 92);
        if (cells.clicked("hash")) {
            context.platform.setClipboard(toHex(run.meshHash));
            context.log.announce("Copied mesh hash " + toHex(run.meshHash));
        }
        ui::tooltip(context, "Meshes with the same hash are identical bit for bit. Click to copy.");
    }
}

void addFaults(Cells &cells, Shell &context) {
    const std::size_t faults = context.preview->faults.size();
    if (faults > 0) {
        cells.add("faults", std::string(icon::kWarning) + "  " + std::to_string(faults), context.theme.warn);
        if (cells.clicked("faults")) {
            context.actions.run("view.firstFault", context);
        }
        ui::tooltip(context, toString(context.preview->faults.front()) + "\nClick to go there");
    }
}

/// Draws the hint of the current tool at the right if there is room, with the hint on typing if that fits too.
void drawHint(const Cells &cells, const Shell &context, const PixelRect &rect) {
    std::string hint = context.tools.current().statusText(context);
    const std::string typing = context.tools.current().typingHint(context);
    if (!hint.empty() && !typing.empty()) {
        const std::string both = hint + ". " + typing;
        const double room = rect.x + rect.width - cells.at() - 8.0 - static_cast<double>(context.px(12));
        hint = static_cast<double>(ImGui::CalcTextSize(both.c_str()).x) < room ? both : hint;
    }
    if (!hint.empty()) {
        const ImVec2 size = ImGui::CalcTextSize(hint.c_str());
        const double x = rect.x + rect.width - static_cast<double>(size.x) - 12.0 * static_cast<double>(context.scale);
        if (x > cells.at() + 8.0) {
            ImGui::GetWindowDrawList()->AddText(
                {static_cast<float>(x), static_cast<float>(rect.y + (rect.height - static_cast<double>(size.y)) / 2.0)},
                context.theme.muted, hint.c_str());
        }
    }
}

/// Returns the menu of the status bar.
std::vector<ContextGroup> statusMenu(const Shell &context) {
    const SessionSnapshot &run = context.run.now();
    ContextGroup copies;
    if (run.quality.elements > 0) {
        copies.push_back(copyCommand("status/counts", "Copy numbers of elements and nodes",
                                     std::to_string(run.quality.elements) + '\t' + std::to_string(run.quality.nodes)));
        copies.push_back(copyCommand("status/quality", "Copy shape factor and smallest angle",
                                     ui::format("%.6g\t%.6g", run.quality.alphaMean, run.quality.minAngle)));
    }
    if (run.complete && run.meshHash != 0) {
        copies.push_back(copyCommand("status/hash", "Copy mesh hash", toHex(run.meshHash)));
    }
    return {std::move(copies), actionsOf({"view.firstFault"}),
            actionsOf({"view.panels", "view.rulers", "edit.preferences"})};
}

} // namespace

void drawStatusBar(Shell &context, const PixelRect &rect) {
    if (rect.height < 1.0) {
        return;
    }
    beginRegion("##status", rect, context.theme.panel, 0, 0);
    ImGui::GetWindowDrawList()->AddLine({0, static_cast<float>(rect.y)},
                                        {static_cast<float>(rect.width), static_cast<float>(rect.y)},
                                        context.theme.line);
    ImGui::PushFont(context.fonts.small);
    Cells cells(context, rect);
    cells.add("pointer", pointerText(context.view), context.theme.muted, 150);
    addMesh(cells, context);
    addFaults(cells, context);
    drawHint(cells, context, rect);
    ImGui::PopFont();
    if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
        context.menu.open(statusMenu(context));
    }
    ImGui::End();
}

} // namespace forefront::shell
