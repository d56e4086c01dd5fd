#include "ui/shell/command_palette.hpp"

#include "core/engine/base/letter_case.hpp"
#include "ui/parts/shell.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

namespace forefront {

namespace {

/// Returns true if every word of the query occurs in the text.
bool matches(const std::string &text, const std::string &query) {
    const std::string low = lowerCase(text);
    for (std::size_t at = 0; at < query.size();) {
        const std::size_t end = std::min(query.find(' ', at), query.size());
        if (low.find(query.substr(at, end - at)) == std::string::npos) {
            return false;
        }
        at = end + 1;
    }
    return true;
}

class Palette final : public Dialog {
  public:
    const char *id() const override { return "palette"; }
    std::string title() const override { return "Command palette"; }
    float width() const override { return 520.0F; }
    float height() const override { return 440.0F; }

    bool draw(Shell &context) override {
        ui::inputText(context, "palette/query", query_, "Type a command", -1.0F, false, first_);
        first_ = false;
        const std::vector<const Action *> found = search(context);
        move(static_cast<int>(found.size()));
        const Action *run = nullptr;
        ImGui::BeginChild("found", {0, 0}, false, ImGuiWindowFlags_NoNav);
        if (found.empty()) {
            ui::small(context, "No command available now matches '" + query_ + "'", true);
            ui::mark(context, "palette/none");
        }
        for (std::size_t i = 0; i < found.size(); ++i) {
            const Action &action = *found[i];
            const std::string title = action.dynamic ? action.dynamic(context) : action.title;
            const std::string label = action.menu.empty() ? title : action.menu + "  \xe2\x80\xba  " + title;
            const std::string keys = action.shortcuts.empty() ? "" : toString(action.shortcuts.front());
            const bool chosen = static_cast<int>(i) == chosen_;
            if (ui::selectable(context, "palette/" + action.id, label, chosen, keys)) {
                run = &action;
            }
            if (chosen && moved_) {
                ImGui::SetScrollHereY();
            }
        }
        ImGui::EndChild();
        if (ui::enterPressed() && chosen_ < static_cast<int>(found.size())) {
            run = found[static_cast<std::size_t>(chosen_)];
        }
        if (run == nullptr) {
            return true;
        }
        run->run(context);
        return false;
    }

  private:
    std::vector<const Action *> search(const Shell &context) const {
        std::vector<const Action *> found;
        const std::string query = lowerCase(query_);
        for (const Action &action : context.actions.all()) {
            const bool enabled = !action.enabled || action.enabled(context);
            if (enabled && action.run && action.id != "view.palette" &&
                matches(action.menu + " " + action.title, query)) {
                found.push_back(&action);
            }
        }
        return found;
    }

    void move(int count) {
        const int before = chosen_;
        chosen_ += imgui::keyPressed(key::kDown) ? 1 : 0;
        chosen_ -= imgui::keyPressed(key::kUp) ? 1 : 0;
        chosen_ = std::clamp(chosen_, 0, std::max(0, count - 1));
        moved_ = chosen_ != before;
    }

    std::string query_;
    int chosen_ = 0;
    bool first_ = true, moved_ = false;
};

} // namespace

std::unique_ptr<Dialog> makePalette() {
    return std::make_unique<Palette>();
}

} // namespace forefront
