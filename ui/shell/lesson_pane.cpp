#include "core/teaching/lesson/glossary.hpp"
#include "ui/lessons/kept_answers.hpp"
#include "ui/lessons/lesson_answers.hpp"
#include "ui/lessons/lesson_list.hpp"
#include "ui/lessons/lesson_player.hpp"
#include "ui/lessons/page_check.hpp"
#include "ui/shell/cut_edges.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/widgets/rich_text.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace forefront::shell {

namespace {

using Reply = OpenLesson::Reply;
using ui::PictureSource;

/// What the texts of a page have shown so far.
struct PageParts {
    std::size_t links = 0, images = 0;
    std::optional<std::size_t> next; ///< the page of a link that was clicked
};

/// Returns how far a lesson has been read: "page 3 of 8", or how many of its questions were answered once it is closed
/// at its first page.
std::string progressText(const Shell &context, const LessonEntry &entry) {
    const auto known = context.settings.lessons.find(entry.id);
    const std::size_t page = known == context.settings.lessons.end() ? 0 : known->second.page;
    const std::size_t pages = entry.lesson->pages.size(), questions = questionsOf(*entry.lesson);
    const auto [answered, shown] = countKnown(context, entry.id);
    if (questions > 0 && answered >= questions) {
        return ui::format("%s  all %zu questions answered", icon::kCheck, questions);
    }
    if (page > 0 && answered + shown < questions) {
        return ui::format("page %zu of %zu", std::min(page + 1, pages), pages);
    }
    return answered + shown == 0 ? ui::format("%zu pages", pages)
                                 : ui::format("%zu of %zu questions answered", answered, questions) +
                                       (shown > 0 ? ui::format(", %zu shown", shown) : std::string());
}

/// Returns the key of an answer, counted from 0: "Alt 1"; nothing beyond the ninth.
std::string keyText(std::size_t index) {
    return index < 9 ? "Alt " + std::to_string(index + 1) : std::string();
}

/// Returns the key of a lesson, counted from 0: "Alt 1", "Alt 0" for the tenth, "Alt Shift 1" for the eleventh; nothing
/// beyond the nineteenth.
std::string keyOfLesson(std::size_t index) {
    return index < 9    ? keyText(index)
           : index == 9 ? std::string("Alt 0")
           : index < 19 ? "Alt Shift " + std::to_string(index - 9)
                        : std::string();
}

/// Draws a row of wrapped text that can be clicked, with a mark to its left. `formulas`: the text may have some.
bool textRow(Shell &context, const std::string &name, const char *mark, Colour markColour, const std::string &text,
             bool formulas) {
    const float left = context.px(48), pad = context.px(5);
    const float width = ImGui::GetContentRegionAvail().x;
    const std::optional<ui::RichText> rich =
        formulas ? std::optional<ui::RichText>(std::in_place, context, text, width - left - pad, MarkupKind::Formulas)
                 : std::nullopt;
    const std::string lines = rich ? std::string() : ui::wrapped(text, width - left - pad);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = (rich ? rich->height() : ImGui::CalcTextSize(lines.c_str()).y) + 2.0F * pad;
    const bool pressed = ui::hitArea(name.c_str(), width, height);
    ui::mark(context, name);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + width, at.y + height},
                       ImGui::IsItemHovered() ? context.theme.hovered : context.theme.raised, context.px(5));
    list.AddText({at.x + context.px(8), at.y + pad}, markColour, mark);
    if (rich) {
        std::size_t none = 0;
        rich->draw(context, {at.x + left, at.y + pad}, context.theme.text, name, none, none);
    } else {
        list.AddText({at.x + left, at.y + pad}, context.theme.text, lines.c_str());
    }
    return pressed;
}

/// Draws the line below a lesson of the list: how far it was read, its answers, and its key at the right.
void drawProgress(Shell &context, const LessonEntry &entry, const std::string &keys) {
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + context.px(48));
    ui::small(context, progressText(context, entry));
    ui::mark(context, "lessons/" + entry.id + "/progress");
    ImGui::PushFont(context.fonts.small);
    const float width = ImGui::CalcTextSize(keys.c_str()).x;
    ImGui::PopFont();
    ImGui::SameLine(std::max(ImGui::GetContentRegionMax().x - width - context.px(5), ImGui::GetCursorPosX()));
    ui::small(context, keys);
    if (knownAnswers(context, entry.id) == nullptr) {
        return;
    }
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + context.px(48));
    if (ui::link(context, "lessons/" + entry.id + "/save", "Save answers\xe2\x80\xa6")) {
        saveAnswersTo(context, entry.id);
    }
}

void drawList(Shell &context) {
    listLessons(context);
    ui::wrappedText(
        "Lessons about the advancing front; each page opens the run it describes. Leave one at any time; it opens "
        "again at the same page. Each page reloads its drawing: to keep your changes, save the drawing as a file.");
    ImGui::Dummy({0, context.px(4)});
    if (context.lessons.list.empty()) {
        ui::small(context, "No lessons found; set FOREFRONT_ASSETS to the folder that holds lessons/.", true);
        ui::mark(context, "lessons/empty");
    }
    ImGui::BeginChild("list", {0, 0}, false, ImGuiWindowFlags_NoNav);
    const bool appears = ImGui::IsWindowAppearing();
    std::optional<LessonEntry> chosen;
    for (std::size_t k = 0; k < context.lessons.list.size(); ++k) {
        const LessonEntry &entry = context.lessons.list[k];
        if (textRow(context, "lessons/" + entry.id, std::to_string(k + 1).c_str(), context.theme.muted,
                    entry.lesson->title, false)) {
            chosen = entry;
        }
        ui::tooltip(context, entry.lesson->about);
        if (appears && entry.id == context.lessons.last) {
            ImGui::SetScrollHereY();
        }
        drawProgress(context, entry, keyOfLesson(k));
    }
    ImGui::EndChild();
    if (chosen) {
        openLesson(context, *chosen);
    }
}

/// Draws a text of a page with its formulas, images and links. Of a link that was clicked, its page becomes
/// `PageParts::next`.
void drawText(Shell &context, const std::string &text, PageParts &parts) {
    const PictureSource pictures = [&context](const std::string &file) { return context.pageImages.find(file); };
    const ui::RichText rich(context, text, ImGui::GetContentRegionAvail().x, MarkupKind::All, pictures);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const std::optional<std::string> target =
        rich.draw(context, corner, context.theme.text, "lesson", parts.links, parts.images);
    if (target) {
        parts.next = pageOfTarget(*context.lessons.open->entry.lesson, *target);
    }
    ImGui::SetCursorScreenPos(corner);
    ImGui::Dummy({ImGui::GetContentRegionAvail().x, rich.height()});
}

/// A verdict on the last answer, as the pane shows it.
struct ShownVerdict {
    std::string text;
    Colour colour;
    const char *widget;
};

ShownVerdict verdictOf(const Theme &theme, Reply reply) {
    switch (reply) {
    case Reply::Right:
        return {std::string(icon::kCheck) + "  Right", theme.good, "lesson/right"};
    case Reply::Shown:
        return {"Shown, not answered", theme.muted, "lesson/shown"};
    default:
        return {std::string(icon::kCross) + "  Not yet", theme.bad, "lesson/wrong"};
    }
}

void drawReply(Shell &context, const OpenLesson &open, const LessonQuestion &question, PageParts &parts) {
    if (open.reply == Reply::None) {
        if (!open.before.empty()) {
            ui::small(context, open.before);
            ui::mark(context, "lesson/before");
        }
        return;
    }
    if (!open.complaint.empty()) {
        ui::wrappedText(open.complaint);
        ui::mark(context, "lesson/complaint");
        return;
    }
    const ShownVerdict verdict = verdictOf(context.theme, open.reply);
    ImGui::PushStyleColor(ImGuiCol_Text, verdict.colour);
    ImGui::TextUnformatted(verdict.text.c_str());
    ImGui::PopStyleColor();
    ui::mark(context, verdict.widget);
    const std::string &more = open.isSolved() ? question.why : open.hint;
    if (!more.empty()) {
        drawText(context, withValues(more, questionState(context)), parts);
        ui::mark(context, "lesson/why");
    }
}

/// Lets the pane scroll until what was drawn from `top` on is in sight, its top above all.
void scrollToReply(OpenLesson &open, float top) {
    if (open.framesToReply == 0) {
        return;
    }
    --open.framesToReply;
    const float bottom = ImGui::GetCursorPosY(), seen = ImGui::GetScrollY(), room = ImGui::GetWindowHeight();
    if (bottom > seen + room) {
        ImGui::SetScrollY(std::min(bottom - room, top));
    } else if (top < seen) {
        ImGui::SetScrollY(top);
    }
}

void drawChoices(Shell &context, const OpenLesson &open, const LessonChoices &choices) {
    std::optional<std::size_t> chosen;
    for (std::size_t k = 0; k < choices.list.size(); ++k) {
        const bool picked = open.picked == k;
        const Colour colour = !picked                      ? context.theme.muted
                              : open.reply == Reply::Right ? context.theme.good
                                                           : context.theme.bad;
        const std::string mark = !picked ? keyText(k) : open.reply == Reply::Right ? icon::kCheck : icon::kCross;
        if (textRow(context, "lesson/choice/" + std::to_string(k), mark.c_str(), colour,
                    withValues(choices.list[k].text, questionState(context)), true)) {
            chosen = k;
        }
    }
    if (chosen) {
        answerChoice(context, *chosen);
    }
}

void drawNumber(Shell &context, OpenLesson &open) {
    const bool entered = ui::inputText(context, "lesson/number", open.typed, "number (Alt 0)", 120.0F, true,
                                       std::exchange(open.focus, false));
    ImGui::SameLine();
    if (ui::button(context, "lesson/check", "Check") || entered) {
        answerNumber(context);
        open.focus = entered && open.reply == Reply::Wrong; // for another try
    }
}

/// Says that the run shown is not that of the page, if so. Returns true if the page is shown anew.
bool drawOtherRun(Shell &context, const OpenLesson &open) {
    if (showsOwnRun(context) || lessonIsElsewhere(context) || !open.settled || open.isSolved() ||
        !asksAboutRun(*open.now().question)) {
        return false;
    }
    const bool task = std::holds_alternative<LessonTask>(open.now().question->answer);
    ui::wrappedText(std::string("This is not the mesh of the page: the drawing or its options have changed. The ") +
                    (task ? "task is about the page's own, so nothing you do here answers it."
                          : "question is about the page's own."));
    ui::mark(context, "lesson/changed");
    const bool back = ui::link(context, "lesson/bringback", "Bring back the drawing of the page");
    if (back) {
        bringBackDrawing(context);
    }
    return back;
}

void drawQuestion(Shell &context, OpenLesson &open, PageParts &parts) {
    const LessonQuestion &question = *open.now().question;
    ImGui::Dummy({0, context.px(2)});
    ui::heading(context, std::holds_alternative<LessonTask>(question.answer) ? "Try it" : "Question");
    drawText(context, withValues(question.text, questionState(context)), parts);
    ui::mark(context, "lesson/question");
    if (const auto *choices = std::get_if<LessonChoices>(&question.answer)) {
        drawChoices(context, open, *choices);
    } else if (std::holds_alternative<LessonNumber>(question.answer)) {
        drawNumber(context, open);
    }
    if (drawOtherRun(context, open)) {
        return;
    }
    const float top = ImGui::GetCursorPosY();
    drawReply(context, open, question, parts);
    scrollToReply(open, top);
    if (question.show && !open.isSolved() && ui::link(context, "lesson/show", "Show me (Alt H)")) {
        showAnswer(context);
    }
}

/// Draws the links to what can be done with the answers, and with the random numbers of the lesson.
void drawAnswerLinks(Shell &context, const OpenLesson &open) {
    if (hasAnswersToSave(context)) {
        if (ui::link(context, "lesson/save", "Save answers\xe2\x80\xa6")) {
            saveAnswers(context);
        }
        ImGui::SameLine(0.0F, context.px(16));
        if (ui::link(context, "lesson/forget", "Forget answers")) {
            forgetAnswers(context);
            return;
        }
        ui::tooltip(context, "Begin the lesson anew, without the answers given so far");
    }
    const std::uint64_t seed = open.entry.lesson->seed;
    if (seed == 0 || !open.now().random) {
        return;
    }
    if (ui::link(context, "lesson/numbers", "Other numbers")) {
        chooseOtherNumbers(context);
        return;
    }
    ui::tooltip(context, "The numbers of this lesson are drawn at random. Choose others, which have other answers.");
    ImGui::SameLine();
    ui::small(context, "seed " + std::to_string(seed));
}

/// Draws links to the terms that a page mentions.
void drawTerms(Shell &context, const LessonPage &page) {
    std::string text = page.title;
    for (const std::string &paragraph : page.paragraphs) {
        text += ' ' + plainText(paragraph);
    }
    const std::vector<const GlossaryTerm *> terms = termsIn(text);
    if (terms.empty()) {
        return;
    }
    ImGui::Dummy({0, context.px(2)});
    ui::heading(context, "Glossary");
    for (const GlossaryTerm *term : terms) {
        if (ui::link(context, "lesson/term/" + std::string(term->id), term->name)) {
            context.actions.run("glossary." + std::string(term->id), context);
        }
    }
}

void drawPage(Shell &context, OpenLesson &open) {
    const std::shared_ptr<const Lesson> shown = open.entry.lesson; // other numbers may replace it below
    const LessonPage &page = open.now();
    ImGui::PushFont(context.fonts.page);
    ui::wrappedText(page.title);
    ImGui::PopFont();
    ui::mark(context, "lesson/title");
    PageParts parts;
    for (std::size_t k = 0; k < page.paragraphs.size(); ++k) {
        drawText(context, withValues(page.paragraphs[k], pageState(context)), parts);
        ui::mark(context, "lesson/text/" + std::to_string(k));
        ImGui::Dummy({0, context.px(1)});
    }
    if (page.question) {
        drawQuestion(context, open, parts);
    }
    drawAnswerLinks(context, open);
    drawTerms(context, page);
    if (parts.next && context.lessons.open) {
        goToPage(context, *parts.next);
    }
}

void drawFooter(Shell &context, const OpenLesson &open) {
    const std::size_t pages = open.entry.lesson->pages.size();
    const bool last = open.page + 1 == pages;
    if (ui::button(context, "lesson/previous", "Previous", ui::ButtonKind::Plain, open.page > 0)) {
        context.actions.run("lesson.previous", context);
        return;
    }
    ui::tooltip(context, "Page Up");
    const std::string place = ui::format("%zu of %zu", open.page + 1, pages);
    ImGui::SameLine((ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(place.c_str()).x) / 2);
    ImGui::AlignTextToFramePadding();
    ui::muted(context, place);
    ui::mark(context, "lesson/place");
    ImGui::SameLine(ImGui::GetContentRegionMax().x - context.px(84));
    if (ui::button(context, "lesson/next", last ? "Finish" : "Next", ui::ButtonKind::Primary, true, 84.0F)) {
        context.actions.run("lesson.next", context);
        return;
    }
    ui::tooltip(context, last ? "Page Down: back to the list of lessons" : "Page Down");
}

void drawOpen(Shell &context) {
    const std::string title = context.lessons.open->entry.lesson->title;
    if (ui::link(context, "lesson/list", "All lessons")) {
        closeLesson(context);
        return;
    }
    ImGui::SameLine();
    ImGui::PushFont(context.fonts.small);
    const std::string shown = ui::oneLine(title, ImGui::GetContentRegionAvail().x);
    ImGui::PopFont();
    ui::small(context, shown);
    if (shown != title) {
        ui::tooltip(context, title);
    }
    const float footer = context.px(40);
    ImGui::BeginChild("page", {0, ImGui::GetContentRegionAvail().y - footer}, false, ImGuiWindowFlags_NoNav);
    if (std::exchange(context.lessons.open->fresh, false)) {
        ImGui::SetScrollY(0.0F);
    }
    drawPage(context, *context.lessons.open);
    shadeCutEdges(context);
    ImGui::EndChild();
    ImGui::Dummy({0, context.px(2)});
    drawFooter(context, *context.lessons.open);
}

} // namespace

void drawLessons(Shell &context, const PixelRect &rect) {
    revealHighlights(context);
    if (rect.width < 1.0 || rect.height < 1.0) {
        return;
    }
    followLesson(context);
    if (context.pageImages.follow(context.lessons.open ? context.lessons.open->entry.lesson : nullptr)) {
        context.animate();
    }
    beginRegion("##lessons", rect, context.theme.panel, context.px(12), context.px(8));
    const float edge = static_cast<float>(rect.x + rect.width) - 1.0F;
    ImGui::GetWindowDrawList()->AddLine({edge, static_cast<float>(rect.y)},
                                        {edge, static_cast<float>(rect.y + rect.height)}, context.theme.line);
    ui::heading(context, "Lessons");
    ImGui::SameLine(ImGui::GetContentRegionMax().x - context.px(22));
    const bool hide = ui::iconButton(context, "lessons/hide", icon::kCross, "Hide the lessons", false, true, 22.0F);
    context.lessons.open ? drawOpen(context) : drawList(context);
    ImGui::End();
    if (context.lessons.open) {
        drawHighlights(context);
        checkPage(context);
    }
    if (hide) {
        context.actions.run("help.lessons", context);
    }
}

} // namespace forefront::shell
