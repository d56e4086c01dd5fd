#include "ui/shell/main_window.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/fault_text.hpp"
#include "ui/widgets/popup_style.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace forefront::shell {
namespace {

constexpr double kNameWidth = 240.0; ///< design pixels
constexpr std::size_t kMaxNames = 8;

/// Returns the names to choose from: all at first, then those that contain what was typed.
std::vector<std::string> offeredNames(const Naming &naming, const Document &document) {
    std::vector<std::string> names = naming.thing->choices(document);
    if (naming.edited) {
        std::erase_if(names, [&](const std::string &name) { return name.find(naming.text) == std::string::npos; });
    }
    names.resize(std::min(names.size(), kMaxNames));
    return names;
}

/// Returns true if segments outside the part have its tag, too.
bool usedElsewhere(const Document &document, const NamedThing &thing) {
    const auto selects = [](const std::set<SegmentRef> &segments, const std::set<std::uint32_t> &shapes) {
        return segments.size() + shapes.size();
    };
    const Selection all = selectTag(document, thing.tag);
    return thing.kind == NamedThing::Kind::Part &&
           selects(all.segments, all.shapes) > selects(thing.part.segments, thing.part.shapes);
}

/// Gives the name and closes the field. A name that is refused stays in the field, with the focus and the reason.
void finish(Shell &context, const std::string &name) {
    Naming &naming = context.naming;
    NamedThing thing = *naming.thing;
    if (naming.everywhere && thing.kind == NamedThing::Kind::Part) {
        thing.kind = NamedThing::Kind::Tag;
    }
    if (const Result<Document> next = thing.renamed(*context.document.current(), name); !next) {
        context.log.keep(next.faults());
        naming.fault = next.faults().front().message;
        naming.text = name;
        context.widgets.fields.request("naming/name");
        context.animate();
        return;
    }
    naming.close();
    applyName(context, thing, name);
}

void drawNames(Shell &context, const std::vector<std::string> &names) {
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (ui::selectable(context, "naming/choice/" + names[k], names[k],
                           context.naming.choice == static_cast<int>(k))) {
            finish(context, names[k]);
            return;
        }
    }
}

/// Draws the switch between the boundary part and the name of a single shape.
void drawThings(Shell &context, const Document &document) {
    static constexpr std::array<const char *, 2> kThings{"Boundary tag", "Shape name"};
    Naming &naming = context.naming;
    int choice = naming.thing->kind == NamedThing::Kind::Shape ? 1 : 0;
    if (ui::segmented(context, "naming/thing", kThings, choice, static_cast<float>(kNameWidth))) {
        naming.swapThings(document);
        context.widgets.fields.request("naming/name");
        context.animate();
    }
    ui::tooltip(context, "The boundary tag names a part of the boundary for solvers; the name of the shape is for the "
                         "drawing alone");
}

/// Draws the field and handles its keys: Enter applies, Esc leaves, the arrows go through the names.
void drawEntry(Shell &context, const Document &document) {
    Naming &naming = context.naming;
    if (naming.frames++ == 0) {
        context.widgets.fields.request("naming/name");
    }
    if (naming.other) {
        drawThings(context, document);
    }
    ui::small(context, naming.thing->title(document));
    const std::string before = naming.text;
    const bool entered = ui::inputText(context, "naming/name", naming.text,
                                       naming.thing->kind == NamedThing::Kind::Source ? "name" : "name or tag",
                                       static_cast<float>(kNameWidth), true, false, true);
    if (naming.text != before) {
        naming.edited = true;
        naming.choice = -1;
        naming.fault.clear();
        context.animate();
    }
    if (!naming.fault.empty()) {
        ui::faultText(context, naming.fault);
        ui::mark(context, "naming/fault");
    }
    const std::vector<std::string> names = offeredNames(naming, document);
    const int count = static_cast<int>(names.size());
    const int step = (imgui::keyPressed(key::kDown) ? 1 : 0) - (imgui::keyPressed(key::kUp) ? 1 : 0);
    naming.choice = std::clamp(naming.choice + step, -1, count - 1);
    if (imgui::keyPressed(key::kEscape, false)) {
        naming.close();
    } else if (entered) {
        finish(context, naming.choice >= 0 ? names[static_cast<std::size_t>(naming.choice)] : naming.text);
    } else {
        if (usedElsewhere(document, *naming.thing) &&
            ui::checkbox(context, "naming/everywhere", "All parts with this tag", naming.everywhere)) {
            context.widgets.fields.request("naming/name");
        }
        drawNames(context, names);
    }
}

} // namespace

void drawNameField(Shell &context, const PixelRect &canvas) {
    Naming &naming = context.naming;
    if (!naming.thing || naming.inPanel) {
        return;
    }
    if (context.dialogs.any() || naming.revision != context.document.revision()) {
        naming.close(); // what is named may be gone
        return;
    }
    const std::shared_ptr<const Document> document = context.document.current();
    const auto *const last = context.widgets.find("naming");
    const double width = last != nullptr ? last->rect.width : static_cast<double>(context.px(kNameWidth + 24.0));
    const double height = last != nullptr ? last->rect.height : static_cast<double>(context.px(120.0));
    const auto within = [](double at, double low, double room, double size) {
        return static_cast<float>(std::clamp(at, low, std::max(low, low + room - size)));
    };
    const double gap = static_cast<double>(context.px(12.0));
    ImGui::SetNextWindowPos({within(naming.at.x + gap, canvas.x, canvas.width, width),
                             within(naming.at.y + gap, canvas.y, canvas.height, height)});
    {
        const ui::PopupStyle style(context, 12, 10, 8);
        ImGui::Begin("##naming", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoNav | ImGuiWindowFlags_AlwaysAutoResize);
    }
    ui::markWindow(context, "naming");
    const bool elsewhere =
        naming.frames > 1 && !ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows) &&
        (ImGui::IsMouseClicked(ImGuiMouseButton_Left) || ImGui::IsMouseClicked(ImGuiMouseButton_Right));
    if (elsewhere && naming.edited) {
        finish(context, naming.text); // as in every other field
    } else if (elsewhere) {
        naming.close();
    } else {
        drawEntry(context, *document);
    }
    ImGui::End();
}

} // namespace forefront::shell
