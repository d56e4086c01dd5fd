#include "core/engine/spacing/parts/expression/expression.hpp"
#include "core/teaching/tables/power_law.hpp"
#include "ui/panels/adapted_rounds.hpp"
#include "ui/panels/form.hpp"
#include "ui/panels/panels.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/log_plot_view.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr double kMaxRounds = 100.0;
constexpr double kLeastPercent = 1e-7, kMostPercent = 100.0; ///< of the target error, as in batch

/// Adapts the mesh to a field until its estimated error meets a target.
class AdaptPanel final : public Panel {
  public:
    const char *id() const override { return "adapt"; }
    const char *title() const override { return "Adapt"; }

    void draw(Shell &context) override {
        drawField(context);
        drawTarget(context);
        drawStart(context);
        drawRounds(context);
        drawConvergence(context);
    }

  private:
    /// Draws the choice between an expression and the nodal values of the opened mesh.
    void drawField(Shell &context) {
        std::vector<std::string> names{"Expression"};
        if (const auto fields = source(context).fields) {
            for (const auto &[name, values] : fields->nodes) {
                names.push_back(name);
            }
        }
        const auto known = std::find(names.begin() + 1, names.end(), field_);
        auto choice = static_cast<int>(known == names.end() ? 0 : known - names.begin());
        form::label(context, "Field");
        if (ui::combo(context, "adapt/field", names, choice)) {
            field_ = choice == 0 ? std::string() : names[static_cast<std::size_t>(choice)];
        }
        ui::rowTooltip(context, "The mesh is refined where linear elements approximate the gradient of this field "
                                "badly. Nodal values of an opened mesh allow only one new mesh, always made from "
                                "that file; then recompute the values on it.");
        if (choice == 0) {
            form::label(context, "f(x, y)");
            std::string typed = expression_;
            if (ui::inputName(context, "adapt/expression", typed, "atan(20*(x*x+y*y-1))")) {
                enterExpression(context, typed);
            }
        }
        usesValues_ = choice > 0;
    }

    void enterExpression(Shell &context, const std::string &typed) {
        const NamedValues &names = context.document.current()->spacing.names;
        const Result<ExpressionProgram> compiled = compileExpression(typed, names);
        if (!compiled && !typed.empty()) {
            ui::refuseEntry(context, "adapt/expression", compiled.faults(), compiled.faults().front().message);
        } else {
            expression_ = typed;
        }
    }

    static void drawSize(Shell &context, const char *name, std::optional<double> &size, const char *hint) {
        std::optional<double> entered = size;
        if (ui::inputOptional(context, name, entered, hint, form::halfWidth(context), {},
                              context.document.current()->unit) &&
            ui::checkPositive(context, name, entered.value_or(0.0), true)) {
            size = entered;
        }
    }

    void drawTarget(Shell &context) {
        form::label(context, "Error, %");
        if (double percent = percent_; ui::inputNumber(context, "adapt/error", percent, form::halfWidth(context)) &&
                                       ui::checkRange(context, "adapt/error", percent, kLeastPercent, kMostPercent)) {
            percent_ = percent;
        }
        ui::tooltip(context, "Target: estimated error of the gradient, relative to its norm");
        form::label(context, "Rounds, max.");
        if (double rounds = rounds_; ui::inputNumber(context, "adapt/rounds", rounds, form::halfWidth(context)) &&
                                     ui::checkWhole(context, "adapt/rounds", rounds, 1.0, kMaxRounds)) {
            rounds_ = rounds;
        }
        ui::tooltip(context, "Maximum number of new meshes");
        form::label(context, "Size");
        drawSize(context, "adapt/minimum", minimum_, "min");
        ui::tooltip(context, "Minimum edge length");
        ImGui::SameLine();
        drawSize(context, "adapt/maximum", maximum_, "max");
        ui::tooltip(context, "Maximum edge length");
    }

    /// Returns why no adaptation can start, or null.
    const char *obstacle(const Shell &context) const {
        constexpr const char *kChanged = "The drawing has changed; mesh it again first.";
        const RunControl &run = context.run;
        const MeshingOptions &options = context.document.current()->options;
        if (options.elements != Elements::Triangles || options.order != ElementOrder::First) {
            return "Only triangles of order 1 can be adapted: set Elements and Order in the panel Meshing.";
        }
        if (!run.showsFile() && (run.busy() || run.hasNews())) {
            return "Wait until the mesh is finished.";
        }
        const SessionSnapshot &shown = run.now();
        if (!shown.mesh || shown.mesh->mesh.elements.empty() || !shown.complete) {
            return "Mesh the drawing, or open a mesh, to adapt it.";
        }
        if (!shown.atEnd()) {
            return "Go to the end of the run (End) to adapt its mesh.";
        }
        // Live meshing may have yet to follow, so the state "out of date" is not enough.
        if (!run.showsFile() && (run.shownRevision() != run.meshRevision() || run.preview())) {
            return kChanged;
        }
        if (showsRound(context) && !context.adaptation.fits(context.document.current())) {
            return kChanged;
        }
        return !usesValues_ && expression_.empty() ? "Enter a field, such as exp(-x*x-y*y)." : nullptr;
    }

    void drawStart(Shell &context) {
        const AdaptProgress &now = context.adaptation.now();
        if (now.running) {
            if (ui::button(context, "adapt/cancel", "Cancel")) {
                context.adaptation.cancel();
            }
            ui::tooltip(context, "Esc");
            ImGui::SameLine();
            ImGui::ProgressBar(static_cast<float>(now.fraction), {-1.0F, context.px(24)}, now.stage.c_str());
            ui::mark(context, "adapt/progress");
            return;
        }
        const char *const why = obstacle(context);
        if (ui::button(context, "adapt/start", "Adapt", ui::ButtonKind::Primary, why == nullptr)) {
            start(context);
        }
        const bool keeps = context.adaptation.selected < now.rounds.size() &&
                           now.rounds[context.adaptation.selected]->spacing.background != nullptr;
        ImGui::SameLine();
        if (ui::button(context, "adapt/keep", "Keep spacing", ui::ButtonKind::Plain, keeps)) {
            keepSpacing(context, context.adaptation.selected);
        }
        ui::tooltip(context, "Use the spacing of the selected mesh for the drawing");
        if (why != nullptr) {
            ui::small(context, why, true);
        }
    }

    /// Returns true if the mesh shown is one of the rounds.
    static bool showsRound(const Shell &context) {
        const auto &mesh = context.run.now().mesh;
        return mesh && !context.adaptation.now().rounds.empty() && mesh->version == context.adaptation.shown;
    }

    /// Returns the mesh that the rounds shown began with, or else the mesh shown.
    static AdaptSource source(const Shell &context) {
        return showsRound(context) ? context.adaptation.request().source
                                   : AdaptSource{context.run.now().mesh, context.run.fields()};
    }

    void start(Shell &context) {
        AdaptRequest request;
        request.source = source(context);
        request.mesh = usesValues_ ? request.source.mesh : context.run.now().mesh;
        if (showsRound(context)) {
            request.drawing = context.adaptation.request().drawing;
        } else if (!context.run.showsFile()) {
            request.drawing = context.document.current();
        }
        request.field = usesValues_ ? field_ : expression_;
        if (const auto &fields = request.source.fields; usesValues_ && fields) {
            const std::vector<double> *const values = fields->find(MeshPart::Nodes, field_);
            request.values = values == nullptr ? nullptr : std::shared_ptr<const std::vector<double>>(fields, values);
        }
        request.target.error = 0.01 * percent_;
        request.target.sizeMin = minimum_.value_or(0.0);
        request.target.sizeMax = maximum_.value_or(request.target.sizeMax);
        request.maxRounds = static_cast<int>(rounds_);
        request.options = context.document.current()->options;
        if (!possible(context, request)) {
            return;
        }
        context.adaptation.start(std::move(request));
        context.adaptation.shown = context.run.now().mesh->version; // replaced by the meshes as they come
        context.adaptation.loads = context.document.loads();
        context.animate();
    }

    /// Refuses sizes and values that cannot be used, with a message.
    static bool possible(Shell &context, const AdaptRequest &request) {
        if (request.target.sizeMin < 0.0 || !(request.target.sizeMax > request.target.sizeMin)) {
            context.log.add(error("bad-size",
                                  "sizes from " + ui::number(request.target.sizeMin) + " to " +
                                      ui::number(request.target.sizeMax) + " are not a range",
                                  "enter two positive numbers in increasing order, or leave them empty"));
            return false;
        }
        const bool finite = !request.values || std::all_of(request.values->begin(), request.values->end(),
                                                           [](double value) { return std::isfinite(value); });
        if (!finite) {
            context.log.add(error("bad-values", "the field '" + request.field + "' has no value at some nodes",
                                  "choose another field, or an expression"));
        }
        return finite;
    }

    static void drawRounds(Shell &context) {
        const AdaptProgress &now = context.adaptation.now();
        for (std::size_t k = 0; k < now.rounds.size(); ++k) {
            const AdaptedMesh &round = *now.rounds[k];
            const std::string label =
                "Mesh " + std::to_string(k) + "   " + ui::count(round.mesh.elements.size()) + " triangles";
            const std::string error =
                round.error ? ui::number(100.0 * *round.error, 3) + " %" : std::string("\xe2\x80\x93");
            if (ui::selectable(context, "adapt/round/" + std::to_string(k), label,
                               showsRound(context) && context.adaptation.selected == k, error)) {
                showRound(context, k);
            }
            ui::tooltip(context, ui::count(round.mesh.nodes.size()) +
                                     " nodes; the percentage is the estimated error. Click to show this mesh.");
        }
    }

    /// Draws the estimated errors of the meshes against their numbers of triangles.
    static void drawConvergence(Shell &context) {
        LogPlot plot{"", "triangles", "estimated error, %", {}};
        PlotSeries series;
        for (const auto &round : context.adaptation.now().rounds) {
            if (round->error && *round->error > 0.0) {
                series.points.push_back({static_cast<double>(round->mesh.elements.size()), 100.0 * *round->error});
            }
        }
        const auto law = fitPowerLaw(series.points);
        if (!law) {
            return;
        }
        plot.series.push_back(std::move(series));
        ui::small(context,
                  ui::format("Slope of the line: %.2f. Uniform refinement reaches -0.5 where the field is smooth.",
                             law->exponent),
                  true);
        ui::mark(context, "adapt/slope");
        ui::logPlot(context, "adapt/plot", plot, 150.0, ui::PlotLegend::Without);
    }

    std::string field_; ///< name of the nodal values; empty: the expression
    std::string expression_;
    bool usesValues_ = false;
    double percent_ = 5.0, rounds_ = 8.0;
    std::optional<double> minimum_, maximum_;
};

} // namespace

std::unique_ptr<Panel> makeAdaptPanel() {
    return std::make_unique<AdaptPanel>();
}

} // namespace forefront
