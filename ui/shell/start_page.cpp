#include "ui/shell/start_page.hpp"

#include "ui/dialogs/file_commands.hpp"
#include "ui/lessons/lesson_list.hpp"
#include "ui/lessons/lesson_player.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/popup_style.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront::shell {

namespace {

constexpr double kPageWidth = 720.0;                     // design pixels
constexpr double kWidePage = 700.0, kWideMargin = 24.0;  // of a page with wide margins, design pixels
constexpr double kNarrowMargin = 8.0, kNarrowPad = 16.0; // of a narrower one
constexpr std::size_t kPageCards = 3, kPageSamples = 6;

/// Returns true while there is nothing else to see on the canvas, and nothing is being made.
bool nothingYet(const Shell &context) {
    const Document &document = *context.document.current();
    return document.shapes.empty() && !document.picture && !context.run.showsFile() && !context.lessons.open;
}

/// Returns the cards of unsaved drawings, then of recent files that are still there.
std::vector<DrawingCards::Card> continueCards(const std::vector<UnsavedDrawing> &unsaved,
                                              const std::vector<std::string> &files) {
    std::vector<DrawingCards::Card> cards;
    const std::size_t shown = std::min(unsaved.size(), kPageCards);
    for (std::size_t k = 0; k < shown; ++k) {
        const UnsavedDrawing &drawing = unsaved[k];
        cards.push_back({drawing.title, "Unsaved: " + drawing.about, drawing.journal, drawing.text});
    }
    const std::size_t room = shown > 0 ? 2 * kPageCards : kPageCards;
    for (const std::string &file : files) {
        const std::filesystem::path path(file);
        std::error_code ignored;
        if (cards.size() < room && std::filesystem::is_regular_file(path, ignored)) {
            cards.push_back({path.stem().string(), file, path});
        }
    }
    return cards;
}

void drawButtons(Shell &context) {
    const struct {
        const char *name, *label;
        ui::ButtonKind kind;
        const char *action;
    } buttons[] = {{"start/new", "New  R", ui::ButtonKind::Primary, "tool.rectangle"},
                   {"start/open", "Open\xe2\x80\xa6", ui::ButtonKind::Plain, "file.open"},
                   {"start/trace", "Trace a picture\xe2\x80\xa6", ui::ButtonKind::Plain, "file.addPicture"},
                   {"start/import", "Import\xe2\x80\xa6", ui::ButtonKind::Plain, "file.import"}};
    constexpr float kGap = 8.0F, kWidest = 160.0F, kNarrowest = 124.0F; // design pixels
    const float room = ImGui::GetContentRegionAvail().x / context.scale;
    const bool oneRow = (room - 3.0F * kGap) / 4.0F >= kNarrowest;
    const float width = std::min(kWidest, oneRow ? (room - 3.0F * kGap) / 4.0F : (room - kGap) / 2.0F);
    std::size_t drawn = 0;
    for (const auto &button : buttons) {
        if (drawn % (oneRow ? 4 : 2) != 0) {
            ImGui::SameLine(0, context.px(kGap));
        }
        if (ui::button(context, button.name, button.label, button.kind, true, width)) {
            context.actions.run(button.action, context);
        }
        ++drawn;
    }
}

void drawLessonLinks(Shell &context) {
    listLessons(context);
    if (context.lessons.list.empty()) {
        return;
    }
    ImGui::Dummy({0, context.px(4)});
    ui::heading(context, "Learn");
    std::vector<std::string> texts;
    float widest = 0.0F;
    for (const LessonEntry &entry : context.lessons.list) {
        texts.push_back(std::to_string(texts.size() + 1) + "  " + entry.lesson->title);
        widest = std::max(widest, ImGui::CalcTextSize(texts.back().c_str()).x);
    }
    // As many columns as have room for the longest title, so that the list is in sight without scrolling.
    const float room = ImGui::GetContentRegionAvail().x, left = ImGui::GetCursorPosX();
    const std::size_t columns = 3.0F * (widest + context.px(12)) <= room ? 3 : 2;
    const LessonEntry *chosen = nullptr;
    for (std::size_t k = 0; k < texts.size(); ++k) {
        const LessonEntry &entry = context.lessons.list[k];
        if (k % columns > 0) {
            ImGui::SameLine(left + static_cast<float>(k % columns) / static_cast<float>(columns) * room);
        }
        if (ui::link(context, "start/lesson/" + entry.id, texts[k])) {
            chosen = &entry;
        }
        ui::tooltip(context, entry.lesson->about);
    }
    if (chosen != nullptr) {
        openLesson(context, LessonEntry(*chosen));
    }
}

} // namespace

bool showsStartPage(const Shell &context) {
    return context.plates.start && nothingYet(context) && std::string_view(context.tools.current().id()) == "select" &&
           !context.task.busy();
}

void StartPage::drawCards(Shell &context) {
    if (!samples_) {
        std::vector<DrawingCards::Card> cards = sampleCards();
        cards.resize(std::min(cards.size(), kPageSamples));
        samples_ = std::make_unique<DrawingCards>(context.background, std::move(cards));
        findSamples(context);
    }
    if (!recent_ || recentFiles_ != context.settings.recentFiles || unsaved_ != context.unsaved.size()) {
        recentFiles_ = context.settings.recentFiles;
        unsaved_ = context.unsaved.size();
        recent_ = std::make_unique<DrawingCards>(context.background, continueCards(context.unsaved, recentFiles_));
    }
    std::filesystem::path chosen;
    if (!recent_->all().empty()) {
        ImGui::Dummy({0, context.px(4)});
        ui::heading(context, "Continue");
        if (const std::optional<std::size_t> card = recent_->draw(context, "start/recent/", kPageCards)) {
            chosen = recent_->all()[*card].path;
        }
    }
    if (!samples_->all().empty()) {
        ImGui::Dummy({0, context.px(4)});
        ui::heading(context, "Samples");
        if (const std::optional<std::size_t> card = samples_->draw(context, "start/sample/", kPageCards)) {
            chosen = samples_->all()[*card].path;
        }
    }
    const auto unsaved = std::find_if(context.unsaved.begin(), context.unsaved.end(),
                                      [&chosen](const UnsavedDrawing &each) { return each.journal == chosen; });
    if (unsaved != context.unsaved.end()) {
        const UnsavedDrawing drawing = *unsaved;
        drawing.open(context);
    } else if (!chosen.empty()) {
        openDocument(context, chosen);
    }
}

void StartPage::drawContent(Shell &context) {
    ImGui::PushFont(context.fonts.title);
    ImGui::TextUnformatted("Start a drawing");
    ImGui::PopFont();
    ImGui::Dummy({0, context.px(2)});
    drawButtons(context);
    drawCards(context);
    drawLessonLinks(context);
}

void StartPage::draw(Shell &context, const PixelRect &canvas) {
    if (!context.plates.start) {
        return;
    }
    if (!nothingYet(context)) {
        context.plates.start = false;
        samples_.reset();
        recent_.reset();
        return;
    }
    const double scale = static_cast<double>(context.scale);
    const bool wide = canvas.width >= kWidePage * scale;
    const double margin = (wide ? kWideMargin : kNarrowMargin) * scale, pad = wide ? kWideMargin : kNarrowPad;
    const double width = std::min((kPageWidth + 2.0 * pad) * scale, canvas.width - 2.0 * margin);
    const double height = canvas.height - 2.0 * margin;
    if (!showsStartPage(context) || width < 1.0 || height < 1.0) {
        return;
    }
    ImGui::SetNextWindowPos({static_cast<float>(canvas.centre().x), static_cast<float>(canvas.centre().y)},
                            ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSizeConstraints({static_cast<float>(width), 0.0F},
                                        {static_cast<float>(width), static_cast<float>(height)});
    const ui::PopupStyle style(context, pad, wide ? 20.0 : kNarrowPad, 8);
    ImGui::Begin("##start", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    drawContent(context);
    ui::markWindow(context, "start");
    ImGui::End();
}

} // namespace forefront::shell
