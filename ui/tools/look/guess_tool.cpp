#include "ui/tools/look/guess_tool.hpp"

#include "core/teaching/moment/moment.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <utility>

namespace forefront {

const char *GuessTool::icon() const {
    return icon::kGuess;
}

bool GuessTool::asks(const Shell &context) {
    const Moment moment = momentOf(context.run.now());
    return moment && moment.cursor < moment.advance->events.size() && !moment.idealKnown;
}

bool GuessTool::reviewed(const Shell &context) const {
    const Moment moment = momentOf(context.run.now());
    return moment && context.run.now().shownRun == run_ && moment.advance->advance == advance_;
}

/// Shows the base of the next advance, but not its candidates or result. An advance that has begun is left, whether it
/// was guessed or not.
void GuessTool::nextBase(Shell &context) {
    if (!context.run.hasRun() || context.run.showsFile()) {
        return;
    }
    const SessionSnapshot &run = context.run.now();
    const Moment moment = momentOf(run);
    if (moment && moment.cursor < moment.advance->events.size()) {
        context.run.step(Granularity::Advance, 1);
    } else if (run.frontDone()) {
        context.run.seek(0);
    }
    context.run.step(Granularity::Event, 1);
}

void GuessTool::startAgain() {
    guesses_ = points_ = 0;
    run_ = advance_ = 0;
}

void GuessTool::activate(Shell &context) {
    startAgain();
    const SessionSnapshot &run = context.run.now();
    const bool atEnd = context.run.hasRun() && !context.run.showsFile() && run.frontDone();
    endedRun_ = atEnd ? run.shownRun : 0;
    for (const char *layer : {"front", "candidates"}) {
        showLayer(context.layers, layer, true);
    }
    followed_ = std::exchange(context.view.following, true); // a base of few pixels leaves nothing to guess
    if (!asks(context)) {
        nextBase(context);
    }
}

void GuessTool::deactivate(Shell &context) {
    context.view.following = context.view.following && followed_;
    const std::uint64_t run = std::exchange(endedRun_, 0);
    if (run != 0 && context.run.hasRun() && !context.run.showsFile() && context.run.now().shownRun == run) {
        context.run.seekEnd();
    }
}

void GuessTool::guess(Vec2 place, Shell &context) {
    const SessionSnapshot &run = context.run.now();
    const Moment moment = momentOf(run);
    review_ = reviewGuess(*moment.advance, place);
    place_ = place;
    run_ = run.shownRun;
    advance_ = moment.advance->advance;
    if (review_.comparable) {
        ++guesses_;
        points_ += review_.points;
    }
    review_.points > 0 ? context.log.announce(review_.words) : context.log.inform(review_.words);
    context.run.step(Granularity::Advance, 1); // completes this advance
}

bool GuessTool::handle(const CanvasEvent &event, Shell &context) {
    if (event.kind != CanvasEvent::Kind::Press || event.button != MouseButton::Left) {
        return false;
    }
    if (context.run.busy()) {
        return true;
    }
    asks(context) ? guess(event.place, context) : nextBase(context);
    return true;
}

void GuessTool::drawOverlay(CanvasPainter &painter, Shell &context) {
    if (!reviewed(context)) {
        return;
    }
    const Theme &theme = context.theme;
    const Colour colour = review_.same ? theme.good : review_.comparable ? theme.warn : theme.muted;
    if (review_.comparable && !review_.same) {
        const AdvanceExplanation &advance = *momentOf(context.run.now()).advance;
        painter.dashed(place_, advance.apex, colour, 1.5);
    }
    painter.cross(place_, 7.0, colour, 3.0);
    if (review_.comparable) {
        painter.label(place_, {12.0, 8.0}, ui::format("%d points, %.2f |AB| away", review_.points, review_.distance),
                      colour, fade(theme.popup, 0.95), context.fonts.small);
    }
}

void GuessTool::drawOptions(Shell &context, ui::Flow &flow) {
    flow.item("score");
    ImGui::AlignTextToFramePadding();
    const std::string score = ui::format("%d of %d points in %d %s", points_, GuessReview::kMaxPoints * guesses_,
                                         guesses_, guesses_ == 1 ? "guess" : "guesses");
    ImGui::TextUnformatted(score.c_str());
    ui::mark(context, "options/guess/score");
    flow.item("next");
    if (ui::button(context, "options/guess/next", "Next base", ui::ButtonKind::Plain, !context.run.busy())) {
        nextBase(context);
    }
    flow.item("again");
    if (ui::button(context, "options/guess/again", "Start again", ui::ButtonKind::Quiet)) {
        startAgain();
    }
}

std::vector<ContextGroup> GuessTool::menu(Shell &context, Vec2) {
    ContextGroup group;
    if (context.run.hasRun() && !context.run.showsFile() && !context.run.busy()) {
        group.push_back(commandOf("nextBase", "Next base", [](Shell &c) { nextBase(c); }));
    }
    group.push_back(commandOf("guessAgain", "Start again", [this](Shell &) { startAgain(); }));
    return {group, actionsOf({"run.forward", "run.back", "run.start", "run.mesh"})};
}

std::string GuessTool::statusText(const Shell &context) const {
    if (!context.run.hasRun() || context.run.showsFile()) {
        return "Mesh the drawing first; then guess where the next node goes";
    }
    return asks(context) ? "Click where the apex of the next element on AB should be"
                         : "Click, or press Next base, to continue";
}

} // namespace forefront
