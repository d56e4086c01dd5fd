#include "core/drawing/formulas/formulas.hpp"
#include "ui/panels/edit_panels.hpp"
#include "ui/parts/shell.hpp"
#include "ui/style/icons.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace forefront {
namespace {

constexpr float kName = 72.0F, kValue = 64.0F, kRemove = 24.0F, kGap = 6.0F; ///< of a row, in design pixels

/// The table of the parameters. An invalid name or expression stays in its field until it is corrected.
class ParametersPanel final : public Panel {
  public:
    const char *id() const override { return "parameters"; }
    const char *title() const override { return "Parameters"; }

    void draw(Shell &context) override {
        if (revision_ != context.document.revision()) {
            read(context);
        }
        if (rows_.empty()) {
            ui::small(context, "Name a number here, such as r = 0.4, and enter r or 2*r in any number field.", true);
        }
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            drawRow(context, k);
            if (revision_ != context.document.revision()) {
                return; // the rows show the previous document
            }
        }
        if (ui::button(context, "parameters/add", "Add parameter")) {
            add(context);
        }
    }

    std::vector<ContextGroup> menu(Shell &) override {
        return {{commandOf("add", "Add parameter", [](Shell &c) { add(c); })}};
    }

  private:
    static void add(Shell &context) {
        std::vector<Parameter> more = context.document.current()->parameters;
        more.push_back({freeParameterName("p", 1, namesOf(more)), "1"});
        const std::string row = "parameters/" + std::to_string(more.size() - 1);
        if (context.applyCommand(setParameters(*context.document.current(), std::move(more)), "Add parameter")) {
            context.widgets.fields.request(row + "/name");
            context.animate();
        }
    }

    struct Row {
        Parameter shown;
        std::optional<double> value;
        std::string fault;
    };

    void read(const Shell &context) {
        const Document &document = *context.document.current();
        revision_ = context.document.revision();
        rows_.clear();
        for (const Parameter &parameter : document.parameters) {
            const auto value = document.spacing.names.find(parameter.name);
            rows_.push_back(
                {parameter, value != document.spacing.names.end() ? std::optional(value->second) : std::nullopt, {}});
        }
    }

    void drawRow(Shell &context, std::size_t index) {
        Row &row = rows_[index];
        const std::string name = "parameters/" + std::to_string(index);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const ImVec2 end{at.x + ImGui::GetContentRegionAvail().x, at.y + ImGui::GetFrameHeight()};
        if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(at, end) &&
            ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
            openMenu(context, index);
        }
        const float rest = ImGui::GetContentRegionAvail().x / context.scale - kName - kValue - kRemove - 3.0F * kGap;
        if (std::string typed = row.shown.name; ui::inputName(context, name + "/name", typed, "name", kName, true)) {
            rename(context, index, typed);
        }
        ImGui::SameLine(0, context.px(kGap));
        if (std::string typed = row.shown.expression;
            ui::inputName(context, name + "/expression", typed, "0.5 or 2*r", std::max(rest, 40.0F))) {
            change(context, index, typed);
        }
        ImGui::SameLine(0, context.px(kGap));
        drawValue(context, row);
        ImGui::SameLine(ImGui::GetContentRegionMax().x - context.px(kRemove));
        if (ui::iconButton(context, name + "/remove", icon::kTrash, "Remove parameter", false, true, kRemove)) {
            remove(context, index);
        }
        if (!row.fault.empty()) {
            ImGui::PushStyleColor(ImGuiCol_Text, context.theme.bad);
            ui::wrappedText(row.fault);
            ImGui::PopStyleColor();
            ui::mark(context, name + "/fault");
        }
    }

    void openMenu(Shell &context, std::size_t index) {
        const std::string name = "parameters/" + std::to_string(index);
        const auto edit = [](std::string field) {
            return [field = std::move(field)](Shell &c) { c.widgets.fields.request(field); };
        };
        const Parameter &parameter = rows_[index].shown;
        ContextGroup group{commandOf("rename", "Rename", edit(name + "/name")),
                           commandOf("change", "Change expression", edit(name + "/expression")),
                           copyCommand("copy", "Copy", parameter.name + " = " + parameter.expression)};
        if (rows_[index].value) {
            group.push_back(copyCommand("copyValue", "Copy value", ui::number(*rows_[index].value, 12)));
        }
        const auto isShown = [this, revision = revision_](const Shell &c) {
            return revision == c.document.revision() && revision == revision_;
        };
        context.menu.open({std::move(group), {commandOf("remove", "Remove", [this, index, isShown](Shell &c) {
                               if (isShown(c)) {
                                   remove(c, index);
                               }
                           })}});
    }

    static void drawValue(Shell &context, const Row &row) {
        ImGui::AlignTextToFramePadding();
        ui::muted(context, row.value && row.fault.empty() ? "= " + ui::number(*row.value, 5) : std::string(" "));
    }

    void rename(Shell &context, std::size_t index, const std::string &name) {
        finish(context, index, renameParameter(*context.document.current(), index, name),
               "Rename parameter " + rows_[index].shown.name + " to " + name);
    }

    void change(Shell &context, std::size_t index, const std::string &expression) {
        std::vector<Parameter> parameters = context.document.current()->parameters;
        parameters[index].expression = expression;
        const std::string fault = parameterStates(parameters)[index].fault;
        if (!fault.empty()) {
            refuse(context, index, error("bad-parameter", fault));
            return;
        }
        const std::string label = "Change parameter " + parameters[index].name + " to " + expression;
        finish(context, index, setParameters(*context.document.current(), std::move(parameters)), label);
    }

    void remove(Shell &context, std::size_t index) {
        finish(context, index, removeParameter(*context.document.current(), index),
               "Remove parameter " + rows_[index].shown.name);
    }

    /// Refuses what was entered into a field of the row, or shows below the row why a command is impossible.
    void refuse(Shell &context, std::size_t index, const Diagnostics &faults) {
        const std::string row = "parameters/" + std::to_string(index), &field = context.widgets.fields.committed;
        const Diagnostic &fault = faults.front();
        const std::string reason = fault.message + (fault.code == "parameter-in-use" ? "; " + fault.advice : "");
        if (field.starts_with(row + '/')) {
            ui::refuseEntry(context, field, faults, reason);
        } else {
            rows_[index].fault = reason;
        }
        context.animate();
    }

    void finish(Shell &context, std::size_t index, Result<Document> next, const std::string &label) {
        if (next) {
            rows_[index].fault.clear();
            context.applyCommand(std::move(next), label);
        } else {
            refuse(context, index, next.faults());
        }
        context.animate();
    }

    std::vector<Row> rows_;
    std::uint64_t revision_ = 0; ///< of the document that the rows show
};

} // namespace

std::unique_ptr<Panel> makeParametersPanel() {
    return std::make_unique<ParametersPanel>();
}

} // namespace forefront
