#include "core/drawing/names/region_commands.hpp"
#include "ui/panels/edit_panels.hpp"
#include "ui/panels/form.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

namespace forefront {
namespace {

class NamesPanel final : public Panel {
  public:
    const char *id() const override { return "names"; }
    const char *title() const override { return "Names"; }

    void draw(Shell &context) override {
        const std::shared_ptr<const Document> document = context.document.current();
        ui::small(context, "Renaming a tag here renames it everywhere. Exported meshes keep the names.", true);
        ui::heading(context, "Boundaries");
        if (revision_ != context.document.revision()) {
            revision_ = context.document.revision();
            boundaries_ = boundaryTags(*document);
            regions_ = regionTags(*document);
        }
        for (const std::int32_t tag : boundaries_) {
            row(context, "names/boundary/", tag, boundaryName(document->boundaryNames, tag), [&](std::string name) {
                context.applyCommand(setBoundaryName(*context.document.current(), tag, std::move(name)),
                                     "Rename boundary");
            });
            ImGui::SameLine(0, context.px(6));
            if (ui::iconButton(context, "names/boundary/" + std::to_string(tag) + "/select", icon::kSelect,
                               "Select all visible and unlocked items with this tag", false, true, 24.0F)) {
                context.selection = selectTag(*document, tag);
                context.tools.choose("select", context);
            }
        }
        ImGui::Dummy({0, context.px(4)});
        ui::heading(context, "Regions");
        for (const std::int32_t tag : regions_) {
            row(context, "names/region/", tag, regionName(document->regionNames, tag), [&](std::string name) {
                context.applyCommand(setRegionName(*context.document.current(), tag, std::move(name)), "Rename region");
            });
        }
        if (ui::button(context, "names/addregion", "Fill a region\xe2\x80\xa6")) {
            context.tools.choose("region", context);
        }
    }

  private:
    template <class Rename>
    static void row(Shell &context, const std::string &prefix, std::int32_t tag, const std::string &name,
                    Rename rename) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const ImVec2 end{at.x + ImGui::GetContentRegionAvail().x, at.y + ImGui::GetFrameHeight()};
        if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(at, end) &&
            ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
            openMenu(context, prefix + std::to_string(tag), tag, prefix == "names/boundary/");
        }
        ImGui::AlignTextToFramePadding();
        ui::muted(context, std::to_string(tag));
        ImGui::SameLine(context.px(36));
        std::string typed = name;
        const float width = (ImGui::GetContentRegionAvail().x - context.px(34)) / context.scale;
        if (ui::inputName(context, prefix + std::to_string(tag), typed, "name", width, true)) {
            rename(std::move(typed));
        }
    }

    static void openMenu(Shell &context, const std::string &field, std::int32_t tag, bool boundary) {
        ContextGroup group{commandOf("rename", "Rename", [field](Shell &c) { c.widgets.fields.request(field); })};
        const auto select = [tag, boundary](Shell &c) {
            const Document &document = *c.document.current();
            c.selection = boundary ? selectTag(document, tag) : Selection();
            for (std::uint32_t k = 0; k < document.regionMarkers.size() && !boundary; ++k) {
                if (document.regionMarkers[k].tag == tag) {
                    c.selection.markers.insert(k);
                }
            }
            c.tools.choose("select", c);
        };
        group.push_back(commandOf("select", "Select all with this tag", select));
        group.push_back(commandOf("zoom", "Zoom to them", [select](Shell &c) {
            select(c);
            c.actions.run("view.zoomSelection", c);
        }));
        group.push_back(commandOf("unname", "Remove name", [tag, boundary](Shell &c) {
            const Document &document = *c.document.current();
            c.applyCommand(boundary ? setBoundaryName(document, tag, {}) : setRegionName(document, tag, {}),
                           boundary ? "Rename boundary" : "Rename region");
        }));
        context.menu.open({std::move(group)});
    }

    std::vector<std::int32_t> boundaries_, regions_; ///< tags of the document of revision_
    std::uint64_t revision_ = 0;
};

} // namespace

std::unique_ptr<Panel> makeNamesPanel() {
    return std::make_unique<NamesPanel>();
}

} // namespace forefront
