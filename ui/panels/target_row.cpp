#include "ui/panels/target_row.hpp"

#include "core/drawing/commands/scale_sizes.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/pipeline/target_elements.hpp"
#include "core/engine/spacing/part_list.hpp"
#include "ui/panels/form.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <optional>
#include <string>
#include <utility>

namespace forefront {
namespace {

constexpr const char *kTargetLabel = "Set number of elements";
constexpr double kFewest = 100.0, kMost = 1.0e6; ///< ends of the slider, which is logarithmic

double targetKnob(double elements) {
    return std::clamp(std::log(elements / kFewest) / std::log(kMost / kFewest), 0.0, 1.0);
}

/// Makes the document with the sizes that were found the current one, as one step from the base. Returns true if the
/// sizes are those of the current document then.
bool useSizes(Shell &context, const TargetSearch &search, const Result<TargetSizes> &sizes) {
    if (context.document.current() != search.shown) {
        context.log.refuse("the sizes for " + ui::count(search.target) +
                           " elements are not used: the drawing was changed meanwhile");
        return false;
    }
    if (!sizes) {
        context.log.add(sizes.faults());
        return false;
    }
    if (search.shown != search.base) {
        context.document.undo(); // the drag, whose sizes were estimated
    }
    Document next = scaleSizes(*search.base, sizes->factor);
    const Diagnostics missed = missedTarget(*sizes, search.target, jobOf(next));
    if (sizes->factor != 1.0 && !context.applyCommand(std::move(next), kTargetLabel)) {
        return false;
    }
    if (!missed.empty()) {
        context.log.add(missed);
        return true;
    }
    context.log.announce(ui::count(sizes->elements) + " elements: sizes " +
                         (sizes->factor == 1.0 ? "unchanged" : "\xc3\x97 " + ui::number(sizes->factor, 4)));
    return true;
}

} // namespace

/// Starts a search as the background task of the window.
void TargetRow::search(Shell &context, TargetSearch search) {
    *asked_ = {search.target, context.document.loads(), search.shown};
    cancelTask(context);
    const std::string purpose = "finding the sizes for " + ui::count(search.target) + " elements";
    context.task.start(purpose, [&context, asked = asked_, search = std::move(search)](const Progress &progress) {
        const auto jobWith = [&](double factor) { return jobOf(scaleSizes(*search.base, factor)); };
        try {
            const Result<TargetSizes> sizes = sizesForElements(jobWith, search.target, progress);
            return progress.cancelled()
                       ? BackgroundTask::Finish()
                       : BackgroundTask::Finish([&context, asked, search, sizes] {
                             const bool used = useSizes(context, search, sizes);
                             *asked = used ? Asked{search.target, context.document.loads(), context.document.current()}
                                           : Asked();
                         });
        } catch (const std::bad_alloc &) {
            return BackgroundTask::Finish([&context] {
                context.log.add(error("out-of-memory", "not enough memory to find the sizes",
                                      "choose a smaller number of elements, or close other programs"));
            });
        }
    });
    context.animate();
}

/// Returns true while the current document has the sizes that were found for the number asked for.
bool TargetRow::isAsked(const Shell &context) const {
    return asked_->number > 0 && asked_->found &&
           sameContent(asked_->found->spacing, context.document.current()->spacing) &&
           asked_->loads == context.document.loads();
}

/// Says what was asked for beside what came out.
void TargetRow::drawAsked(Shell &context) const {
    const SessionSnapshot &run = context.run.now();
    const bool meshed = run.state == RunState::Finished && !context.run.outOfDate() && !context.run.preview();
    const std::uint64_t estimate =
        static_cast<std::uint64_t>(roundedTo(std::max(context.preview->estimatedElements, 0.0), 2));
    const std::string made =
        meshed ? "the mesh has " + ui::count(run.quality.elements) : "about " + ui::count(estimate) + " now";
    form::label(context, "");
    ui::small(context, "asked for " + ui::count(asked_->number) + "; " + made);
    ui::mark(context, "spacing/target/asked");
}

void TargetRow::draw(Shell &context) {
    form::label(context, "Target");
    constexpr float kField = 74.0F;
    std::optional<double> typed;
    const double predicted = context.preview->estimatedElements;
    const auto shown = base_ ? target_ : static_cast<std::uint64_t>(roundedTo(std::max(predicted, 0.0), 2));
    const bool asked = !base_ && isAsked(context);
    const std::string hint = asked ? ui::count(asked_->number) : shown > 0 ? ui::count(shown) : "elements";
    if (form::optionalField(context, "spacing/target", typed, hint.c_str(), kField, {}) && typed &&
        ui::checkRange(context, "spacing/target", *typed, 1.0,
                       static_cast<double>(context.document.current()->options.maxElements))) {
        const std::shared_ptr<const Document> now = context.document.current();
        search(context, {now, now, static_cast<std::uint64_t>(std::llround(*typed))});
    }
    ui::rowTooltip(context, "Number of elements to aim for, within 5 %. Scales all element sizes. The minimum size, "
                            "growth, the curve error and numbers of elements stay. A maximum size is scaled only "
                            "where it sets the size of automatic spacing.");
    ImGui::SameLine(0, context.px(6));
    drawSlider(context);
    if (asked) {
        drawAsked(context);
    }
}

void TargetRow::drawSlider(Shell &context) {
    const double predicted = context.preview->estimatedElements;
    double knob = base_ ? targetKnob(static_cast<double>(target_)) : targetKnob(std::max(predicted, 1.0));
    const float width = ImGui::GetContentRegionAvail().x / context.scale;
    const bool moved = ui::thinSlider(context, "spacing/target/slider", knob, "", std::max(24.0F, width), 0.0F);
    ui::tooltip(context, "Drag: sizes and live mesh follow the estimate. Release: the sizes are found by meshing.");
    followDrag(context, moved, knob);
}

void TargetRow::followDrag(Shell &context, bool moved, double knob) {
    drag_.follow(context, moved, [&](const char *stroke) {
        if (!base_) {
            if (!(context.preview->estimatedElements >= 1.0)) {
                return false; // nothing to mesh yet
            }
            cancelTask(context);
            base_ = context.document.current();
            baseEstimate_ = context.preview->estimatedElements;
        }
        const double wanted = roundedTo(kFewest * std::pow(kMost / kFewest, knob), 2);
        const auto target = static_cast<std::uint64_t>(std::llround(wanted));
        if (target == target_) {
            return false;
        }
        target_ = target;
        context.applyCommand(scaleSizes(*base_, estimatedFactor(baseEstimate_, target)), kTargetLabel, stroke);
        dragged_ = context.document.current();
        return true;
    });
    if (!base_ || ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        return;
    }
    if (dragged_ && context.document.current() == dragged_ && dragged_ != base_) { // else Esc took it back
        search(context, {base_, dragged_, target_});
    }
    base_ = dragged_ = nullptr;
    target_ = 0;
}

} // namespace forefront
