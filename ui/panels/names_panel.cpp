#include "core/edit/region_commands.hpp"
#include "ui/panels/edit_panels.hpp"
#include "ui/panels/form.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"

#include <imgui.h>

namespace forefront {
namespace {

class NamesPanel final : public Panel {
  public:
    const char *id() const override { return "names"; }
    const char *title() const override { return "Names"; }
    PanelPlace place() const override { return PanelPlace::Tabbed; }

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
                EditState::apply(context, setBoundaryName(*context.document.current(), tag, std::move(name)),
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
                EditState::apply(context, setRegionName(*context.document.current(), tag, std::move(name)),
                                 "Rename region");
            });
        }
        if (ui::button(context, "names/addregion", "Fill a region\xe2\x80\xa6")) {
            context.tools.choose("region", context);
        }
    }

  private:
    template <class Rename>
    static void row(WidgetContext &context, const std::string &prefix, std::int32_t tag, const std::string &name,
                    Rename rename) {
        ImGui::AlignTextToFramePadding();
        ui::muted(context, std::to_string(tag));
        ImGui::SameLine(context.px(36));
        std::string typed = name;
        const float width = (ImGui::GetContentRegionAvail().x - context.px(34)) / context.scale;
        if (ui::entry(context, prefix + std::to_string(tag), typed, "name", width, true)) {
            rename(std::move(typed));
        }
    }

    std::vector<std::int32_t> boundaries_, regions_; ///< tags of the document of revision_
    std::uint64_t revision_ = 0;
};

} // namespace

std::unique_ptr<Panel> makeNamesPanel() {
    return std::make_unique<NamesPanel>();
}

} // namespace forefront
