#include "ui/dialogs/glossary_dialog.hpp"

#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>

namespace forefront {

namespace {

constexpr float kListWidth = 220.0F, kFigureHeight = 210.0F; ///< design pixels

Colour colourOf(const Theme &theme, FigureInk ink) {
    switch (ink) {
    case FigureInk::Edge:
        return theme.mesh;
    case FigureInk::Boundary:
        return theme.boundary;
    case FigureInk::Front:
        return theme.front;
    case FigureInk::Base:
        return theme.base;
    case FigureInk::Candidate:
        return theme.candidate;
    case FigureInk::Accepted:
        return theme.accepted;
    case FigureInk::Rejected:
        return theme.bad;
    case FigureInk::Cell:
        return theme.cell;
    case FigureInk::Text:
        break;
    }
    return theme.text;
}

double widthOf(FigureInk ink) {
    return ink == FigureInk::Base ? 3.5 : ink == FigureInk::Front || ink == FigureInk::Boundary ? 2.5 : 1.5;
}

/// Draws a figure to fill a rectangle of the window.
void drawFigure(Shell &context, const Figure &figure, const PixelRect &rect) {
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const ImVec2 corner{static_cast<float>(rect.x), static_cast<float>(rect.y)};
    const ImVec2 end{corner.x + static_cast<float>(rect.width), corner.y + static_cast<float>(rect.height)};
    list.AddRectFilled(corner, end, context.theme.canvas, context.px(6));
    Camera camera;
    camera.viewport = rect;
    camera.fit(figure.bounds(), rect, 0.12);
    CanvasPainter painter(list, camera, static_cast<double>(context.scale));
    for (const auto &[a, b, c] : figure.elements) {
        painter.triangle(a, b, c, context.theme.element);
    }
    for (const FigureLine &line : figure.lines) {
        const Colour colour = colourOf(context.theme, line.ink);
        line.a == line.b ? painter.dot(line.a, 4.5, colour) : painter.line(line.a, line.b, colour, widthOf(line.ink));
    }
    for (const FigureLabel &label : figure.labels) {
        painter.text(label.at, label.text, colourOf(context.theme, label.ink));
    }
}

} // namespace

GlossaryDialog::GlossaryDialog(std::string_view term) : term_(glossaryTerm(term)) {
    term_ = term_ != nullptr ? term_ : &glossary().front();
}

void GlossaryDialog::drawList(Shell &context) {
    const GlossaryTerm *const before = term_;
    const std::span<const GlossaryTerm> all = glossary();
    const bool up = imgui::keyPressed(key::kUp), down = imgui::keyPressed(key::kDown);
    if (up && term_ != &all.front()) {
        --term_;
    } else if (down && term_ != &all.back()) {
        ++term_;
    }
    for (const GlossaryTerm &term : all) {
        if (ui::selectable(context, "dialog/glossary/list/" + std::string(term.id), term.name, &term == term_)) {
            term_ = &term;
        }
        if (&term == term_ && term_ != before) {
            ImGui::SetScrollHereY();
            context.animate();
        }
    }
}

void GlossaryDialog::drawTerm(Shell &context) {
    ImGui::PushFont(context.fonts.page);
    ui::wrappedText(term_->name);
    ImGui::PopFont();
    ui::mark(context, "dialog/glossary/term/" + std::string(term_->id));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, context.px(static_cast<double>(kFigureHeight))};
    ImGui::Dummy(size);
    ui::mark(context, "dialog/glossary/figure");
    drawFigure(context, term_->figure(),
               {static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(size.x),
                static_cast<double>(size.y)});
    ImGui::Dummy({0, context.px(4)});
    ui::wrappedText(term_->text);
    ImGui::Dummy({0, context.px(4)});
    ui::muted(context, "See also");
    const GlossaryTerm *chosen = nullptr;
    for (const std::string_view id : term_->related) {
        const GlossaryTerm *const other = glossaryTerm(id);
        if (ui::link(context, "dialog/glossary/related/" + std::string(id), other->name)) {
            chosen = other;
        }
    }
    term_ = chosen != nullptr ? chosen : term_;
}

bool GlossaryDialog::draw(Shell &context) {
    ImGui::BeginChild("terms", {context.px(static_cast<double>(kListWidth)), 0.0F}, false, ImGuiWindowFlags_NoNav);
    drawList(context);
    ImGui::EndChild();
    ImGui::SameLine(0, context.px(18));
    ImGui::BeginChild("term", {0.0F, 0.0F}, false, ImGuiWindowFlags_NoNav);
    drawTerm(context);
    ImGui::EndChild();
    return true;
}

} // namespace forefront
