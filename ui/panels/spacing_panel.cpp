#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/spacing/parts/expression/expression.hpp"
#include "core/engine/spacing/spec/size_presets.hpp"
#include "ui/panels/edit_panels.hpp"
#include "ui/panels/form.hpp"
#include "ui/panels/gradation_row.hpp"
#include "ui/panels/target_row.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/parse_number.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <span>
#include <utility>

namespace forefront {
namespace {

class SpacingPanel final : public Panel {
  public:
    const char *id() const override { return "spacing"; }
    const char *title() const override { return "Spacing"; }
    void draw(Shell &context) override;

  private:
    static void drawExpression(Shell &context);
    static void drawRasters(Shell &context);
    static void drawSources(Shell &context);
    static void drawElementCounts(Shell &context);
    static void drawCurveTolerance(Shell &context);
    void drawLimits(Shell &context);

    GradationRow gradation_;
    TargetRow target_;
};

/// Returns the fault of the expression if the preview found one, else null.
const Diagnostic *expressionFault(const Workspace &context) {
    for (const Diagnostic &fault : context.preview->faults) {
        if (fault.code.starts_with("expression")) {
            return &fault;
        }
    }
    return nullptr;
}

void drawExpressionFault(WidgetContext &context, const Diagnostic &fault, const std::string &expression) {
    ImGui::PushFont(context.fonts.small);
    if (fault.column > 0 && static_cast<std::size_t>(fault.column) <= expression.size() + 1) {
        // Show the expression around the fault; the part from the fault on is in the error colour.
        const auto cut = static_cast<std::size_t>(fault.column - 1);
        const std::size_t from = cut > 24 ? cut - 24 : 0;
        ImGui::PushFont(context.fonts.mono);
        ui::muted(context, (from > 0 ? "\xe2\x80\xa6" : "") + expression.substr(from, cut - from));
        ImGui::SameLine(0, 0);
        ImGui::PushStyleColor(ImGuiCol_Text, context.theme.bad);
        ImGui::TextUnformatted(cut < expression.size() ? expression.substr(cut, 24).c_str() : "\xe2\x96\x8f");
        ImGui::PopStyleColor();
        ImGui::PopFont();
    }
    ImGui::PushStyleColor(ImGuiCol_Text, context.theme.bad);
    std::string text = fault.message;
    if (!fault.advice.empty()) {
        text += "; " + fault.advice;
    }
    ui::wrappedText(text);
    ImGui::PopStyleColor();
    ui::mark(context, "spacing/expression/fault");
    ImGui::PopFont();
}

/// Makes a typed expression the spacing, unless it cannot be compiled.
void enterExpression(Shell &context, const std::string &typed) {
    const Document &document = *context.document.current();
    if (!trimmed(typed).empty()) {
        if (const Result<ExpressionProgram> compiled = compileSpacingExpression(typed, document.spacing, nullptr);
            !compiled) {
            const Diagnostic &fault = compiled.faults().front();
            ui::refuseEntry(context, "spacing/expression", compiled.faults(),
                            fault.column > 0 ? "column " + std::to_string(fault.column) + ": " + fault.message
                                             : fault.message);
            return;
        }
    }
    context.document.apply(setExpression(document, typed), "Change expression");
}

void SpacingPanel::drawExpression(Shell &context) {
    const std::shared_ptr<const Document> document = context.document.current();
    const std::string expression = document->spacing.expression.value_or(std::string());
    std::string typed = expression;
    form::label(context, "Expression");
    if (ui::inputName(context, "spacing/expression", typed, "0.1 + 0.2*abs(x)")) {
        enterExpression(context, typed);
    }
    ui::rowTooltip(context, "Node spacing \xcf\x81 as a function of x and y, of rasters such as depth(x,y), and of the "
                            "distance to the boundary, shore(x,y), or to parts of it, shore(x,y,'coast'). Where "
                            "several parts give a spacing, the smallest applies.");
    if (const Diagnostic *fault = expressionFault(context)) {
        drawExpressionFault(context, *fault, expression);
    }
}

/// Returns the key and value of a rule for the first raster: depths, or elevations, of which most are negative.
std::string depthKey(const RasterMap &rasters) {
    const auto &[name, raster] = *rasters.begin();
    const auto below = std::count_if(raster->values.begin(), raster->values.end(), [](double v) { return v < 0.0; });
    const auto above = std::count_if(raster->values.begin(), raster->values.end(), [](double v) { return v > 0.0; });
    return (below > above ? "elevation=" : "depth=") + name;
}

/// Opens the menu of rules that write the expression, with figures by the extent of the drawing, to be edited; two of
/// them need a raster of depths.
void openPresets(Shell &context) {
    constexpr double kSmall = 1.0 / 400.0, kLarge = 1.0 / 20.0; // sizes over the diagonal of the drawing
    const Document &document = *context.document.current();
    const double diagonal = boundsOf(document).diagonal();
    const std::string small = exactText(roundedTo(kSmall * diagonal, 2)),
                      large = exactText(roundedTo(kLarge * diagonal, 2));
    const auto command = [](const char *id, const char *title, std::string rule) {
        return commandOf(id, title, [rule = std::move(rule)](Shell &c) {
            const Result<std::string> text = presetExpression(std::span(&rule, 1));
            if (text) {
                c.document.apply(setExpression(*c.document.current(), *text), "Set sizes by a rule");
            }
        });
    };
    ContextGroup group;
    if (!document.spacing.rasters.empty() && diagonal > 0.0) {
        const std::string depth = depthKey(document.spacing.rasters);
        group.push_back(command("wavelength", "Elements per wavelength",
                                "wavelength:" + depth + ",period=44714,elements=200,min=" + small)); // of the tide M2
        group.push_back(
            command("slope", "Slope of the sea bed", "slope:" + depth + ",elements=20,min=" + small + ",max=" + large));
    }
    if (diagonal > 0.0) {
        group.push_back(command("shore", "Distance to the shore", "shore:size=" + small + ",growth=0.15"));
    }
    group.push_back(commandOf("channels", "Width of channels", [](Shell &c) {
        c.applyCommand(setElementsAcross(*c.document.current(), 4.0), "Change elements per gap");
    }));
    context.menu.open({std::move(group)});
}

void SpacingPanel::drawRasters(Shell &context) {
    const std::shared_ptr<const Document> document = context.document.current();
    for (const auto &[name, raster] : document->spacing.rasters) {
        form::label(context, "Raster");
        if (ui::button(context, "spacing/raster/" + name, "Remove " + name)) {
            Document next = *context.document.current();
            next.spacing.rasters.erase(name);
            context.document.apply(std::move(next), "Remove raster");
        }
        ui::rowTooltip(context,
                       ui::format("%s(x,y) is its value in the expression, %s_x(x,y) and %s_y(x,y) its slopes; "
                                  "%s x %s values",
                                  name.c_str(), name.c_str(), name.c_str(), ui::count(raster->columns).c_str(),
                                  ui::count(raster->rows).c_str()));
    }
    form::label(context, "");
    if (ui::button(context, "spacing/addraster", "Add raster\xe2\x80\xa6")) {
        context.actions.run("file.addRaster", context);
    }
    ui::tooltip(context, "A grid of depths, for example, that the expression calls by its name");
    ImGui::SameLine(0, context.px(6));
    if (ui::button(context, "spacing/presets", "Rule\xe2\x80\xa6")) {
        openPresets(context);
    }
    ui::tooltip(context, "Write the expression by a rule, such as elements per wavelength over a raster of depths");
}

/// Returns the size of a source, or the sizes at both ends: "ρ 0.1–0.4".
std::string sizeText(const SizeSource &source) {
    const std::string size = "\xcf\x81 " + ui::number(source.size, 3);
    const bool graded = source.shape == SourceShape::Line && source.endSize;
    return graded ? size + "\xe2\x80\x93" + ui::number(*source.endSize, 3) : size;
}

/// Draws the switch between sources that refine automatic spacing and sources that replace it. Other parts that cover
/// the domain replace it in any case.
void drawKeepAutomatic(Shell &context) {
    const std::shared_ptr<const Document> document = context.document.current();
    const SpacingSpec &spacing = document->spacing;
    if (spacing.size || spacing.expression || spacing.fromBoundary || spacing.hasGradient()) {
        return;
    }
    form::label(context, "");
    bool keep = spacing.keepAutomatic.value_or(false);
    if (ui::checkbox(context, "spacing/keepautomatic", "Keep automatic spacing", keep)) {
        context.document.apply(setKeepAutomatic(*document, keep), "Keep automatic spacing");
    }
    ui::rowTooltip(context, "Sources only refine the automatic spacing. Switch this off to let the sources alone set "
                            "the spacing.");
}

void selectSource(Shell &context, std::uint32_t source) {
    context.selection.clear();
    context.selection.sources.insert(source);
    context.naming.row.reset(); // F2 renames the source, not a row of the Shapes panel
    context.tools.choose("select", context);
}

void SpacingPanel::drawSources(Shell &context) {
    const std::shared_ptr<const Document> document = context.document.current();
    const std::vector<SizeSource> &sources = document->spacing.sources;
    ImGui::AlignTextToFramePadding();
    ui::muted(context, sources.empty()
                           ? "No size sources"
                           : ui::count(sources.size()) + (sources.size() == 1 ? " size source" : " size sources"));
    ImGui::SameLine(ImGui::GetContentRegionMax().x - context.px(60));
    if (ui::button(context, "spacing/sources/add", "Add", ui::ButtonKind::Plain, true, 60.0F)) {
        context.tools.choose("source", context);
    }
    // A long list stays a few rows high; each row selects its source and shows its size.
    const std::size_t shown = std::min<std::size_t>(sources.size(), 200);
    if (shown == 0) {
        return;
    }
    const float rows = static_cast<float>(std::min<std::size_t>(shown, 4));
    ImGui::BeginChild("sources", {0, rows * context.px(30)}, false, ImGuiWindowFlags_NoNav);
    for (std::uint32_t k = 0; k < shown; ++k) {
        if (ui::selectable(context, "spacing/source/" + std::to_string(k), displayName(sources[k], k),
                           context.selection.sources.contains(k), sizeText(sources[k]))) {
            selectSource(context, k);
        }
        if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
            selectSource(context, k);
            context.menu.open(selectionMenu());
        }
    }
    ImGui::EndChild();
    drawKeepAutomatic(context);
}

/// Draws the fields for the numbers of elements that curves and narrow places need.
void SpacingPanel::drawElementCounts(Shell &context) {
    const std::shared_ptr<const Document> document = context.document.current();
    std::optional<double> perTurn = document->spacing.segmentsPerTurn, across = document->spacing.elementsAcross;
    form::label(context, "Elements per");
    const float half = form::halfWidth(context);
    const float turn = form::wordBefore(context, "turn", half);
    if (form::optionalField(context, "spacing/perturn", perTurn, "auto", turn,
                            NumberAddress{NumberOwner::ofSpacing(), Quantity::SegmentsPerTurn})) {
        context.applyCommand(setSegmentsPerTurn(*context.document.current(), perTurn), "Change elements per turn");
    }
    ui::rowTooltip(context,
                   "Elements along a full turn of a curved boundary; 0: ignore bends. Empty: 40 with automatic "
                   "spacing, fewer on small bends, else 0. Curves always get as many as their shape needs.");
    ImGui::SameLine(0, context.px(6));
    const float gap = form::wordBefore(context, "gap", half);
    if (form::optionalField(context, "spacing/across", across, "auto", gap,
                            NumberAddress{NumberOwner::ofSpacing(), Quantity::ElementsAcross})) {
        context.applyCommand(setElementsAcross(*context.document.current(), across), "Change elements per gap");
    }
    ui::tooltip(context, "Elements across narrow places, such as channels; 0: ignore narrow places. Empty: 2 with "
                         "automatic spacing, else 0. Corners are not narrow places, except tips below 20 degrees.");
}

void SpacingPanel::drawCurveTolerance(Shell &context) {
    const double given = context.document.current()->curveTolerance;
    std::optional<double> tolerance = given > 0.0 ? std::optional(given) : std::nullopt;
    form::label(context, "Curve error");
    if (form::optionalField(context, "spacing/curvetolerance", tolerance, "auto", -1.0F,
                            NumberAddress{NumberOwner::ofSpacing(), Quantity::CurveTolerance})) {
        context.applyCommand(setCurveTolerance(*context.document.current(), tolerance), "Change curve tolerance");
    }
    ui::rowTooltip(context,
                   "Curve tolerance: the maximum distance of a curve from its edges in the mesh. It limits the "
                   "element size beside curves. auto: 1/2000 of the diagonal of the domain");
}

void SpacingPanel::drawLimits(Shell &context) {
    const std::shared_ptr<const Document> document = context.document.current();
    std::optional<double> minimum = document->spacing.minimum, maximum = document->spacing.maximum;
    form::label(context, "Limits");
    const float half = form::halfWidth(context);
    const float least = form::wordBefore(context, "min", half);
    const bool low = form::optionalField(context, "spacing/minimum", minimum, "none", least,
                                         NumberAddress{NumberOwner::ofSpacing(), Quantity::Minimum});
    ui::rowTooltip(context, "Minimum node spacing");
    ImGui::SameLine(0, context.px(6));
    const float most = form::wordBefore(context, "max", half);
    const bool high = form::optionalField(context, "spacing/maximum", maximum, "none", most,
                                          NumberAddress{NumberOwner::ofSpacing(), Quantity::Maximum});
    ui::tooltip(context, "Maximum node spacing");
    if (low || high) {
        context.applyCommand(setLimits(*document, minimum, maximum), "Limit spacing");
    }
    gradation_.draw(context);
    drawElementCounts(context);
    drawCurveTolerance(context);
    form::label(context, "");
    bool fromBoundary = document->spacing.fromBoundary;
    if (ui::checkbox(context, "spacing/fromboundary", "Use boundary lengths", fromBoundary)) {
        context.document.apply(setFromBoundary(*context.document.current(), fromBoundary), "Spacing from boundary");
    }
    ui::rowTooltip(context, "Use the lengths of the drawn boundary segments as the node spacing there.");
}

void SpacingPanel::draw(Shell &context) {
    const std::shared_ptr<const Document> document = context.document.current();
    const SpacingSpec &spacing = document->spacing;
    std::optional<double> size = spacing.size;
    form::label(context, "Size");
    if (form::optionalField(context, "spacing/size", size, spacing.usesAutomatic() ? "auto" : "none", -1.0F,
                            NumberAddress{NumberOwner::ofSpacing(), Quantity::Size})) {
        context.applyCommand(setSize(*document, size), "Change size");
    }
    ui::rowTooltip(context, "Element size wherever nothing asks for smaller elements. Leave empty for automatic.");
    drawExpression(context);
    drawSources(context);
    drawLimits(context);
    if (!spacing.paint.tiles.empty()) {
        if (ui::button(context, "spacing/clearpaint", "Clear paint")) {
            context.actions.run("edit.clearPaint", context);
        }
        if (spacing.background) {
            ImGui::SameLine();
        }
    }
    if (spacing.background) {
        if (ui::button(context, "spacing/clearbackground", "Remove background mesh")) {
            Document next = *context.document.current();
            next.spacing.background.reset();
            context.document.apply(std::move(next), "Remove background mesh");
        }
        ui::tooltip(context, ui::count(spacing.background->nodes.size()) + " nodes, each with a spacing");
    }
    target_.draw(context);
    drawRasters(context);
}

} // namespace

std::unique_ptr<Panel> makeSpacingPanel() {
    return std::make_unique<SpacingPanel>();
}

} // namespace forefront
